#include "assessment/effect_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "simulator/base/progress.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::assessment {
namespace {

using simulator::body_celsius;
using simulator::Bone;
using simulator::HeatSummary;
using tests::blade_down;
using tests::SimulationRun;

constexpr double top_mm = 4.0;
constexpr std::size_t stretch = 50;

Bone block() { return tests::cortical_bone(tests::solid_block({30.0, 8.0, 12.0})); }

/// A dry saw is pushed into cortex and leans on it for two seconds, then rests in the air for one.
void saw_and_rest(SimulationRun& run) {
  run.glide(blade_down({0.0, top_mm + 1.0, 0.0}), 10);
  run.glide(blade_down({0.0, top_mm - 8.0, 0.0}), 200);
  run.hold(2000);
  run.switches = 0;
  run.glide(blade_down({0.0, top_mm + 3.0, 0.0}), 100);
  run.hold(1000);
}

EffectTrack track_of(const Bone& bone, const SimulationRun& run, const Progress& progress = {},
                     double sharpness = 1.0) {
  return track_effects(bone, simulator::Saw{.sharpness = sharpness}, false, run.recording(),
                       stretch, progress);
}

TEST(EffectTrack, ComesToTheBitToWhatTheStepFollowed) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}));
  saw_and_rest(run);
  const HeatSummary followed = track_of(bone, run).heat;
  const HeatSummary& live = run.simulation().effects().heat().summary();
  EXPECT_GT(live.hottest_celsius, body_celsius + 5.0);
  EXPECT_EQ(followed.hottest_celsius, live.hottest_celsius);
  EXPECT_EQ(followed.hottest_kerf, live.hottest_kerf);
  EXPECT_EQ(followed.hottest_place_mm, live.hottest_place_mm);
  EXPECT_EQ(followed.hot_s, live.hot_s);
  EXPECT_EQ(followed.greatest_dose_min, live.greatest_dose_min);
  EXPECT_EQ(followed.necrotic_mm3, live.necrotic_mm3);
}

TEST(EffectTrack, OfADullBladeRubsAsItDidInTheStep) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}), simulator::Saw{.sharpness = 0.5});
  run.glide(blade_down({0.0, top_mm - 8.0, 0.0}), 200);
  run.hold(5000);
  const HeatSummary& live = run.simulation().effects().heat().summary();
  EXPECT_GT(live.hottest_celsius, body_celsius + 5.0);
  EXPECT_EQ(track_of(bone, run, {}, 0.5).heat.hottest_celsius, live.hottest_celsius);
  EXPECT_LT(track_of(bone, run).heat.hottest_celsius, live.hottest_celsius);
}

TEST(EffectTrack, RisesWhileTheSawRubsAndFallsWhileItRests) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}));
  saw_and_rest(run);
  const EffectTrack track = track_of(bone, run);
  ASSERT_EQ(track.hottest_celsius.size(), (run.recording().samples.size() + stretch - 1) / stretch);
  EXPECT_EQ(track.hottest_celsius.front(), body_celsius);
  const auto hottest = std::max_element(track.hottest_celsius.begin(), track.hottest_celsius.end());
  EXPECT_NEAR(*hottest, track.heat.hottest_celsius, 1.0);
  EXPECT_LE(*hottest, track.heat.hottest_celsius);
  EXPECT_TRUE(std::is_sorted(hottest, track.hottest_celsius.end(), std::greater<>()));
  EXPECT_LT(track.hottest_celsius.back() - body_celsius, 0.9 * (*hottest - body_celsius));
}

TEST(EffectTrack, KnowsHowFarTheBladeBent) {
  const Bone bone = block();
  SimulationRun straight(bone, blade_down({0.0, top_mm + 1.0, 0.0}));
  straight.glide(blade_down({0.0, top_mm - 8.0, 0.0}), 1500);
  SimulationRun aside(bone, blade_down({0.0, top_mm + 1.0, 0.0}));
  aside.glide(blade_down({0.0, top_mm - 8.0, 0.0}), 1500);
  double greatest_mm = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double aside_mm = 0.01 * i;
    const simulator::StepOutput output = aside.glide(blade_down({aside_mm, top_mm - 8.0, 0.0}), 1);
    greatest_mm = std::max(greatest_mm, std::abs(output.flex.deflection_mm));
  }
  EXPECT_GT(greatest_mm, 0.01);
  EXPECT_GE(track_of(bone, aside).greatest_deflection_mm, greatest_mm);
  EXPECT_LT(track_of(bone, straight).greatest_deflection_mm, 0.5 * greatest_mm);
}

TEST(EffectTrack, OfAGuidedHandKnowsABendInAKerfOnly) {
  const Bone bone = block();
  simulator::ContactSettings guided;
  guided.guide = {simulator::Guidance::Slot, {simulator::GuidePlane{Vec3(1.0, 0.0, 0.0), -5.0}}};
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}), {}, guided);
  run.hold(600);
  run.glide(blade_down({0.0, top_mm - 8.0, 0.0}), 1500);
  const auto greatest_mm = [&](bool is_guided) {
    return track_effects(bone, {}, is_guided, run.recording(), stretch).greatest_deflection_mm;
  };
  EXPECT_LT(greatest_mm(true), 0.02);
  EXPECT_GT(greatest_mm(false), 0.5) << "the guide pushed the hand, as the blade stood on bone";
}

TEST(EffectTrack, OfNothingIsEmpty) {
  const Bone bone = block();
  const EffectTrack track = track_effects(bone, {}, false, {}, stretch);
  EXPECT_TRUE(track.hottest_celsius.empty());
  EXPECT_EQ(track.heat.hottest_celsius, body_celsius);
}

TEST(EffectTrack, CanBeCancelled) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}));
  EXPECT_THROW(track_of(bone, run, [](double) { return false; }), Cancelled);
}

}  // namespace
}  // namespace hallux::assessment

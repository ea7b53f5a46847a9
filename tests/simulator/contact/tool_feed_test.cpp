/// The feed law through the whole step: blocks of known tissue under a constant push, and what
/// friction and break-through make of it.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::SimulationRun;

constexpr double top_mm = 10.0;
constexpr double coupling_newton_per_mm = 2.0;

/// A hand that feels its push and keeps it: the handle leads the teeth by the stretch.
void push_for(SimulationRun& run, double force_newton, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    const double tip_mm = run.bone_from_tool().translation_mm.y;
    run.glide(blade_down({0.0, tip_mm - force_newton / coupling_newton_per_mm, 0.0}), 1);
  }
}

struct Feed {
  double rate_mm_s = 0.0;
  Engagement engaged;
  double hottest_celsius = 0.0;
};

/// The rate over a while under the push, begun `first_mm` below the top.
Feed feed_under(const Bone& bone, double force_newton, double first_mm, int ticks,
                const Saw& saw = {}, const ContactSettings& settings = {}) {
  SimulationRun run(bone, blade_down({0.0, top_mm + 0.5, 0.0}), saw, settings);
  while (run.bone_from_tool().translation_mm.y > top_mm - first_mm &&
         run.recording().tape.size() < 30000) {
    push_for(run, 20.0, 1);
  }
  push_for(run, force_newton, 50);
  const double before_mm = run.bone_from_tool().translation_mm.y;
  push_for(run, force_newton, ticks - 1);
  const double tip_mm = run.bone_from_tool().translation_mm.y;
  const StepOutput output =
      run.glide(blade_down({0.0, tip_mm - force_newton / coupling_newton_per_mm, 0.0}), 1);
  const double way_mm = before_mm - run.bone_from_tool().translation_mm.y;
  return {way_mm / (0.001 * ticks), output.engaged,
          run.simulation().effects().heat().summary().hottest_celsius};
}

Bone block(double width_mm) {
  return tests::cortical_bone(tests::solid_block({40.0, 20.0, width_mm}));
}

TEST(FeedOnABlock, OfCorticalBoneIsTheLaws) {
  const Feed feed = feed_under(block(30.0), 10.0, 0.5, 3000);
  EXPECT_NEAR(feed.rate_mm_s, 0.35 * (10.0 - 1.5) / 10.0, 0.02 * 0.2975);
}

TEST(FeedOnABlock, OfCancellousBoneIsTheLaws) {
  const Bone bone = tests::cancellous_bone(tests::solid_block({40.0, 20.0, 30.0}));
  const Feed feed = feed_under(bone, 10.0, 0.5, 2000);
  EXPECT_NEAR(feed.rate_mm_s, 2.0 * (10.0 - 0.3) / 10.0, 0.02 * 1.94);
}

TEST(FeedOnABlock, OfMixedBoneAddsTheForcesUp) {
  // 8 mm of bone below a blade of 10: 2 mm of cortex at each side, 4 mm of cancellous bone between.
  Bone bone = block(8.0);
  bone.cortex = CortexLaw{.mid_mm = 2.0, .floor_mm = 2.0};
  const Feed feed = feed_under(bone, 10.0, 3.0, 2000);
  const double tooth_mm = 10.0 / static_cast<double>(tooth_count);
  EXPECT_NEAR(feed.engaged.cortical_mm, 4.0, 1.01 * tooth_mm);
  EXPECT_NEAR(feed.engaged.cancellous_mm, 4.0, 1.01 * tooth_mm);
  const double mean_newton =
      (1.5 * feed.engaged.cortical_mm + 0.3 * feed.engaged.cancellous_mm) / feed.engaged.width_mm();
  const double law_mm_s =
      (10.0 - mean_newton) / (feed.engaged.cortical_mm / 0.35 + feed.engaged.cancellous_mm / 2.0);
  EXPECT_NEAR(feed.rate_mm_s, law_mm_s, 0.02 * law_mm_s);
}

TEST(FeedOnABlock, StandsStillBelowTheThreshold) {
  EXPECT_NEAR(feed_under(block(30.0), 1.4, 0.5, 500).rate_mm_s, 0.0, 0.003);
}

TEST(FeedOnABlock, ADullBladeIsSlowerAndHotterForTheSameWay) {
  const Feed sharp = feed_under(block(30.0), 10.0, 0.5, 2000);
  const Feed dull = feed_under(block(30.0), 10.0, 0.5, 4000, {.sharpness = 0.5});
  EXPECT_NEAR(dull.rate_mm_s, 0.5 * sharp.rate_mm_s, 0.02 * sharp.rate_mm_s);
  EXPECT_GT(dull.hottest_celsius, sharp.hottest_celsius + 10.0);
}

TEST(FeedOnABlock, OfSoftAndOfHardBoneIsTheLaws) {
  for (const double quality : {0.5, 1.5}) {
    const double law_mm_s = 0.35 / quality * (10.0 - quality * 1.5) / 10.0;
    const Feed feed = feed_under(block(30.0), 10.0, 0.5, 2000, {}, {.bone_quality = quality});
    EXPECT_NEAR(feed.rate_mm_s, law_mm_s, 0.02 * law_mm_s) << quality;
  }
}

TEST(FeedOnABlock, TooWideABladeIsSlower) {
  const Feed narrow = feed_under(block(30.0), 10.0, 0.5, 2000, {.blade = {.width_mm = 7.0}});
  const Feed wide = feed_under(block(30.0), 10.0, 0.5, 2000, {.blade = {.width_mm = 12.0}});
  EXPECT_NEAR(wide.rate_mm_s / narrow.rate_mm_s, 7.0 / 12.0, 0.02);
}

TEST(FeedOnABlock, APushAgainstTheWallCostsItsFriction) {
  const Bone bone = tests::cancellous_bone(tests::solid_block({40.0, 20.0, 30.0}));
  const auto way_mm = [&](double aside_mm) {
    SimulationRun run(bone, blade_down({0.0, top_mm + 0.5, 0.0}));
    while (run.bone_from_tool().translation_mm.y > top_mm - 0.5) push_for(run, 10.0, 1);
    run.glide(blade_down({aside_mm, top_mm - 6.0, 0.0}), 100);
    const double before_mm = run.bone_from_tool().translation_mm.y;
    run.hold(300);
    return before_mm - run.bone_from_tool().translation_mm.y;
  };
  EXPECT_GT(way_mm(0.0), 1.05 * way_mm(4.0));
}

TEST(BladeInItsSlot, IsHeldByFrictionWhereItIsPressedAgainstAWall) {
  const Bone bone = tests::cancellous_bone(tests::solid_block({40.0, 20.0, 30.0}));
  SimulationRun run(bone, blade_down({0.0, top_mm + 0.5, 0.0}));
  run.glide(blade_down({0.0, top_mm - 9.0, 0.0}), 4000);
  run.switches = 0;
  const double tip_mm = run.bone_from_tool().translation_mm.y;
  run.glide(blade_down({0.0, tip_mm, 0.0}), 100);
  run.glide(blade_down({1.3, tip_mm, 0.0}), 100);
  // Out of the plane the spring is stretched by 1.2 x 10 / 12 = 1 mm: it holds a pull of 0.3 mm.
  run.glide(blade_down({1.3, tip_mm + 0.28, 0.0}), 100);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.y, tip_mm, 0.002);
  EXPECT_NEAR(run.force_in_bone_newton().y, -0.56, 0.01);
  run.glide(blade_down({1.3, tip_mm + 2.0, 0.0}), 100);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.y, tip_mm + 2.0 - 0.18, 0.005);
  EXPECT_NEAR(run.force_in_bone_newton().y, -0.36, 0.01);
}

TEST(BladeInItsSlot, TurnsTheHandBackIntoItsPlane) {
  const Bone bone = tests::cancellous_bone(tests::solid_block({40.0, 20.0, 30.0}));
  SimulationRun run(bone, blade_down({0.0, top_mm + 0.5, 0.0}));
  run.glide(blade_down({0.0, top_mm - 9.0, 0.0}), 3000);
  const double tip_mm = run.bone_from_tool().translation_mm.y;
  const auto torque_newton_mm = [&](double lean_rad) {
    const StepOutput output = run.glide(blade_down({0.0, tip_mm - 2.0, 0.0}, lean_rad), 100);
    return transform_direction(inverse(bone.world_from_bone), output.torque_in_world_newton_mm);
  };
  EXPECT_NEAR(torque_newton_mm(0.008).y, 0.0, 0.5);  // within the play
  // Beyond it nine tenths of the lean are the grip's; leaning is about the feed, -y.
  EXPECT_NEAR(torque_newton_mm(0.05).y, 4000.0 * 0.9 * (0.05 - 0.0087), 4.0);
  const Vec3 most = torque_newton_mm(0.5);
  EXPECT_NEAR(std::sqrt(glm::dot(most, most)), 500.0, 1e-6);
}

TEST(BreakThrough, LetsTheBladeGoAtTwoTenthsOfAMetreASecond) {
  const Bone bone = tests::cancellous_bone(tests::moved(
      tests::solid_block({40.0, 4.0, 6.0}), {{1.0, 0.0, 0.0, 0.0}, {0.0, top_mm - 2.0, 0.0}}));
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}));
  run.glide(blade_down({0.0, top_mm - 9.0, 0.0}), 300);
  while (run.events(CutEventKind::Breakthrough).empty() && run.recording().tape.size() < 4000)
    run.hold(1);
  const double first_mm = run.bone_from_tool().translation_mm.y;
  const double stretch_mm = first_mm - (top_mm - 9.0);
  ASSERT_GT(stretch_mm, 3.0);
  double last_mm = first_mm;
  int ticks = 0;
  while (last_mm > top_mm - 9.0 + 0.002 && ticks < 100) {
    run.hold(1);
    const double tip_mm = run.bone_from_tool().translation_mm.y;
    EXPECT_LE(last_mm - tip_mm, 0.2 + 0.002);  // the record is rounded to a micrometre
    last_mm = tip_mm;
    ++ticks;
  }
  // The whole stretch is plunged through: gently, and felt as a force that falls.
  EXPECT_NEAR(ticks, stretch_mm / 0.2, 2.0);
}

}  // namespace
}  // namespace hallux::simulator

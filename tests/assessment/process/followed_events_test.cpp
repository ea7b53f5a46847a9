/// Effects that are followed again, against those that the step followed.
#include <gtest/gtest.h>

#include <span>

#include <algorithm>

#include "assessment/process/followed_effects.h"
#include "assessment/rebuild/open_kerfs.h"
#include "simulator/base/units.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::assessment {
namespace {

using simulator::CutEvent;
using simulator::CutEventKind;
using tests::blade_down;
using tests::SimulationRun;

constexpr double top_mm = 4.0;

/// Beside the block, where a blade that is 10 mm wide stands out of it; in the middle of it; and
/// nowhere near.
std::vector<simulator::DangerCapsule> zones() {
  return {{Vec3{-20.0, 2.0, 8.0}, Vec3{20.0, 2.0, 8.0}, 0.5},
          {Vec3{-20.0, 0.0, 0.0}, Vec3{20.0, 0.0, 0.0}, 2.0},
          {Vec3{-20.0, 60.0, 0.0}, Vec3{20.0, 60.0, 0.0}, 2.0}};
}

/// A dry saw leans on hard bone until it is hot, goes on through both zones, and rests.
void saw_hard(SimulationRun& run) {
  run.glide(blade_down({0.0, top_mm + 1.0, 3.0}), 10);
  run.glide(blade_down({0.0, top_mm - 8.0, 3.0}), 200);
  run.hold(2500);
  run.glide(blade_down({0.0, top_mm - 20.0, 3.0}), 800);
  run.hold(3000);
  run.switches = 0;
  run.glide(blade_down({0.0, top_mm + 20.0, 3.0}), 400);
  run.hold(300);
}

TEST(FollowedEvents, AreThoseOfTheStep) {
  const simulator::Bone bone = tests::cortical_bone(tests::solid_block({30.0, 8.0, 12.0}));
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 3.0}), {}, {}, zones());
  saw_hard(run);
  scenarios::Plan plan;
  for (const simulator::DangerCapsule& capsule : zones())
    plan.danger_zones.push_back({"", capsule});
  const simulator::Saw saw;
  FollowedEffects effects(bone, saw, plan);
  simulator::KerfSet kerfs(saw.blade, bone.world_from_bone);
  open_kerfs(
      kerfs, run.recording(), [](std::int64_t) {},
      [&](std::size_t index, std::span<const simulator::RisenKerf>) {
        effects.follow(run.recording().samples[index], kerfs);
      });

  const auto live = run.simulation().effects().danger().tracks();
  for (std::size_t zone = 0; zone < live.size(); ++zone) {
    EXPECT_EQ(effects.zone(zone).contacts, live[zone].contacts) << zone;
    EXPECT_EQ(effects.zone(zone).contact_s, live[zone].contact_s);
    EXPECT_EQ(effects.zone(zone).least_mm, live[zone].least_mm);
  }
  std::int32_t told = 0;
  for (const CutEvent& event : run.events(CutEventKind::DangerContact)) {
    ++told;
    const ZoneContacts contacts = effects.contacts(static_cast<std::size_t>(event.subject)).value();
    EXPECT_LE(contacts.first_tick, event.tick);
    EXPECT_LE(event.tick, contacts.last_tick);
  }
  const CutEvent first = run.events(CutEventKind::DangerContact).at(0);
  const auto index = static_cast<std::size_t>(first.subject);
  EXPECT_EQ(effects.contacts(index)->first_tick, first.tick);
  EXPECT_EQ(effects.contacts(index)->place_in_bone_mm, transform_from(first.pose).translation_mm);
  EXPECT_EQ(told, live[0].contacts + live[1].contacts);
  EXPECT_GE(told, 2) << "this attempt touches both";
  EXPECT_FALSE(effects.contacts(2));

  const std::vector<CutEvent> hot = run.events(CutEventKind::BoneHot);
  ASSERT_FALSE(hot.empty()) << "this attempt burns";
  EXPECT_EQ(effects.hot()->tick, hot[0].tick);
  EXPECT_EQ(effects.hot()->place_in_bone_mm, transform_from(hot[0].pose).translation_mm);
  EXPECT_EQ(effects.heat().hot_s, run.simulation().effects().heat().summary().hot_s);
}

}  // namespace
}  // namespace hallux::assessment

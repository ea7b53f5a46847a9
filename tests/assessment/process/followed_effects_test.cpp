#include "assessment/process/followed_effects.h"

#include <gtest/gtest.h>

#include "tests/assessment/block_attempt.h"
#include "tests/assessment/process/made_recording.h"

namespace hallux::assessment {
namespace {

using simulator::Recording;
using testing::add_line;
using testing::add_lines;

constexpr double exact = 1e-6;
constexpr std::uint32_t saws = testing::running | testing::saw_on;

/// Two zones above the block, across the blade's way: at x = 10 and x = 50 of the bone, 2 mm thick.
scenarios::Plan two_zones() {
  scenarios::Plan plan;
  for (const double x_mm : {10.0, 50.0}) {
    plan.danger_zones.push_back(
        {x_mm < 30.0 ? "near" : "far", {Vec3{x_mm, 20.0, -50.0}, Vec3{x_mm, 20.0, 50.0}, 2.0}});
  }
  return plan;
}

/// A blade 8 mm wide whose flat lies along the zones and that is fed towards them, teeth at x.
struct Work {
  simulator::Bone bone = testing::block_bone();
  simulator::Saw saw{.blade = {8.0, 5.0, testing::kerf_mm, 0.4}};
  Recording recording;

  testing::MadeLine at(double x_mm, std::uint32_t status = saws) const {
    const RigidTransform bone_from_tool{Quat{1.0, 0.0, 0.0, 0.0}, Vec3{x_mm, 20.0, 0.0}};
    const RigidTransform pose = bone.world_from_bone * bone_from_tool;
    return {.status = status, .tip_mm = pose.translation_mm, .rotation = pose.rotation};
  }
  FollowedEffects followed() const {
    FollowedEffects effects(bone, saw, two_zones());
    const simulator::KerfSet kerfs(saw.blade, bone.world_from_bone);
    for (const simulator::ToolSample& sample : recording.samples) effects.follow(sample, kerfs);
    return effects;
  }
};

TEST(FollowedEffects, AZoneThatIsCrossedIsTouchedAtItsTimeAndDepth) {
  Work work;
  // From 5 mm before the zone's middle to 1 mm before it, 0.01 mm a tick, and back.
  for (int tick = 0; tick <= 400; ++tick) add_line(work.recording, work.at(5.0 + 0.01 * tick));
  for (int tick = 399; tick >= 0; --tick) add_line(work.recording, work.at(5.0 + 0.01 * tick));
  add_lines(work.recording, work.at(5.0), 200);
  const FollowedEffects effects = work.followed();
  const simulator::DangerTrack& track = effects.zone(0);
  EXPECT_EQ(track.contacts, 1);
  // Half a kerf thick: touched from x = 7.75 on, 275 ticks in; 1.25 mm deep at x = 9.
  EXPECT_NEAR(track.least_mm, -1.25, 2e-3);
  EXPECT_NEAR(track.contact_s, 0.251, 2e-3);
  const ZoneContacts contacts = effects.contacts(0).value();
  EXPECT_NEAR(static_cast<double>(contacts.first_tick), 275.0, 1.0);
  // Over once it was half a millimetre away for 0.2 s.
  EXPECT_NEAR(static_cast<double>(contacts.last_tick), 400.0 + 125.0 + 50.0 + 200.0, 2.0);
  EXPECT_NEAR(contacts.place_in_bone_mm.x, 7.75, 0.02);
  EXPECT_NEAR(contacts.place_in_bone_mm.y, 20.0, 2e-3);
  EXPECT_FALSE(effects.contacts(1)) << "the other zone is far away";
  EXPECT_EQ(effects.zone(1).contacts, 0);
}

TEST(FollowedEffects, ASawThatRestsTouchesNothing) {
  for (const std::uint32_t status : {testing::running, testing::saw_on}) {
    Work work;
    add_lines(work.recording, work.at(10.0, status), 100);
    EXPECT_FALSE(work.followed().contacts(0)) << status;
    EXPECT_EQ(work.followed().zone(0).contact_s, 0.0);
  }
}

TEST(FollowedEffects, EachContactCountsAndTheFirstIsItsPlace) {
  Work work;
  for (const double x_mm : {9.0, 5.0, 8.0, 5.0}) add_lines(work.recording, work.at(x_mm), 300);
  const FollowedEffects effects = work.followed();
  EXPECT_EQ(effects.zone(0).contacts, 2);
  EXPECT_NEAR(effects.zone(0).contact_s, 0.6, 2e-3);
  EXPECT_NEAR(effects.contacts(0)->place_in_bone_mm.x, 9.0, 2e-3);
  EXPECT_EQ(effects.contacts(0)->first_tick, 0);
  EXPECT_NEAR(static_cast<double>(effects.contacts(0)->last_tick), 900.0 + 198.0, 1.0);
}

TEST(FollowedEffects, AContactThatIsNotOverLastsToTheEnd) {
  Work work;
  add_lines(work.recording, work.at(5.0), 100);
  add_lines(work.recording, work.at(9.0), 400);
  EXPECT_EQ(work.followed().contacts(0)->first_tick, 100);
  EXPECT_EQ(work.followed().contacts(0)->last_tick, 499);
}

TEST(FollowedEffects, WithoutZonesAndSawingNothingHappens) {
  const simulator::Bone bone = testing::block_bone();
  FollowedEffects effects(bone, {}, {});
  EXPECT_FALSE(effects.hot());
  EXPECT_FALSE(effects.dead());
  EXPECT_EQ(effects.heat().hot_s, 0.0);
}

}  // namespace
}  // namespace hallux::assessment

#include "simulator/device/mouse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "simulator/base/units.h"
#include "simulator/record/record.h"

namespace hallux::simulator {
namespace {

constexpr auto saw = static_cast<std::uint32_t>(Switch::SawRuns);
const RigidTransform at_origin;
const Quat looking_down_z(1.0, 0.0, 0.0, 0.0);

RigidTransform at(const Vec3& place_mm) { return {{1.0, 0.0, 0.0, 0.0}, place_mm}; }

/// Ticks of one millisecond each, with a force that depends on where the hand is.
template <typename Force>
RawDeviceState exchanged(MouseDevice& device, std::int64_t ticks, Force&& force) {
  RawDeviceState state;
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    EXPECT_TRUE(device.exchange(force(state.world_from_handle.translation_mm), tick, state));
  }
  return state;
}

const auto no_force = [](const Vec3&) { return Vec3(0.0, 0.0, 0.0); };

TEST(MouseDevice, IsOfTheMouseClass) {
  EXPECT_EQ(MouseDevice(at_origin).description().device_class, "mouse");
}

TEST(MouseDevice, ComesToWhereItIsLedWithoutGoingBeyond) {
  MouseDevice device(at_origin);
  device.aim({at({10.0, 0.0, 0.0}), saw, {}});
  RawDeviceState state;
  double farthest_mm = 0.0;
  for (std::int64_t tick = 0; tick < 400; ++tick) {
    ASSERT_TRUE(device.exchange({0.0, 0.0, 0.0}, tick, state));
    farthest_mm = std::max(farthest_mm, state.world_from_handle.translation_mm.x);
  }
  EXPECT_NEAR(state.world_from_handle.translation_mm.x, 10.0, 1.0e-3);
  EXPECT_LE(farthest_mm, 10.0 + 0.05) << "critically damped, but for the steps of a millisecond";
  EXPECT_EQ(state.switches, saw);
}

TEST(MouseDevice, ASawThatNobodyLeadsAnyMoreStops) {
  MouseDevice device(at_origin);
  RawDeviceState state;
  std::int64_t tick = 0;
  const auto exchanged_until = [&](std::int64_t end) {
    for (; tick < end; ++tick) ASSERT_TRUE(device.exchange({0.0, 0.0, 0.0}, tick, state));
  };
  exchanged_until(5000);
  for (int frame = 0; frame < 20; ++frame) {
    device.aim({at({1.0, 0.0, 0.0}), saw, {}});
    exchanged_until(tick + 200);
    EXPECT_EQ(state.switches, saw) << "led in each frame, it runs as long as one likes";
  }
  exchanged_until(tick + MouseDevice::silence_ticks - 200);
  EXPECT_EQ(state.switches, saw);
  exchanged_until(tick + 202);
  EXPECT_EQ(state.switches, 0U);
  EXPECT_NEAR(state.world_from_handle.translation_mm.x, 1.0, 1.0e-3) << "it stays where it was";
  device.aim({at({1.0, 0.0, 0.0}), saw, {}});
  exchanged_until(tick + 1);
  EXPECT_EQ(state.switches, saw);
}

TEST(MouseDevice, AStepOfThePointerIsNoStepOfTheHand) {
  MouseDevice device(at_origin);
  device.aim({at({60.0, 0.0, 0.0}), 0, {}});
  RawDeviceState state;
  Vec3 before_mm(0.0, 0.0, 0.0);
  for (std::int64_t tick = 0; tick < 500; ++tick) {
    ASSERT_TRUE(device.exchange({0.0, 0.0, 0.0}, tick, state));
    const double way_mm = std::abs(state.world_from_handle.translation_mm.x - before_mm.x);
    EXPECT_LE(way_mm, 0.8 + 1.0e-9) << "the speed limit";
    before_mm = state.world_from_handle.translation_mm;
  }
}

TEST(MouseDevice, BoneHoldsTheHandAndThePointerRunsAhead) {
  // A wall of 2 N/mm at x = 0, as the contact's spring is; the pointer 15 mm behind it.
  MouseDevice device(at_origin);
  device.aim({at({15.0, 0.0, 0.0}), 0, {}});
  const auto wall = [](const Vec3& hand_mm) {
    return Vec3(-2.0 * std::max(0.0, hand_mm.x), 0.0, 0.0);
  };
  const RawDeviceState state = exchanged(device, 1000, wall);
  // Two springs in line: 15 mm over 1 and 2 N/mm is 10 N, and the hand lies 5 mm behind the wall.
  EXPECT_NEAR(state.world_from_handle.translation_mm.x, 5.0, 0.01);
}

TEST(MouseDevice, StaysCalmOnTheStiffestSlot) {
  // 10 N/mm, the stiffness of a slot, with the force of the tick before.
  MouseDevice device(at_origin);
  device.aim({at({15.0, 0.0, 0.0}), 0, {}});
  const auto wall = [](const Vec3& hand_mm) {
    return Vec3(-10.0 * std::max(0.0, hand_mm.x), 0.0, 0.0);
  };
  exchanged(device, 2000, wall);
  RawDeviceState state;
  double least_mm = 1.0e9, most_mm = -1.0e9;
  for (std::int64_t tick = 2000; tick < 2500; ++tick) {
    ASSERT_TRUE(device.exchange(wall(state.world_from_handle.translation_mm), tick, state));
    if (tick < 2300) continue;  // the first of these began without a force
    least_mm = std::min(least_mm, state.world_from_handle.translation_mm.x);
    most_mm = std::max(most_mm, state.world_from_handle.translation_mm.x);
  }
  EXPECT_LT(most_mm - least_mm, 0.01) << "it must not sing";
}

TEST(MouseDevice, TurnsToItsTarget) {
  MouseDevice device(at_origin);
  const Quat wanted = rotation_about(Vec3(0.0, 0.0, 1.0), 0.5);
  device.aim({{wanted, {0.0, 0.0, 0.0}}, 0, {}});
  const RawDeviceState state = exchanged(device, 500, no_force);
  EXPECT_GT(glm::dot(state.world_from_handle.rotation, wanted), 1.0 - 1.0e-9);
}

TEST(Steering, ThePointerMovesInTheViewPlaneAndTheWheelAcrossIt) {
  const Quat from_medial =
      rotation_about(Vec3(0.0, 1.0, 0.0), pi);  // the view's z is the world's -z
  const RigidTransform moved =
      steered(at_origin, from_medial, {.across_mm = Vec2(2.0, 3.0), .deeper_mm = 4.0});
  EXPECT_NEAR(moved.translation_mm.x, -2.0, 1.0e-12);
  EXPECT_NEAR(moved.translation_mm.y, 3.0, 1.0e-12);
  EXPECT_NEAR(moved.translation_mm.z, 4.0, 1.0e-12) << "away from the person";
}

TEST(Steering, ADragTurnsAboutTheMiddleOfTheTeeth) {
  const RigidTransform start = at({5.0, 6.0, 7.0});
  const RigidTransform turned = steered(start, looking_down_z, {.turned_rad = Vec2(0.0, 0.3)});
  EXPECT_EQ(turned.translation_mm, start.translation_mm);
  // Dragged up, what points to the person is raised towards the top.
  const Vec3 to_person = transform_direction(turned, Vec3(0.0, 0.0, 1.0));
  EXPECT_NEAR(to_person.y, std::sin(0.3), 1.0e-12);
}

TEST(Steering, ShiftIsAFifthOfEverything) {
  const PointerMotion motion{
      .across_mm = Vec2(10.0, 0.0), .deeper_mm = 5.0, .turned_rad = Vec2(0.5, 0.0)};
  PointerMotion fine = motion, fifth = motion;
  fine.is_fine = true;
  fifth.across_mm *= 0.2;
  fifth.deeper_mm *= 0.2;
  fifth.turned_rad *= 0.2;
  const RigidTransform a = steered(at_origin, looking_down_z, fine);
  const RigidTransform b = steered(at_origin, looking_down_z, fifth);
  EXPECT_EQ(a, b);
}

TEST(Steering, TheSawIsKeptNearTheSite) {
  const RigidTransform kept = kept_within(at({300.0, 0.0, 0.0}), Vec3(100.0, 0.0, 0.0), 90.0);
  EXPECT_NEAR(kept.translation_mm.x, 190.0, 1.0e-9);
  const RigidTransform inside = at({120.0, 0.0, 0.0});
  EXPECT_EQ(kept_within(inside, Vec3(100.0, 0.0, 0.0), 90.0), inside);
}

}  // namespace
}  // namespace hallux::simulator

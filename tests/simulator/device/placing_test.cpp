#include "simulator/device/placing.h"

#include <gtest/gtest.h>

#include "simulator/base/units.h"

namespace hallux::simulator {
namespace {

constexpr double rounding = 1.0e-12;

RigidTransform pose(const Vec3& place_mm, double turned_rad = 0.0) {
  return {rotation_about(Vec3{0.0, 0.0, 1.0}, turned_rad), place_mm};
}

void expect_near(const RigidTransform& a, const RigidTransform& b) {
  const RigidTransform off = inverse(a) * b;
  EXPECT_LT(length_of(off.translation_mm), rounding);
  EXPECT_LT(std::abs(off.rotation.x) + std::abs(off.rotation.y) + std::abs(off.rotation.z),
            rounding);
}

TEST(Placing, SettingDownMovesNothingWhereverTheHandIs) {
  Placing placing;
  const RigidTransform hand = pose({30.0, -4.0, 2.0}, 0.7), tool = pose({1.0, 2.0, 3.0}, -0.2);
  placing.set_down(hand, tool);
  expect_near(placing.place(hand), tool);
}

TEST(Placing, TheToolGoesTheHandsWay) {
  Placing placing;
  placing.set_down(pose({10.0, 0.0, 0.0}), pose({0.0, 5.0, 0.0}));
  expect_near(placing.place(pose({12.0, 1.0, 0.0}, 0.3)), pose({2.0, 6.0, 0.0}, 0.3));
}

TEST(Placing, ALiftedHandMovesWithoutTheToolAndIsSetDownWithoutAJump) {
  Placing placing;
  placing.set_down(pose({0.0, 0.0, 0.0}), pose({0.0, 0.0, 0.0}));
  placing.place(pose({3.0, 0.0, 0.0}));
  placing.lift();
  EXPECT_TRUE(placing.is_lifted());
  const RigidTransform there = pose({-40.0, 7.0, 0.0}, 1.0);
  expect_near(placing.place(there), pose({3.0, 0.0, 0.0}));
  placing.set_down(there, placing.place(there));
  expect_near(placing.place(there), pose({3.0, 0.0, 0.0}));
  expect_near(placing.place(pose({-39.0, 7.0, 0.0}, 1.0)), pose({4.0, 0.0, 0.0}));
}

TEST(Placing, TurnsAndScalesTheHandsWayByItsFrame) {
  Placing placing({rotation_about(Vec3{0.0, 0.0, 1.0}, radian_from_degree(90.0)), 0.5});
  placing.set_down(pose({0.0, 0.0, 0.0}), pose({0.0, 0.0, 0.0}));
  // The device's x is the world's y, and two millimetres are one; a turn about z stays one.
  expect_near(placing.place(pose({4.0, 0.0, 0.0}, 0.2)), pose({0.0, 2.0, 0.0}, 0.2));
}

}  // namespace
}  // namespace hallux::simulator

#include "simulator/contact/proxy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulator/step/simulation_run.h"

namespace hallux::simulator {
namespace {

constexpr double grip_mm = 40.0;
constexpr std::size_t face = contact_tooth_count;
const Vec3 up{0.0, 1.0, 0.0};

/// Again and again from the same pose, as a tool does that rests.
ProxyResult settled(const ProxyMotion& wanted, std::span<const BladeContact> contacts,
                    ProxyLoad& load, const ProxyFriction& friction = {.static_friction = 0.0}) {
  ProxyResult result;
  for (int i = 0; i < 200; ++i) result = solve_proxy(wanted, contacts, grip_mm, friction, load);
  return result;
}

TEST(Proxy, FollowsTheHandWhereNothingIsNear) {
  ProxyLoad load;
  const ProxyMotion wanted{{1.0, -2.0, 3.0}, {0.1, 0.0, -0.2}};
  const ProxyResult result = solve_proxy(wanted, {}, grip_mm, {}, load);
  EXPECT_EQ(result.motion.translation_mm, wanted.translation_mm);
  EXPECT_EQ(result.motion.rotation_rad, wanted.rotation_rad);
  EXPECT_EQ(result.normal_mm, 0.0);
}

TEST(Proxy, GoesToThePlaneAndSlidesOnIt) {
  ProxyLoad load;
  const BladeContact contact{face, {0.0, 0.0, 0.0}, up, 0.1};
  const ProxyResult result = settled({{1.0, -2.0, 3.0}, {}}, {&contact, 1}, load);
  EXPECT_NEAR(result.motion.translation_mm.x, 1.0, 1e-6);
  EXPECT_NEAR(result.motion.translation_mm.y, -0.1, 1e-6);
  EXPECT_NEAR(result.motion.translation_mm.z, 3.0, 1e-6);
  EXPECT_NEAR(result.normal_mm, 1.9, 1e-6);
}

TEST(Proxy, TwoPlanesLeaveALineAndThreeAPoint) {
  ProxyLoad load;
  const std::array<BladeContact, 3> contacts{
      BladeContact{face, {0.0, 0.0, 0.0}, up, 0.0},
      BladeContact{face + 1, {0.0, 0.0, 0.0}, Vec3{0.6, 0.8, 0.0}, 0.0},
      BladeContact{face + 2, {0.0, 0.0, 0.0}, Vec3{0.0, 0.6, -0.8}, 0.0}};
  // Against the sum of the three normals.
  const ProxyMotion wanted{{-0.6, -2.4, 0.8}, {}};
  const ProxyResult line = settled(wanted, {contacts.data(), 2}, load);
  EXPECT_NEAR(line.motion.translation_mm.x, 0.0, 1e-6);
  EXPECT_NEAR(line.motion.translation_mm.y, 0.0, 1e-6);
  EXPECT_NEAR(line.motion.translation_mm.z, 0.8, 1e-6);
  const ProxyResult corner = settled(wanted, contacts, load);
  EXPECT_NEAR(std::sqrt(glm::dot(corner.motion.translation_mm, corner.motion.translation_mm)), 0.0,
              1e-5);
}

TEST(Proxy, APushBesideTheOriginTurnsTheTool) {
  ProxyLoad load;
  const BladeContact contact{face, {0.0, 0.0, 10.0}, up, 0.0};
  const ProxyResult result = settled({{0.0, -1.0, 0.0}, {}}, {&contact, 1}, load);
  // The point stays; the least of way^2 + grip^2 turn^2 shares the millimetre as 1 to (10 / 40)^2.
  EXPECT_NEAR(result.normal_mm, 1.0 / (1.0 + 0.0625), 1e-6);
  EXPECT_NEAR(result.motion.rotation_rad.x, -result.normal_mm * 10.0 / 1600.0, 1e-6);
  const Vec3 at_point =
      result.motion.translation_mm + glm::cross(result.motion.rotation_rad, contact.arm_mm);
  EXPECT_NEAR(at_point.y, 0.0, 1e-6);
}

TEST(Proxy, AFaceThatIsInIsLedOutAndAToothIsNot) {
  ProxyLoad load;
  const BladeContact deep_face{face, {0.0, 0.0, 0.0}, up, -0.1};
  EXPECT_NEAR(settled({}, {&deep_face, 1}, load).motion.translation_mm.y, 0.1, 0.003);
  load = {};
  const BladeContact deep_tooth{0, {0.0, 0.0, 0.0}, up, -0.1, true};
  EXPECT_EQ(settled({}, {&deep_tooth, 1}, load).motion.translation_mm.y, 0.0);
  EXPECT_NEAR(settled({{0.0, -1.0, 0.0}, {}}, {&deep_tooth, 1}, load).motion.translation_mm.y, 0.0,
              1e-6);
}

TEST(ProxyFriction, HoldsUntilThePullIsThreeTenthsOfThePush) {
  ProxyLoad load;
  const BladeContact contact{face, {0.0, 0.0, 0.0}, up, 0.0};
  const auto slip_mm = [&](double pull_mm) {
    return settled({{pull_mm, -1.0, 0.0}, {}}, {&contact, 1}, load, {}).motion.translation_mm.x;
  };
  EXPECT_NEAR(slip_mm(0.29), 0.0, 1e-6);
  EXPECT_FALSE(load.slides);
  // Once it slides it keeps six tenths of that, and holds again where the pull is less.
  EXPECT_NEAR(slip_mm(0.31), 0.31 - 0.18, 1e-6);
  EXPECT_TRUE(load.slides);
  EXPECT_NEAR(slip_mm(0.2), 0.2 - 0.18, 1e-6);
  EXPECT_NEAR(slip_mm(0.16), 0.0, 1e-6);
  EXPECT_FALSE(load.slides);
  EXPECT_NEAR(slip_mm(0.29), 0.0, 1e-6);
}

TEST(ProxyFriction, WithoutAPushThereIsNone) {
  ProxyLoad load;
  const BladeContact contact{face, {0.0, 0.0, 0.0}, up, 0.0};
  const ProxyResult result = settled({{0.5, 1.0, 0.0}, {}}, {&contact, 1}, load, {});
  EXPECT_EQ(result.motion.translation_mm, Vec3(0.5, 1.0, 0.0));
  EXPECT_FALSE(load.slides);
}

TEST(ProxyMotion, LeadsFromOnePoseToTheOther) {
  const RigidTransform from = tests::blade_down({1.0, 2.0, 3.0}, 0.4);
  const RigidTransform to = tests::blade_down({1.5, 1.0, 3.2}, 0.401);
  const RigidTransform reached = moved_by(from, motion_between(from, to));
  const ProxyMotion left = motion_between(reached, to);
  EXPECT_LT(std::sqrt(glm::dot(left.translation_mm, left.translation_mm)), 1e-12);
  EXPECT_LT(std::sqrt(glm::dot(left.rotation_rad, left.rotation_rad)), 1e-9);
}

}  // namespace
}  // namespace hallux::simulator

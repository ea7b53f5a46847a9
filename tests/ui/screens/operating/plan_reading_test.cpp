#include "ui/screens/operating/hud/plan_reading.h"

#include <gtest/gtest.h>

namespace hallux::ui {
namespace {

/// A face square to z at z = 2, waste above; the saw comes along -y.
scenarios::PlannedCut flat_cut() {
  scenarios::PlannedCut cut;
  cut.face = {Vec3(0.0, 0.0, 1.0), 2.0};
  cut.axis = Vec3(1.0, 0.0, 0.0);
  cut.entry_point_in_bone_mm = Vec3(10.0, 5.0, 2.0);
  cut.exit_point_in_bone_mm = Vec3(10.0, -5.0, 2.0);
  return cut;
}

constexpr simulator::Blade blade{.width_mm = 10.0, .depth_mm = 20.0, .kerf_mm = 0.5};

/// Teeth along x, feed along -y, in the plane z = 2.25: half a kerf within the waste.
RigidTransform on_plan() {
  const Vec3 feed(0.0, -1.0, 0.0), normal(0.0, 0.0, 1.0);
  return {rotation_from_axes(feed, glm::cross(normal, feed)), Vec3(10.0, 5.0, 2.25)};
}

TEST(PlanReading, ABladeOnThePlanReadsZero) {
  const PlanReading reading = read_against(flat_cut(), blade, on_plan());
  EXPECT_NEAR(reading.pitch_rad, 0.0, 1.0e-12);
  EXPECT_NEAR(reading.roll_rad, 0.0, 1.0e-12);
  EXPECT_NEAR(reading.distance_mm, 0.0, 1.0e-12);
}

TEST(PlanReading, ABladeUpsideDownReadsTheSame) {
  RigidTransform turned = on_plan();
  turned.rotation = turned.rotation * rotation_about(Vec3(1.0, 0.0, 0.0), 3.14159265358979323846);
  const PlanReading reading = read_against(flat_cut(), blade, turned);
  EXPECT_NEAR(reading.pitch_rad, 0.0, 1.0e-9);
  EXPECT_NEAR(reading.roll_rad, 0.0, 1.0e-9);
}

TEST(PlanReading, TellsTheTwoTiltsAndTheDistanceApart) {
  RigidTransform tilted = on_plan();
  tilted.rotation = tilted.rotation * rotation_about(Vec3(0.0, 1.0, 0.0), -0.1);
  PlanReading reading = read_against(flat_cut(), blade, tilted);
  EXPECT_NEAR(reading.pitch_rad, 0.1, 1.0e-9) << "the teeth rise towards the waste";
  EXPECT_NEAR(reading.roll_rad, 0.0, 1.0e-9);
  RigidTransform rolled = on_plan();
  rolled.rotation = rolled.rotation * rotation_about(Vec3(1.0, 0.0, 0.0), 0.2);
  rolled.translation_mm.z += 1.5;
  reading = read_against(flat_cut(), blade, rolled);
  EXPECT_NEAR(reading.pitch_rad, 0.0, 1.0e-9);
  EXPECT_NEAR(std::abs(reading.roll_rad), 0.2, 1.0e-9);
  EXPECT_NEAR(reading.distance_mm, 1.5, 1.0e-9);
}

}  // namespace
}  // namespace hallux::ui

#include "ui/screens/pictures/fixation_reading.h"

#include <gtest/gtest.h>

#include "simulator/base/units.h"

namespace hallux::ui {
namespace {

constexpr double exact = 1.0e-12;

scenarios::PlannedImplant along_x() {
  scenarios::PlannedImplant planned;
  planned.name = "wire";
  planned.entry_in_bone_mm = {1.0, 2.0, 3.0};
  planned.direction_in_bone = {1.0, 0.0, 0.0};
  return planned;
}

TEST(ImplantReading, OfAParallelAxisIsItsPlaceBesideTheEntryAndTheTipsDepth) {
  const RigidTransform tool{{1.0, 0.0, 0.0, 0.0}, {-4.0, 2.0, 6.0}};
  const ImplantReading reading = read_implant(along_x(), tool);
  EXPECT_NEAR(reading.entry_mm, 3.0, exact);
  EXPECT_NEAR(reading.direction_rad, 0.0, exact);
  EXPECT_NEAR(reading.depth_mm, -5.0, exact);
}

TEST(ImplantReading, OfALeaningAxisIsWhereItPassesTheEntryNotWhereItsTipIs) {
  const double lean_rad = radian_from_degree(30.0);
  const RigidTransform turn{rotation_about({0.0, 0.0, 1.0}, lean_rad), {}};
  RigidTransform tool = turn;
  // The axis passes through the entry, the tip is 10 mm before it along the axis.
  tool.translation_mm = Vec3(1.0, 2.0, 3.0) - 10.0 * axis_x(turn);
  const ImplantReading reading = read_implant(along_x(), tool);
  EXPECT_NEAR(reading.entry_mm, 0.0, 1.0e-9);
  EXPECT_NEAR(reading.direction_rad, lean_rad, 1.0e-9);
  EXPECT_NEAR(reading.depth_mm, -10.0 * 0.8660254037844386, 1.0e-9);
}

scenarios::Plan shifted_plan() {
  scenarios::Plan plan;
  plan.fixation.fragments.push_back({.name = "other"});
  plan.fixation.fragments.push_back({.name = "head", .holds_in_bone_mm = {10.0, 0.0, 0.0}});
  plan.fixation.shifts.push_back({.name = "aside", .fragment = "other"});
  // The second shift of the same fragment: where both bring it counts.
  plan.fixation.shifts.push_back({.name = "second",
                                  .fragment = "head",
                                  .before_from_cut = {{1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 3.0}},
                                  .bone_from_before = {{1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 2.0}}});
  return plan;
}

TEST(ShiftReading, TellsWayAndTurnThatAreLeft) {
  const scenarios::Plan plan = shifted_plan();
  const double turned_rad = radian_from_degree(12.0);
  RigidTransform lies{rotation_about({0.0, 1.0, 0.0}, turned_rad), {}};
  // Turned about the place that it holds, and 1 mm on its way.
  const Vec3 holds(10.0, 0.0, 0.0);
  lies.translation_mm = holds + Vec3(0.0, 0.0, 1.0) - transform_direction(lies, holds);
  const ShiftReading reading = read_shift(plan, 1, lies);
  EXPECT_NEAR(reading.off_mm, 4.0, 1.0e-9);
  EXPECT_NEAR(reading.moved_mm, 1.0, 1.0e-9);
  EXPECT_NEAR(reading.turned_rad, turned_rad, 1.0e-9);
  EXPECT_NEAR(reading.turn_left_in_bone_rad.y, -turned_rad, 1.0e-9) << "back";
}

}  // namespace
}  // namespace hallux::ui

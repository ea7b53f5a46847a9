#include "ui/screens/replay/tool_at_moment.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "simulator/base/units.h"
#include "ui/screens/replay/hand_panel.h"

namespace hallux::ui {
namespace {

using simulator::Drill;
using simulator::Screwdriver;
using simulator::Tool;
using simulator::WireDriver;

simulator::Tray some_tray() {
  const std::array<Tool, 3> further{WireDriver{}, Drill{}, Screwdriver{}};
  return {simulator::Saw{}, further};
}

/// Takes the wire driver at tick 100, holds a piece from 200 to 300.
simulator::HandHistory some_hand() {
  simulator::HandHistory hand;
  hand.choices.push_back({100, 1});
  hand.grips.push_back({1, 200, 300, {}});
  return hand;
}

scenarios::PlannedImplant planned(scenarios::ImplantKind kind, const Vec3& entry_mm) {
  scenarios::PlannedImplant implant;
  implant.kind = kind;
  implant.entry_in_bone_mm = entry_mm;
  implant.direction_in_bone = Vec3(0.0, 0.0, 1.0);
  return implant;
}

/// Its tip at that place, its axis along z.
RigidTransform along_z(const Vec3& tip_mm) {
  return {rotation_from_axes(Vec3(0.0, 0.0, 1.0), Vec3(0.0, 1.0, 0.0)), tip_mm};
}

std::vector<std::string> names_of(const HandAtMoment& hand) {
  std::vector<std::string> names;
  for (const HandFact& fact : hand_facts(english_texts(), hand)) names.push_back(fact.name);
  return names;
}

TEST(ToolAtMoment, IsWhatWasChosenAndForcepsWhileTheyHold) {
  const simulator::Tray tray = some_tray();
  const simulator::HandHistory hand = some_hand();
  EXPECT_EQ(tool_at(hand, tray, 99).held, HeldTool::Saw);
  EXPECT_EQ(tool_at(hand, tray, 100).held, HeldTool::Driver);
  EXPECT_EQ(tool_at(hand, tray, 100).tool, &tray[1]);
  EXPECT_EQ(tool_at(hand, tray, 200).held, HeldTool::Forceps);
  EXPECT_EQ(tool_at(hand, tray, 299).grip, &hand.grips[0]);
  EXPECT_EQ(tool_at(hand, tray, 300).held, HeldTool::Driver);
}

TEST(ToolAtMoment, ADriverIsComparedWithThePlannedAxisThatItFits) {
  scenarios::Plan plan;
  plan.fixation.implants = {planned(scenarios::ImplantKind::Wire, {0.0, 0.0, 0.0}),
                            planned(scenarios::ImplantKind::Screw, {3.0, 0.0, 0.0})};
  const RigidTransform tool = along_z({2.5, 0.0, 4.0});
  const ToPlan wire = driver_to_plan(plan, tool, WireDriver{});
  EXPECT_NEAR(wire.distance_mm, 2.5, 1.0e-12);
  EXPECT_NEAR(wire.depth_mm, 4.0, 1.0e-12);
  EXPECT_NEAR(wire.tilt_rad, 0.0, 1.0e-6);
  for (const Tool& each : {Tool{Drill{}}, Tool{Screwdriver{}}})
    EXPECT_NEAR(driver_to_plan(plan, tool, each).distance_mm, 0.5, 1.0e-12);
  EXPECT_TRUE(
      std::isnan(driver_to_plan(plan, along_z({40.0, 0.0, 0.0}), WireDriver{}).distance_mm));
  EXPECT_TRUE(std::isnan(driver_to_plan({}, tool, WireDriver{}).distance_mm));
}

TEST(ToolAtMoment, APieceHasComeAndTurned) {
  const double turn_rad = radian_from_degree(10.0);
  const RigidTransform moved{Quat(std::cos(0.5 * turn_rad), 0.0, std::sin(0.5 * turn_rad), 0.0),
                             {3.0, 0.0, 4.0}};
  const ToPlan piece = piece_moved(moved, {0.0, 7.0, 0.0});
  EXPECT_NEAR(piece.distance_mm, 5.0, 1.0e-12);
  EXPECT_NEAR(piece.tilt_rad, turn_rad, 1.0e-9);
}

TEST(ToolAtMoment, TheHandsFactsAreThoseOfItsTool) {
  const simulator::Tray tray = some_tray();
  const simulator::HandHistory history = some_hand();
  HandAtMoment hand;
  hand.tool = tool_at(history, tray, 0);
  EXPECT_EQ(names_of(hand), (std::vector<std::string>{"Force", "To plan", "Tilt", "Speed"}));
  hand.tool = tool_at(history, tray, 150);
  EXPECT_EQ(names_of(hand), (std::vector<std::string>{"Force", "Off axis", "Tilt", "Depth"}));
  hand.tool = tool_at(history, tray, 250);
  EXPECT_EQ(names_of(hand), (std::vector<std::string>{"Force", "Moved", "Turned", "Speed"}));
}

}  // namespace
}  // namespace hallux::ui

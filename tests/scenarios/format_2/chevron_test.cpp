// The chevron of the fixtures on the parametric patient, against geometry computed by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/patient.h"
#include "scenarios/steps/step_order.h"
#include "simulator/base/units.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/format_2/fixtures.h"

namespace hallux::scenarios {
namespace {

using nlohmann::json;
using scenarios_test::entry_named;
using scenarios_test::fixture_json;

/// A handful of roundings of numbers under 100.
constexpr double rounding = 1.0e-12;

class Chevron : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    bone = make_patient_bones(scenarios_test::fixture("chevron")).front();
    plan = plan_on(scenarios_test::fixture("chevron"), bone);
  }
  static void TearDownTestSuite() {
    bone = {};
    plan = {};
  }

  static Vec3 landmark(std::string_view name) {
    return simulator::find_landmark(bone, name).value();
  }
  static Vec3 shaft() { return unit(landmark("shaft_distal") - landmark("shaft_proximal")); }
  static Vec3 wire() {
    const Vec3 lateral(0.0, 0.0, 1.0);
    return unit(lateral - glm::dot(lateral, shaft()) * shaft());
  }
  static const PlannedCut& cut(std::string_view name) { return *find_cut(plan, name); }
  static std::string refusal(const json& altered) {
    return scenarios_test::plan_refusal_of(altered, bone);
  }

  inline static simulator::Bone bone;
  inline static Plan plan;
};

double degrees_between(const Vec3& a, const Vec3& b) {
  return degree_from_radian(std::atan2(length_of(glm::cross(a, b)), glm::dot(a, b)));
}

TEST_F(Chevron, HasArmsOfSixtyDegreesThatContainTheWire) {
  const Vec3& dorsal = cut("dorsal_arm").face.normal;
  const Vec3& plantar = cut("plantar_arm").face.normal;
  for (const Vec3& normal : {dorsal, plantar}) {
    EXPECT_NEAR(glm::dot(normal, wire()), 0.0, rounding);
    EXPECT_NEAR(length_of(normal), 1.0, rounding);
    EXPECT_NEAR(std::abs(glm::dot(normal, shaft())), 0.5, rounding) << "30 degrees to the shaft";
  }
  // Both normals point into the tongue of the shaft, away from the head's faces.
  EXPECT_NEAR(degrees_between(dorsal, plantar), 120.0, 1.0e-9);
  EXPECT_LT(dorsal.y, 0.0);
  EXPECT_GT(plantar.y, 0.0);
}

TEST_F(Chevron, EndsBothArmsAtTheApex) {
  const Vec3 apex = landmark("head_centre");
  for (const char* name : {"dorsal_arm", "plantar_arm"}) {
    const PlannedCut& arm = cut(name);
    EXPECT_TRUE(arm.keeps_both);
    EXPECT_FALSE(arm.is_along_bone);
    EXPECT_NEAR(glm::dot(arm.face.normal, apex), arm.face.offset_mm, rounding);
    ASSERT_TRUE(arm.window.has_value());
    EXPECT_NEAR(glm::dot(arm.window->along, wire()), 0.0, rounding) << "ends along the wire";
    EXPECT_NEAR(glm::dot(arm.window->along, shaft()), -std::sqrt(0.75), rounding);
    for (const Vec3& point : {arm.entry_point_in_bone_mm, arm.exit_point_in_bone_mm}) {
      EXPECT_NEAR(glm::dot(arm.face.normal, point), arm.face.offset_mm, 1.0e-9);
      EXPECT_GE(glm::dot(arm.window->along, point - apex), -1.0e-9) << "within its window";
    }
    EXPECT_GT(arm.exit_point_in_bone_mm.z - arm.entry_point_in_bone_mm.z, 10.0)
        << "from medial to lateral";
    EXPECT_NEAR(glm::dot(arm.axis, wire()), 0.0, rounding) << "the tooth line lies across the feed";
  }
  EXPECT_GT(cut("dorsal_arm").axis.y, 0.0);
}

TEST_F(Chevron, LaysTheEminenceWhereFormat1DoesTo) {
  Scenario silver = scenarios_test::format_1("silver");
  silver.patient.edge_mm = 1.0;
  const PlannedCut old = plan_on(silver, bone).cuts.at(0);
  const PlannedCut& eminence = cut("eminence");
  EXPECT_LT(length_of(eminence.face.normal - old.face.normal), rounding);
  EXPECT_NEAR(eminence.face.offset_mm, old.face.offset_mm, 1.0e-10);
  EXPECT_LT(length_of(eminence.axis - old.axis), rounding);
  EXPECT_TRUE(eminence.is_along_bone);
  EXPECT_NEAR(eminence.depth_mm, 1.0, 1.0e-10);
  EXPECT_LT(length_of(eminence.entry_point_in_bone_mm - old.entry_point_in_bone_mm), 1.0e-9);
  EXPECT_EQ(eminence.depth_point_in_bone_mm, old.depth_point_in_bone_mm);
  EXPECT_EQ(eminence.exit_point_in_bone_mm, old.exit_point_in_bone_mm);
  EXPECT_EQ(eminence.blade, std::optional<std::size_t>(0));
  EXPECT_EQ(cut("dorsal_arm").blade, std::optional<std::size_t>(1));
}

TEST_F(Chevron, ShiftsTheHeadFiveMillimetresAlongTheWire) {
  ASSERT_EQ(plan.fixation.fragments.size(), 1U);
  const PlannedFragment& head = plan.fixation.fragments[0];
  const PlannedShift& shift = *find_shift(plan.fixation, "to_lateral");
  EXPECT_TRUE(shift.is_closed);
  EXPECT_EQ(shift.bone_from_before.rotation, Quat(1.0, 0.0, 0.0, 0.0));
  EXPECT_LT(length_of(shift.bone_from_before.translation_mm - 5.0 * wire()), rounding);
  EXPECT_EQ(head.bone_from_rest, shift.bone_from_before);
  // A head of some 22 x 20 x 15 mm, without its eminence and without the tongue.
  EXPECT_GT(head.volume_mm3, 2500.0);
  EXPECT_LT(head.volume_mm3, 9000.0);
}

TEST_F(Chevron, KeepsTheScrewBelowTheCartilageOfTheShiftedHead) {
  const PlannedImplant& screw = *find_implant(plan.fixation, "screw");
  EXPECT_EQ(screw.kind, ImplantKind::Screw);
  EXPECT_EQ(screw.length_mm, 22.0);
  EXPECT_EQ(screw.diameter_mm, 2.75);
  EXPECT_FALSE(screw.is_temporary);
  EXPECT_LT(
      length_of(screw.tip_in_bone_mm - screw.entry_in_bone_mm - 22.0 * screw.direction_in_bone),
      rounding);
  // Distal, plantar, lateral.
  EXPECT_GT(screw.direction_in_bone.x, 0.5);
  EXPECT_LT(screw.direction_in_bone.y, -0.1);
  EXPECT_GT(screw.direction_in_bone.z, 0.05);
  ASSERT_EQ(screw.clear_of.size(), 1U);
  EXPECT_GE(screw.clear_of[0].planned_mm, 2.0);
  // The surface moves with the head: measured on the bone as it lay, it is the tip carried back.
  const Vec3 tip = screw.tip_in_bone_mm - 5.0 * wire();
  double nearest_mm = 100.0;
  for (const std::uint32_t index : plan.joint_surfaces.at(0).triangles) {
    for (const Vec3& corner : simulator::corners_of(bone.outer, index))
      nearest_mm = std::min(nearest_mm, length_of(corner - tip));
  }
  EXPECT_LE(screw.clear_of[0].planned_mm, nearest_mm);
  EXPECT_GT(screw.clear_of[0].planned_mm, nearest_mm - 0.7) << "less than an edge between corners";
}

TEST_F(Chevron, RefusesAScrewThatComesNearTheCartilage) {
  json altered = fixture_json("chevron");
  altered["screws"][0]["length_mm"] = {34, 38};
  EXPECT_EQ(refusal(altered),
            "chevron: screws[0] \"screw\": its axis comes within 2 mm of the joint surface "
            "\"head_surface\"; mend entry, direction or length_mm");
}

TEST_F(Chevron, RefusesImplantsThatMissWhatTheyMustHold) {
  json altered = fixture_json("chevron");
  altered["screws"][0]["length_mm"] = {8, 10};
  EXPECT_EQ(refusal(altered),
            "chevron: screws[0] \"screw\": its axis misses \"head\", which it must engage; mend "
            "entry, direction or length_mm");
  altered = fixture_json("chevron");
  altered["wires"][1]["direction"] = "dorsal_of_shaft";
  EXPECT_EQ(refusal(altered),
            "chevron: wires[1] \"holding_wire\": its axis misses \"first_metatarsal\", which it "
            "must engage; mend entry, direction or depth_mm");
}

TEST_F(Chevron, SetsTheAxisWireInTheHeadBeforeItIsShifted) {
  const PlannedImplant& axis = *find_implant(plan.fixation, "axis_wire");
  EXPECT_TRUE(axis.is_temporary);
  EXPECT_LT(length_of(axis.direction_in_bone - wire()), rounding);
  const Vec3 way = landmark("head_centre") - axis.entry_in_bone_mm;
  EXPECT_LT(length_of(way - glm::dot(way, wire()) * wire()), 1.0e-9) << "through the centre";
}

TEST_F(Chevron, RefusesAFragmentThatNoCutParts) {
  json altered = fixture_json("chevron");
  // Arms that end short of the apex leave a bridge.
  for (const char* name : {"dorsal_arm", "plantar_arm"})
    entry_named(altered["cuts"], name)["window"] = {{"beyond", "screw_start"},
                                                    {"along", "base_wards"}};
  EXPECT_NE(refusal(altered), "");
  altered = fixture_json("chevron");
  entry_named(altered["fragments"], "head")["holds"] = "first_metatarsal_core";
  EXPECT_NE(refusal(altered).find("chevron: fragments[0] \"head\".holds: the bone "
                                  "\"first_metatarsal\" has no landmark \"first_metatarsal_core\""),
            std::string::npos);
}

TEST_F(Chevron, GivesItsStepsInAnyOrderThatItsTextAllows) {
  const Scenario scenario = scenarios_test::fixture("chevron");
  std::vector<bool> is_done(scenario.steps.size(), false);
  const auto ids_at_hand = [&] {
    std::string ids;
    for (const std::size_t step : steps_at_hand(scenario, is_done))
      ids += (ids.empty() ? "" : " ") + scenario.steps[step].id;
    return ids;
  };
  const auto do_step = [&](std::string_view id) {
    const auto found = std::ranges::find(scenario.steps, id, &OperationStep::id);
    is_done[static_cast<std::size_t>(found - scenario.steps.begin())] = true;
  };
  EXPECT_EQ(ids_at_hand(), "verify");
  do_step("verify");
  EXPECT_EQ(ids_at_hand(), "trim_eminence retractors");
  for (const char* id : {"trim_eminence", "take_eminence", "mark_apex", "set_axis"}) do_step(id);
  EXPECT_EQ(ids_at_hand(), "retractors saw_dorsal saw_plantar") << "retractors may be left out";
  do_step("saw_plantar");
  EXPECT_EQ(ids_at_hand(), "saw_dorsal") << "what was left out is past";
  for (const char* id : {"saw_dorsal", "shift_head", "hold", "fix", "trim"}) do_step(id);
  EXPECT_EQ(ids_at_hand(), "finish");
  EXPECT_FALSE(is_all_done(scenario, is_done));
  do_step("finish");
  EXPECT_EQ(ids_at_hand(), "");
  EXPECT_TRUE(is_all_done(scenario, is_done));
}

}  // namespace
}  // namespace hallux::scenarios

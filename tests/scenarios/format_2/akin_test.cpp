// The Akin of format 1 said in format 2: the same planes, and its fixation beside them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenarios/patient.h"
#include "scenarios/steps/step_order.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/format_2/fixtures.h"

namespace hallux::scenarios {
namespace {

using nlohmann::json;
using scenarios_test::fixture_json;

constexpr double rounding = 1.0e-11;

class ShippedAkin : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    Scenario akin = scenarios_test::format_1("akin");
    akin.patient.edge_mm = 1.0;
    bone = make_patient_bones(akin).front();
    plan_of_format_1 = plan_on(akin, bone);
    plan_of_format_2 = plan_on(scenarios_test::fixture("akin"), bone);
  }
  static void TearDownTestSuite() {
    bone = {};
    plan_of_format_1 = plan_of_format_2 = {};
  }

  inline static simulator::Bone bone;
  inline static Plan plan_of_format_1, plan_of_format_2;
};

TEST_F(ShippedAkin, HasThePlanesOfFormat1) {
  ASSERT_EQ(plan_of_format_2.cuts.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const PlannedCut &cut = plan_of_format_2.cuts[i], &old = plan_of_format_1.cuts[i];
    EXPECT_EQ(cut.name, old.name);
    EXPECT_LT(length_of(cut.face.normal - old.face.normal), rounding) << cut.name;
    EXPECT_NEAR(cut.face.offset_mm, old.face.offset_mm, rounding);
    EXPECT_LT(length_of(cut.axis - old.axis), rounding);
    EXPECT_LT(length_of(cut.entry_point_in_bone_mm - old.entry_point_in_bone_mm), 1.0e-9);
    EXPECT_LT(length_of(cut.exit_point_in_bone_mm - old.exit_point_in_bone_mm), 1.0e-9);
    EXPECT_EQ(cut.hinge, old.hinge);
    EXPECT_EQ(cut.is_turned_about_hinge, old.is_turned_about_hinge);
    EXPECT_EQ(cut.is_along_bone, old.is_along_bone);
    EXPECT_EQ(cut.approach_in_bone, old.approach_in_bone);
  }
}

TEST_F(ShippedAkin, HasTheHingeOfFormat1) {
  ASSERT_EQ(plan_of_format_2.hinges.size(), 1U);
  const simulator::PlannedBridge &bridge = plan_of_format_2.hinges[0].bridge,
                                 &old = plan_of_format_1.hinges[0].bridge;
  EXPECT_LT(length_of(bridge.line.point_in_bone_mm - old.line.point_in_bone_mm), 1.0e-9);
  EXPECT_LT(length_of(bridge.line.axis - old.line.axis), rounding);
  EXPECT_LT(length_of(bridge.line.outward - old.line.outward), rounding);
  EXPECT_EQ(bridge.toward_moved, old.toward_moved);
  EXPECT_NEAR(plan_of_format_2.hinges[0].wedge_rad, plan_of_format_1.hinges[0].wedge_rad, rounding);
  ASSERT_EQ(planned_bridges(plan_of_format_2).size(), 1U);
  EXPECT_EQ(planned_bridges(plan_of_format_2)[0].line.point_in_bone_mm,
            bridge.line.point_in_bone_mm);
}

TEST_F(ShippedAkin, HoldsTheToeByAScrewOrByTwoWires) {
  ASSERT_EQ(plan_of_format_2.fixation.implants.size(), 3U);
  for (const PlannedImplant& implant : plan_of_format_2.fixation.implants) {
    EXPECT_EQ(implant.engages, (std::vector<std::string>{"toe", "first_proximal_phalanx"}));
    EXPECT_LT(implant.direction_in_bone.x, 0.0) << "proximal";
    EXPECT_GE(implant.clear_of.at(0).planned_mm, implant.clear_of[0].least_mm);
  }
  const PlannedImplant& screw = *find_implant(plan_of_format_2.fixation, "screw");
  EXPECT_GT(screw.direction_in_bone.z, 0.0) << "medial to lateral";
}

TEST_F(ShippedAkin, IsFixedByEitherAlternative) {
  const Scenario scenario = scenarios_test::fixture("akin");
  std::vector<bool> is_done(scenario.steps.size(), false);
  for (std::size_t step = 0; step < 5; ++step) {
    EXPECT_EQ(steps_at_hand(scenario, is_done), std::vector<std::size_t>{step});
    is_done[step] = true;
  }
  const std::vector<std::size_t> either{5, 6}, finish{7};
  EXPECT_EQ(steps_at_hand(scenario, is_done), either);
  for (const std::size_t one : either) {
    is_done[one] = true;
    EXPECT_EQ(steps_at_hand(scenario, is_done), finish);
    is_done[finish[0]] = true;
    EXPECT_TRUE(is_all_done(scenario, is_done));
    is_done[one] = is_done[finish[0]] = false;
  }
}

TEST_F(ShippedAkin, RefusesCutsThatLeaveNoWedgeBetweenThem) {
  json altered = fixture_json("akin");
  altered["cuts"][1]["keep"] = "proximal";
  EXPECT_EQ(scenarios_test::plan_refusal_of(altered, bone),
            "akin: hinges[0] \"lateral_hinge\": \"proximal_face\" and \"distal_face\" keep the "
            "same side, and no wedge lies between them; mend keep");
}

/// The points of what was to be fixed are not measured.
void ask_nothing_of_fixation(json& rubric) {
  const auto is_of_fixation = [](const json& part) {
    return part.contains("implant") || part.contains("fragment");
  };
  for (json& group : rubric["groups"]) {
    double left_out = group.value("not_measured", 0.0);
    for (const json& item : rubric["items"]) {
      if (item["group"] == group["name"] && is_of_fixation(item))
        left_out += item["weight"].get<double>();
    }
    if (left_out > 0.0) group["not_measured"] = left_out;
  }
  for (const char* list : {"items", "gates"}) {
    json kept = json::array();
    for (const json& part : rubric[list]) {
      if (!is_of_fixation(part)) kept.push_back(part);
    }
    rubric[list] = kept;
  }
}

TEST_F(ShippedAkin, ShiftsWhatLiesOnAClosedHingeFromWhereThatLeftIt) {
  json shifted = fixture_json("akin");
  shifted["shifts"] = {{{"name", "aside"},
                        {"title", "Aside"},
                        {"fragment", "toe"},
                        {"moves", {{{"slide", "lateral"}, {"mm", 1}}}},
                        {"origin", "author: a test."}}};
  const auto step_of = [&](const char* id) -> json& {
    return *std::ranges::find_if(shifted["steps"],
                                 [&](const json& each) { return each["id"] == id; });
  };
  json step = step_of("close");
  step.erase("hinge");
  step["id"] = step["kind"] = "shift";
  step["shift"] = "aside";
  step["after"] = {"close"};
  // Listed before the step that it comes after: the order is what each says.
  shifted["steps"].insert(shifted["steps"].begin() + 1, step);
  step_of("finish")["after"].push_back("shift");
  const PlannedFixation fixation = plan_on(scenarios_test::coarse(shifted), bone).fixation;
  const PlannedShift& aside = *find_shift(fixation, "aside");
  const RigidTransform closed = find_fragment(plan_of_format_2.fixation, "toe")->bone_from_rest;
  EXPECT_GT(std::abs(closed.rotation.y), 0.01) << "about the dorsal axis";
  EXPECT_EQ(aside.bone_from_cut(), aside.bone_from_before * closed);
  EXPECT_EQ(find_fragment(fixation, "toe")->bone_from_rest, aside.bone_from_cut());
}

TEST_F(ShippedAkin, MayHaveSeveralHinges) {
  json two = fixture_json("akin");
  json first = two["cuts"][0], second = two["cuts"][1], hinge = two["hinges"][0];
  first["name"] = "other_first";
  first["face"]["through"] = "other_level";
  second["name"] = "other_second";
  second["face"]["through"] = second["face"]["contains"] = hinge["name"] = "medial_hinge";
  second["face"]["from"] = hinge["first_cut"] = "other_first";
  second["face"]["angle_deg"] = 8;
  hinge["second_cut"] = "other_second";
  hinge["side"] = "medial";
  first["approach"] = second["approach"] = "lateral";
  two["points"].push_back({{"name", "other_level"},
                           {"at", "base_centre"},
                           {"move", {{{"along", "distal"}, {"mm", 16}}}},
                           {"origin", "author: a test."}});
  two["cuts"].push_back(first);
  two["cuts"].push_back(second);
  two["hinges"].push_back(hinge);
  // The fragments are another test's, and what is asked of them.
  for (const char* part : {"fragments", "wires", "screws", "proof"}) two.erase(part);
  ask_nothing_of_fixation(two["rubric"]);
  json steps = json::array();
  for (const json& step : two["steps"]) {
    if (step["kind"] != "fix") steps.push_back(step);
  }
  for (const char* name : {"other_first", "other_second"}) {
    json step = steps[1];
    step["id"] = step["cut"] = name;
    step["after"] = {"close"};
    steps.push_back(step);
  }
  scenarios_test::entry_named(two["cuts"], "other_first");
  for (json& step : steps) {
    if (step["kind"] == "finish") step["after"] = {"other_first", "other_second"};
  }
  two["steps"] = steps;
  const Plan plan = plan_on(scenarios_test::coarse(two), bone);
  const std::vector<simulator::PlannedBridge> bridges = planned_bridges(plan);
  ASSERT_EQ(bridges.size(), 2U);
  EXPECT_GT(bridges[0].line.outward.z, 0.9);
  EXPECT_LT(bridges[1].line.outward.z, -0.9);
  EXPECT_NEAR(plan.hinges[1].wedge_rad, 8.0 * std::acos(-1.0) / 180.0, rounding);
  EXPECT_EQ(find_cut(plan, "other_second")->hinge, "medial_hinge");
}

}  // namespace
}  // namespace hallux::scenarios

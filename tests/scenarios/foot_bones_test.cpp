// The registry of bones, and a bone of a test's own that is known by its row alone.
#include "scenarios/foot/foot_bones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "scenarios/foot/bone_table.h"
#include "scenarios/neighbour.h"
#include "scenarios/patient.h"
#include "scenarios/plan.h"
#include "tests/scenarios/format_1/format_1.h"

namespace hallux::scenarios_test {
std::span<const EmbeddedText> metric_files() noexcept;
}

namespace hallux::scenarios {
namespace {

using nlohmann::json;

/// The phalanx under another name.
BoneTable second_phalanx_table() {
  BoneTable table = find_foot_bone("first_proximal_phalanx")->table();
  table.bone = "second_proximal_phalanx";
  return table;
}

std::vector<FootBone> with_a_third() {
  std::vector<FootBone> rows(foot_bones().begin(), foot_bones().end());
  FootBone third = *find_foot_bone("first_proximal_phalanx");
  third.name = "second_proximal_phalanx";
  third.title = "second proximal phalanx";
  third.table = second_phalanx_table;
  third.neighbour = "first_proximal_phalanx";
  third.length_high_mm = 34.0;
  rows.push_back(third);
  return rows;
}

json akin_of_the_third() {
  json akin = json::parse(scenarios_test::format_1("akin").text);
  akin["patient"]["bone"] = "second_proximal_phalanx";
  akin["patient"]["edge_mm"] = 1.5;
  return akin;
}

TEST(FootBones, AgreeWithTheirTables) {
  std::set<std::string_view> names;
  for (const FootBone& bone : foot_bones()) {
    EXPECT_TRUE(names.insert(bone.name).second) << bone.name;
    const BoneTable table = bone.table();
    EXPECT_EQ(table.bone, bone.name);
    EXPECT_EQ(table.eminence.has_value(), bone.has_eminence);
    EXPECT_LT(bone.length_low_mm, table.length_mm);
    EXPECT_GT(bone.length_high_mm, table.length_mm);
    EXPECT_NE(find_foot_bone(bone.neighbour), nullptr) << bone.neighbour;
    EXPECT_NE(bone.neighbour, bone.name);
  }
  EXPECT_EQ(find_foot_bone("femur"), nullptr);
}

TEST(FootBones, AreTheOnesThatTheSchemaLists) {
  const json schema = json::parse(scenarios_test::metric_files()[0].text);
  std::vector<std::string> listed = schema["$defs"]["patient"]["properties"]["bone"]["enum"];
  std::string names;
  for (const std::string& name : listed) names += (names.empty() ? "" : ", ") + name;
  EXPECT_EQ(names, names_of(foot_bones()));
}

TEST(FootBones, AThirdIsATableAndARow) {
  const std::vector<FootBone> rows = with_a_third();
  const Scenario scenario = parse_scenario(akin_of_the_third().dump(), "akin.json", rows);
  const simulator::Bone bone = make_patient_bones(scenario, {}, rows).front();
  EXPECT_EQ(bone.name, "second_proximal_phalanx");
  EXPECT_EQ(neighbour_of(scenario, 1.5, rows)->name, "first_proximal_phalanx");
  EXPECT_EQ(plan_on(scenario, bone).cuts.size(), 2U);
  EXPECT_THROW(make_patient_bones(scenario), ScenarioError) << "the foot has it not";
}

TEST(FootBones, ARowBoundsWhatAScenarioMayAskFor) {
  const std::vector<FootBone> rows = with_a_third();
  json akin = akin_of_the_third();
  akin["patient"]["length_mm"] = 35;
  const auto refusal_of = [&](std::span<const FootBone> bones) -> std::string {
    try {
      parse_scenario(akin.dump(), "akin.json", bones);
    } catch (const ScenarioError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal_of(rows), "akin.json: patient.length_mm: is 35; give a number from 18 to 34");
  EXPECT_EQ(refusal_of(foot_bones()),
            "akin.json: patient.bone: is \"second_proximal_phalanx\"; use one of: "
            "first_metatarsal, first_proximal_phalanx");
}

}  // namespace
}  // namespace hallux::scenarios

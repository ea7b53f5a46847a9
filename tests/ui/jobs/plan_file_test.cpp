#include "ui/jobs/plan_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ui/jobs/exchange_jobs.h"

namespace hallux::ui {
namespace {

using nlohmann::json;

struct Planned {
  scenarios::Scenario scenario;
  simulator::Bone bone;
  scenarios::Plan plan;
};

/// On a coarse bone, which is quick to build.
Planned planned(const char* name) {
  scenarios::Scenario scenario = scenarios::load_shipped_scenario(name);
  scenario.patient.edge_mm = 1.2;
  simulator::Bone bone = make_patient_bones(scenario).front();
  scenarios::Plan plan = plan_on(scenario, bone);
  return {std::move(scenario), std::move(bone), std::move(plan)};
}

json file_of(const Planned& made) {
  return json::parse(plan_file(made.scenario, made.bone, made.plan));
}

Vec3 vector_in(const json& list) {
  EXPECT_EQ(list.size(), 3U);
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}

void expect_finite(const json& value) {
  for (const json& each : value) {
    if (each.is_structured()) expect_finite(each);
    if (each.is_number()) {
      EXPECT_TRUE(std::isfinite(each.get<double>()));
    }
  }
}

double off_mm(const json& cut, const char* point) {
  return glm::dot(vector_in(cut.at("normal")), vector_in(cut.at(point))) -
         cut.at("offset_mm").get<double>();
}

TEST(PlanFile, FacesAreUnitPlanesThroughTheirEntries) {
  for (const char* name : {"silver", "akin"}) {
    const json plan = file_of(planned(name));
    expect_finite(plan);
    for (const json& cut : plan.at("cuts")) {
      const Vec3 normal = vector_in(cut.at("normal")), axis = vector_in(cut.at("axis"));
      EXPECT_NEAR(length_of(normal), 1.0, 1e-12);
      EXPECT_NEAR(length_of(axis), 1.0, 1e-12);
      EXPECT_NEAR(glm::dot(normal, axis), 0.0, 1e-12);
      EXPECT_NEAR(off_mm(cut, "entry_in_bone_mm"), 0.0, 1e-9);
    }
  }
}

TEST(PlanFile, TheHingeLiesInBothOfItsFaces) {
  const json plan = file_of(planned("akin"));
  const json &first = plan.at("cuts").at(0), &second = plan.at("cuts").at(1);
  const json& hinge = plan.at("hinges").at(0);
  EXPECT_EQ(hinge.at("first_cut"), first.at("name"));
  EXPECT_EQ(hinge.at("second_cut"), second.at("name"));
  for (const json* cut : {&first, &second}) {
    EXPECT_EQ(cut->at("kind"), "turned");
    EXPECT_EQ(cut->at("along_bone"), false);
    EXPECT_EQ(cut->at("hinge"), hinge.at("name"));
    EXPECT_EQ(cut->at("exit_in_bone_mm"), hinge.at("point_in_bone_mm"));
    EXPECT_NEAR(off_mm(*cut, "exit_in_bone_mm"), 0.0, 1e-9);
    EXPECT_NEAR(glm::dot(vector_in(cut->at("normal")), vector_in(hinge.at("axis"))), 0.0, 1e-12);
  }
  EXPECT_NEAR(glm::dot(vector_in(hinge.at("outward")), vector_in(hinge.at("axis"))), 0.0, 1e-12);
  EXPECT_NEAR(hinge.at("wedge_deg").get<double>(), 10.0, 1e-12);
  EXPECT_EQ(hinge.at("target_mm"), json({0.8, 2.0}));
  const double cosine = -glm::dot(vector_in(first.at("normal")), vector_in(second.at("normal")));
  EXPECT_NEAR(std::acos(cosine) * 180.0 / std::acos(-1.0), 10.0, 1e-9);
}

TEST(PlanFile, AFaceAcrossTheBoneWithoutAHingeHasNoPlannedExit) {
  Planned made = planned("akin");
  made.plan.cuts[0].hinge.clear();
  made.plan.cuts[0].has_exit = false;
  const json cut = file_of(made).at("cuts").at(0);
  EXPECT_TRUE(cut.at("hinge").is_null());
  EXPECT_TRUE(cut.at("exit_in_bone_mm").is_null());
}

/// Row by row; a point has a fourth number, 1.
Vec3 carried(const json& matrix, const Vec3& point_mm) {
  Vec3 carried_mm{0.0, 0.0, 0.0};
  for (int row = 0; row < 3; ++row) {
    const json& numbers = matrix.at(static_cast<std::size_t>(row));
    carried_mm[row] = numbers.at(3).get<double>();
    for (int i = 0; i < 3; ++i)
      carried_mm[row] += numbers.at(static_cast<std::size_t>(i)).get<double>() * point_mm[i];
  }
  return carried_mm;
}

TEST(PlanFile, TheMatrixIsThePlaceOfTheBone) {
  const Planned made = planned("silver");
  const json plan = file_of(made);
  ASSERT_FALSE(made.bone.landmarks.empty());
  for (const simulator::Landmark& landmark : made.bone.landmarks) {
    const Vec3 in_bone_mm = vector_in(plan.at("landmarks").at(landmark.name));
    EXPECT_EQ(in_bone_mm, landmark.point_in_bone_mm);
    const Vec3 in_world_mm = transform_point(made.bone.world_from_bone, in_bone_mm);
    const Vec3 carried_mm = carried(plan.at("world_from_bone"), in_bone_mm);
    EXPECT_NEAR(length_of(carried_mm - in_world_mm), 0.0, 1e-9);
  }
}

TEST(PlanFile, AResectionLiesAlongTheBoneAndPartsNoFragment) {
  const json plan = file_of(planned("silver"));
  EXPECT_EQ(plan.at("cuts").at(0).at("along_bone"), true);
  EXPECT_EQ(plan.at("fragments"), json::array());
  EXPECT_EQ(plan.at("implants"), json::array());
}

TEST(PlanFile, AFragmentIsCarriedToWhereItsWedgeIsClosed) {
  const json plan = file_of(planned("akin"));
  ASSERT_EQ(plan.at("fragments").size(), 1U);
  const json &toe = plan.at("fragments").at(0), &hinge = plan.at("hinges").at(0);
  EXPECT_EQ(toe.at("name"), "toe");
  EXPECT_GT(toe.at("volume_mm3").get<double>(), 1000.0);
  EXPECT_NEAR(length_of(vector_in(toe.at("dorsal_in_bone"))), 1.0, 1e-12);
  const json& pose = toe.at("pose");
  const Vec3 on_hinge_mm = vector_in(hinge.at("point_in_bone_mm"));
  EXPECT_NEAR(length_of(carried(pose, on_hinge_mm) - on_hinge_mm), 0.0, 1e-9);
  const json& turning = plan.at("cuts").at(1);
  const Vec3 normal = vector_in(turning.at("normal"));
  const Vec3 turned = carried(pose, normal) - carried(pose, Vec3{0.0, 0.0, 0.0});
  const Vec3 standing = vector_in(plan.at("cuts").at(0).at("normal"));
  EXPECT_NEAR(glm::dot(turned, standing), -1.0, 1e-12);
}

TEST(PlanFile, AnImplantIsPlannedWithTheMiddleOfItsLengths) {
  const json implants = file_of(planned("akin")).at("implants");
  ASSERT_EQ(implants.size(), 3U);
  EXPECT_EQ(implants.at(0).at("kind"), "wire");
  EXPECT_EQ(implants.at(2).at("kind"), "screw");
  EXPECT_EQ(implants.at(2).at("lengths_mm"), json({15.0, 20.0}));
  EXPECT_EQ(implants.at(2).at("diameters_mm"), json({2.0, 3.0}));
  EXPECT_EQ(implants.at(2).at("engages"), json({"toe", "first_proximal_phalanx"}));
  for (const json& implant : implants) {
    EXPECT_EQ(implant.at("temporary"), false);
    const Vec3 direction = vector_in(implant.at("direction"));
    EXPECT_NEAR(length_of(direction), 1.0, 1e-12);
    const json& lengths_mm = implant.at("lengths_mm");
    const double length_mm =
        0.5 * (lengths_mm.at(0).get<double>() + lengths_mm.at(1).get<double>());
    const Vec3 way_mm =
        vector_in(implant.at("tip_in_bone_mm")) - vector_in(implant.at("entry_in_bone_mm"));
    EXPECT_NEAR(length_of(way_mm - length_mm * direction), 0.0, 1e-9);
  }
}

TEST(PlanFile, EachCutNamesABladeOfTheTray) {
  const json plan = file_of(planned("chevron"));
  ASSERT_EQ(plan.at("blades").size(), 2U);
  EXPECT_EQ(plan.at("blades").at(1).at("name"), "narrow");
  EXPECT_EQ(plan.at("blades").at(1).at("width_mm"), 9.0);
  for (const auto& [key, size_mm] : plan.at("blade").items())
    EXPECT_EQ(plan.at("blades").at(0).at(key), size_mm);
  EXPECT_EQ(plan.at("cuts").at(0).at("blade"), "wide");
  EXPECT_EQ(plan.at("cuts").at(1).at("blade"), "narrow");
}

TEST(PlanFile, WhatBoresStandsAtItsPlaceOnTheTray) {
  const json tools = file_of(planned("chevron")).at("boring_tools");
  ASSERT_GT(tools.size(), 3U);
  for (std::size_t i = 0; i < tools.size(); ++i) {
    EXPECT_EQ(tools[i].at("place"), 2 + i) << "behind the two blades";
    EXPECT_GT(tools[i].at("radius_mm"), 0.4);
    EXPECT_GT(tools[i].at("shaft_mm"), 5.0);
  }
  EXPECT_TRUE(file_of(planned("silver")).at("boring_tools").empty());
}

TEST(PlanFile, ANameThatIsNoTextHindersNothing) {
  Planned made = planned("silver");
  made.bone.landmarks.push_back({"\xff\xfe", Vec3{1.0, 2.0, 3.0}});
  EXPECT_EQ(file_of(made).at("landmarks").size(), made.bone.landmarks.size());
}

std::vector<std::string> names_made_from(const scenarios::Scenario& scenario,
                                         const simulator::Bone& bone) {
  const std::vector<std::byte> bytes = encode_bone(bone);
  std::vector<std::string> names;
  for (const database::DerivedFile& file : files_made_from(
           {{}, {.name = scenario.name, .json = scenario.text}, bytes, simulator::Recording{}})) {
    names.push_back(file.name);
  }
  return names;
}

TEST(PlanFile, AnAttemptWhoseScenarioDoesNotFitItsBoneLeavesWithoutOne) {
  Planned made = planned("silver");
  EXPECT_EQ(names_made_from(made.scenario, made.bone),
            (std::vector<std::string>{"bone.ply", "plan.json", "fragments.json", "implants.json",
                                      "piece-1.ply"}));
  made.bone.landmarks.clear();
  EXPECT_EQ(names_made_from(made.scenario, made.bone),
            (std::vector<std::string>{"bone.ply", "piece-1.ply"}));
}

}  // namespace
}  // namespace hallux::ui

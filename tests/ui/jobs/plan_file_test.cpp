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
  simulator::Bone bone = make_patient(scenario);
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
  EXPECT_EQ(first.at("kind"), "transverse");
  EXPECT_EQ(second.at("kind"), "through_hinge");
  for (const json* cut : {&first, &second}) {
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

TEST(PlanFile, TheMatrixIsThePlaceOfTheBone) {
  const Planned made = planned("silver");
  const json plan = file_of(made);
  ASSERT_FALSE(made.bone.landmarks.empty());
  for (const simulator::Landmark& landmark : made.bone.landmarks) {
    const Vec3 in_bone_mm = vector_in(plan.at("landmarks").at(landmark.name));
    EXPECT_EQ(in_bone_mm, landmark.point_in_bone_mm);
    const Vec3 in_world_mm = transform_point(made.bone.world_from_bone, in_bone_mm);
    for (int row = 0; row < 3; ++row) {
      const json& numbers = plan.at("world_from_bone").at(static_cast<std::size_t>(row));
      double sum_mm = numbers.at(3).get<double>();
      for (int i = 0; i < 3; ++i) {
        sum_mm += numbers.at(static_cast<std::size_t>(i)).get<double>() * in_bone_mm[i];
      }
      EXPECT_NEAR(sum_mm, in_world_mm[row], 1e-9);
    }
  }
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

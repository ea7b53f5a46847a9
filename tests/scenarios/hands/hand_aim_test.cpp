// How far off the hands aim and how they come to the bone on the patient of Silver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "scenarios/hands/feeling_hand.h"
#include "simulator/base/units.h"
#include "simulator/cutting/slice/section.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;

constexpr std::uint64_t seeds = 200;

/// An operation on a bone coarse enough that hundreds of hands take no time; planes do not depend
/// on the edges' length.
struct Patient {
  explicit Patient(const char* operation = "silver")
      : scenario(scenarios_test::format_1(operation)) {
    scenario.patient.edge_mm = 1.5;
    bone = make_patient_bones(scenario).front();
    plan = plan_on(scenario, bone);
  }
  AimedCut aimed(const HandSkill& skill, std::uint64_t seed) const {
    return aim(scenario, plan, KnownBones(bone), skill, seed).at(0);
  }

  Scenario scenario;
  Bone bone;
  Plan plan;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return 0.5 * (values[values.size() / 2 - 1] + values[values.size() / 2]);
}

/// Four standard errors of the median of as many truncated normal numbers as there are seeds.
/// The density at the median is 0.3989 / (0.9545 deviation); the error of a median is 1 / (2
/// density sqrt(count)).
double median_tolerance(double deviation) {
  const double density = 0.3989 / (0.9545 * deviation);
  return 4.0 / (2.0 * density * std::sqrt(static_cast<double>(seeds)));
}

/// The largest distance between two faces over the planned section, along the planned normal [mm].
double largest_distance_mm(const Patient& patient, const ReferenceFace& aimed) {
  const PlannedCut& cut = patient.plan.cuts.at(0);
  const simulator::CutSolid solid = simulator::uncut_solid(solid_of(patient.bone));
  const simulator::Bvh bvh(solid.mesh);
  // Like the hand's: half a kerf outside the face.
  const double kerf_mm = patient.scenario.saw.blade.kerf_mm;
  const Vec3 apex = find_landmark(patient.bone, "eminence_apex").value();
  const Vec3 origin =
      apex +
      (cut.face.offset_mm + 0.5 * kerf_mm - glm::dot(apex, cut.face.normal)) * cut.face.normal;
  const Quat frame = rotation_from_axes(cut.axis, glm::cross(cut.face.normal, cut.axis));
  const simulator::Section section = slice_section(solid, bvh, {{frame, origin}, kerf_mm});
  const auto from_apex_mm = [](const simulator::SectionRegion& region) {
    const Vec2 gap = glm::max(glm::max(region.min_mm, -region.max_mm), Vec2(0.0));
    return std::sqrt(glm::dot(gap, gap));
  };
  const auto nearest = std::min_element(
      section.regions.begin(), section.regions.end(),
      [&](const auto& a, const auto& b) { return from_apex_mm(a) < from_apex_mm(b); });
  double largest_mm = 0.0;
  for (const simulator::Contour& contour : nearest->contours) {
    for (const Vec2& point : contour) {
      const Vec3 above = transform_point(section.plane.bone_from_kerf, Vec3{point, 0.0});
      const Vec3 on_plan = above - 0.5 * kerf_mm * cut.face.normal;
      const double stand_off_mm = (aimed.offset_mm - glm::dot(aimed.normal, on_plan)) /
                                  glm::dot(aimed.normal, cut.face.normal);
      largest_mm = std::max(largest_mm, std::abs(stand_off_mm));
    }
  }
  return largest_mm;
}

struct Aims {
  std::vector<double> angles_deg, locations_mm;
};

Aims aims_of(const Patient& patient, const HandSkill& skill) {
  Aims aims;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const AimedCut aimed = patient.aimed(skill, seed);
    aims.angles_deg.push_back(degree_from_radian(aimed.angle_error_rad));
    aims.locations_mm.push_back(aimed.location_error_mm);
  }
  return aims;
}

TEST(HandAim, HasTheErrorsOfItsSkill) {
  const Patient patient;
  for (const char* name : {"expert", "novice"}) {
    const HandSkill skill = hand_skill(name);
    const Aims aims = aims_of(patient, skill);
    const double angle_deg = median(aims.angles_deg), location_mm = median(aims.locations_mm);
    std::printf("%s aims at medians of %.2f deg, %.2f mm\n", name, angle_deg, location_mm);
    EXPECT_NEAR(angle_deg, skill.angle_mean_deg, median_tolerance(skill.angle_deviation_deg))
        << name;
    // The tilt alone may reach farther than the location that was drawn: the median is no smaller,
    // and within 30 %.
    EXPECT_GT(location_mm, skill.location_mean_mm - median_tolerance(skill.location_deviation_mm))
        << name;
    EXPECT_LT(location_mm, 1.3 * skill.location_mean_mm) << name;
  }
}

TEST(HandAim, EverySeedMeetsTheBone) {
  for (const char* operation : {"silver", "akin"}) {
    const Patient patient(operation);
    const KnownBones known(patient.bone);
    for (const char* name : {"expert", "novice"}) {
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        for (const AimedCut& cut :
             aim(patient.scenario, patient.plan, known, hand_skill(name), seed)) {
          ASSERT_FALSE(cut.region.contours.empty()) << operation << ' ' << name << ' ' << seed;
        }
      }
    }
  }
}

TEST(HandAim, IsOffByTheErrorsThatItSays) {
  const Patient patient;
  const ReferenceFace& planned = patient.plan.cuts.at(0).face;
  for (const char* name : {"expert", "novice"}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const AimedCut aimed = patient.aimed(hand_skill(name), seed);
      const double cosine = std::min(1.0, glm::dot(aimed.face.normal, planned.normal));
      // An arc cosine near 1 loses half of a double's digits.
      EXPECT_NEAR(std::acos(cosine), aimed.angle_error_rad, 1.0e-6) << name << ' ' << seed;
      EXPECT_NEAR(largest_distance_mm(patient, aimed.face), aimed.location_error_mm, 1.0e-9)
          << name << ' ' << seed;
    }
  }
}

TEST(HandMotion, ComesToTheBoneWithTheSawRunning) {
  const Patient patient;
  const simulator::Bvh bone(patient.bone.outer);
  const RigidTransform bone_from_world = inverse(patient.bone.world_from_bone);
  FeelingHand hand(patient.scenario, patient.bone, patient.plan, hand_skill("novice"), 1);
  std::size_t ticks_in_bone = 0;
  for (const simulator::TapeLine& line :
       tests::run_hand(patient.scenario, patient.bone, patient.plan, hand).recording.tape) {
    const RigidTransform world_from_handle =
        simulator::transform_from(line.device.world_from_handle);
    const Vec3 tip = transform_point(bone_from_world, world_from_handle.translation_mm);
    if (!(bone.signed_distance_mm(tip) < 0.0)) continue;
    ++ticks_in_bone;
    ASSERT_TRUE(has(line.device.switches, simulator::Switch::SawRuns)) << line.tick;
  }
  EXPECT_GT(ticks_in_bone, 2000U);
}

}  // namespace
}  // namespace hallux::scenarios

// The bounds of the metrics hold: against solids whose numbers one can compute, and against the
// same attempt measured on grids of half the step.
#include <gtest/gtest.h>

#include <span>

#include <cmath>
#include <iterator>

#include "assessment/measure_closing.h"
#include "assessment/rebuild/bound.h"
#include "assessment/rebuild/face_samples.h"
#include "assessment/rebuild/joint_margin.h"
#include "assessment/rebuild/open_kerfs.h"
#include "simulator/base/units.h"
#include "simulator/cutting/hinge/hinge_gap.h"
#include "tests/assessment/examined_attempt.h"

namespace hallux::assessment {
namespace {

using testing::AkinAttempt;
using testing::examined;
using testing::ExaminedAttempt;
using testing::Stroke;

/// Poses are recorded to 1 um and quaternions to 1e-6, over 60 mm of block.
constexpr double pose_mm = 0.002, pose_deg = 5e-4;

void expect_exact(const ExaminedAttempt& made, const std::string& metric,
                  const std::string& subject, double exact, double recorded = pose_mm) {
  const Measurement& found = made.found(metric, subject);
  ASSERT_TRUE(found.is_measured()) << metric;
  EXPECT_NEAR(found.value, exact, found.bound + recorded) << metric;
}

/// The distal half turned by so much about the planned hinge.
RigidTransform turned(double degree) {
  const Quat turn = rotation_about(Vec3{0.0, 1.0, 0.0}, radian_from_degree(degree));
  const RigidTransform about{turn, {0.0, 0.0, 0.0}};
  const Vec3 hinge_mm{6.0, 0.0, 6.5};
  return {turn, hinge_mm - transform_point(about, hinge_mm)};
}

ExaminedAttempt closed_by(double degree, const AkinAttempt& attempt = {}) {
  const simulator::Bone bone = testing::oval_bone();
  simulator::Recording recording = testing::akin_recording(attempt, bone);
  recording.events.push_back({recording.samples.back().tick + 1,
                              simulator::CutEventKind::HingeClosed, -1, 0,
                              simulator::quantise(turned(degree))});
  return examined(testing::akin_with_deeds(), bone, recording);
}

// A face of the block that is turned about its middle: its distances rise from -1 to +1 times half
// its length times the slope.
TEST(Bounds, HoldOnATurnedFaceOfTheBlock) {
  for (const double tilt_deg : {0.0, 0.7, 3.0, -5.3}) {
    const double tilt_rad = radian_from_degree(std::abs(tilt_deg)), slope = std::sin(tilt_rad);
    const ExaminedAttempt made =
        examined(testing::block_scenario(), {Stroke{.tilt_rad = radian_from_degree(tilt_deg)}});
    const double length_mm = 60.0 / std::cos(tilt_rad);
    expect_exact(made, "angle_deg", "eminence", std::abs(tilt_deg), pose_deg);
    expect_exact(made, "location_mm", "eminence", 0.5 * length_mm * slope);
    expect_exact(made, "mean_mm", "eminence", 0.25 * length_mm * slope);
    expect_exact(made, "rms_mm", "eminence", length_mm * slope / std::sqrt(12.0));
    const double end_mm = 20.0 * std::tan(radian_from_degree(tilt_deg));
    expect_exact(made, "exit_mm", "eminence", end_mm);
    expect_exact(made, "step_mm", "eminence", std::abs(end_mm));
    expect_exact(made, "depth_mm", "eminence", std::abs(end_mm));
    EXPECT_LT(made.found("location_mm", "eminence").bound, 0.05);
    EXPECT_LT(made.found("mean_mm", "eminence").bound, 0.1);
  }
}

TEST(Bounds, HoldForTheThicknessOfASlabAndOfATurnedOne) {
  expect_exact(examined(testing::block_scenario(), {Stroke{.face_z_mm = -9.25}}), "thickness_mm",
               "eminence", 2.75);
  const double tilt_rad = radian_from_degree(4.0);
  const ExaminedAttempt made = examined(testing::block_scenario(), {Stroke{.tilt_rad = tilt_rad}});
  // To the block's medial side, or its distal end where that comes first.
  constexpr int parts = 60000;
  double sum_mm = 0.0, greatest_mm = 0.0;
  for (int part = 0; part < parts; ++part) {
    const double x_mm = (part + 0.5) * 60.0 / parts;
    const double deep_mm = 4.0 + (x_mm - 30.0) * std::tan(tilt_rad);
    const double thick_mm =
        std::min(deep_mm / std::cos(tilt_rad), (60.0 - x_mm) / std::sin(tilt_rad));
    sum_mm += thick_mm;
    greatest_mm = std::max(greatest_mm, thick_mm);
  }
  expect_exact(made, "thickness_mm", "eminence", sum_mm / parts);
  expect_exact(made, "thickness_max_mm", "eminence", greatest_mm);
}

// The oval bone ends laterally at z = 7.5; its hinge lies at 6.5.
TEST(Bounds, HoldForTheBridgeWhereverTheTeethStop) {
  for (const double reach_mm : {5.93, 6.5, 6.514, 7.37, 7.5, 7.93, 8.51}) {
    const ExaminedAttempt made = examined(
        testing::akin_scenario(), AkinAttempt{.reach1_mm = reach_mm, .reach2_mm = reach_mm - 0.4});
    expect_exact(made, "hinge_mm", "lateral", std::max(0.0, 7.5 - reach_mm));
    expect_exact(made, "over_cut_mm", "lateral", std::max(0.0, reach_mm - 7.5));
    EXPECT_LT(made.found("hinge_mm", "lateral").bound, 0.2);
  }
}

TEST(Bounds, HoldForTheWedge) {
  const AkinAttempt attempt{.transverse_deg = 3.0, .wedge_deg = 12.0, .apex_mm = 5.5};
  const ExaminedAttempt made = examined(testing::akin_scenario(), attempt);
  expect_exact(made, "wedge_error_deg", "lateral", 2.0, pose_deg);
  expect_exact(made, "transverse_tilt_deg", "cut2", 5.0, pose_deg);
  const ExaminedAttempt straight = examined(testing::akin_scenario(), AkinAttempt{.apex_mm = 5.5});
  // Where planes meet that are ten degrees apart the poses' rounding counts six times.
  expect_exact(straight, "apex_offset_mm", "lateral", 1.0, 6.0 * pose_mm);
  expect_exact(straight, "base_mm", "lateral", 13.0 * std::tan(radian_from_degree(10.0)));
  expect_exact(
      examined(testing::akin_scenario(), AkinAttempt{.sagittal1_deg = 4.0, .sagittal2_deg = 4.0}),
      "apex_angle_deg", "lateral", 4.0, 12.0 * pose_deg);
}

/// Of the oval's section from the base at z = -7.5 to z.
double oval_area_to(double z_mm) {
  const double share = z_mm / 7.5;
  return 7.5 * 6.25 * (0.5 * pi + std::asin(share) + share * std::sqrt(1.0 - share * share));
}

// The face reaches from the base to where the second kerf came through it, and stands apart by the
// distance to the hinge.
TEST(Bounds, HoldForTheClosedWedge) {
  const double end_z_mm = 6.5 - testing::kerf_mm / std::sin(radian_from_degree(10.0));
  for (const double degree : {7.0, 8.5, 9.2}) {
    const ExaminedAttempt made = closed_by(degree);
    const double slope = std::sin(radian_from_degree(10.0 - degree));
    expect_exact(made, "gap_mm", "lateral", 14.0 * slope);
    const double touching_z_mm = std::max(-7.5, 6.5 - 0.2 / slope);
    const double share = 1.0 - oval_area_to(touching_z_mm) / oval_area_to(end_z_mm);
    expect_exact(made, "contact_share", "lateral", share, 2.0 * pose_mm);
    EXPECT_LT(made.found("contact_share", "lateral").bound, 0.15);
  }
}

/// What faces and pieces tell, and closing.
std::vector<Measurement> measured_on(const Evidence& evidence) {
  std::vector<Measurement> all = measure_geometry(evidence, BoneSurfaces(evidence.bones));
  std::vector<Measurement> closings = measure_closings(evidence);
  std::move(closings.begin(), closings.end(), std::back_inserter(all));
  return all;
}

/// The same faces with a sample at every half step.
std::vector<std::vector<CutFace>> finer_faces(const Examination& examination) {
  std::vector<std::vector<CutFace>> faces = examination.faces;
  for (std::vector<CutFace>& cut : faces) {
    for (CutFace& face : cut) {
      const simulator::KerfPlane& plane = examination.rebuilt.fields.plane(face.kerf);
      const int side = glm::dot(axis_z(plane.bone_from_kerf), face.plane.normal) >= 0.0 ? -1 : 1;
      FaceSamples samples = sample_wall(examination.rebuilt.pieces.at(face.piece),
                                        {face.kerf, side}, plane, 0.5 * sample_step_mm);
      EXPECT_GT(samples.points_in_bone_mm.size(), 3 * face.samples_in_bone_mm.size());
      face.samples_in_bone_mm = std::move(samples.points_in_bone_mm);
      face.step_mm = samples.step_mm;
      face.border_share = samples.border_share;
      face.plane = fit_plane(face.samples_in_bone_mm, face.plane.normal).value();
    }
  }
  return faces;
}

void expect_halving_holds(const ExaminedAttempt& made) {
  const Evidence as_is = made.evidence();
  const auto faces = finer_faces(made.examination);
  const Evidence finer{as_is.scenario, as_is.plan,  as_is.rebuilt,
                       faces,          as_is.bones, as_is.recording};
  const std::vector<Measurement> coarse = measured_on(as_is), fine = measured_on(finer);
  ASSERT_EQ(coarse.size(), fine.size());
  for (std::size_t index = 0; index < coarse.size(); ++index) {
    const Measurement& each = coarse[index];
    ASSERT_EQ(each.metric, fine[index].metric);
    if (!each.is_measured()) continue;
    EXPECT_NEAR(each.value, fine[index].value, each.bound) << each.metric << " " << each.cut;
  }
}

TEST(Bounds, HoldWhereTheGridOfAFaceIsHalved) {
  for (const double tilt_deg : {0.0, 2.3, -7.0}) {
    expect_halving_holds(examined(
        testing::block_scenario(),
        {Stroke{.face_z_mm = -7.3 + 0.1 * tilt_deg, .tilt_rad = radian_from_degree(tilt_deg)}}));
  }
  expect_halving_holds(closed_by(10.0));
  expect_halving_holds(closed_by(6.3, {.entry_x_mm = 6.4,
                                       .transverse_deg = 3.1,
                                       .sagittal1_deg = -2.0,
                                       .wedge_deg = 8.0,
                                       .sagittal2_deg = 1.5,
                                       .apex_mm = 6.1}));
  // Cut half way: the border is the blade's.
  expect_halving_holds(examined(testing::block_scenario(),
                                {Stroke{.tilt_rad = radian_from_degree(3.0), .last_y_mm = 1.37}}));
}

/// Of the hinge's kerfs on a field of half the spacing, the least left and the furthest beyond.
std::pair<double, double> bridge_on_finer_field(const ExaminedAttempt& made) {
  const simulator::FieldGrid finer{.spacing_mm = 0.025, .u_count = 3201, .v_count = 3201};
  simulator::KerfSet kerfs(made.scenario.saw.blade, made.bone.world_from_bone, finer);
  open_kerfs(
      kerfs, made.recording, [](std::int64_t) {},
      [](std::size_t, std::span<const simulator::RisenKerf>) {});
  const simulator::CutSolid solid = simulator::uncut_solid(solid_of(made.bone));
  const simulator::Bvh tree(solid.mesh);
  double left_mm = INFINITY, beyond_mm = 0.0;
  for (std::int32_t kerf = 0; kerf < kerfs.count(); ++kerf) {
    const auto gap = measure_hinge_gap(slice_section(solid, tree, kerfs.plane(kerf)),
                                       outline_of(kerfs.field(kerf)),
                                       made.examination.plan.hinges.front().bridge.line);
    left_mm = std::min(left_mm, gap.value().thickness_mm);
    beyond_mm = std::max(beyond_mm, gap.value().over_cut_mm);
  }
  return {left_mm, beyond_mm};
}

TEST(Bounds, HoldWhereTheFieldIsHalved) {
  for (const double reach_mm : {6.13, 7.02, 7.81}) {
    const ExaminedAttempt made =
        examined(testing::akin_scenario(), AkinAttempt{.transverse_deg = 1.7,
                                                       .sagittal1_deg = 2.4,
                                                       .reach1_mm = reach_mm,
                                                       .reach2_mm = reach_mm - 0.21});
    const auto [left_mm, beyond_mm] = bridge_on_finer_field(made);
    expect_exact(made, "hinge_mm", "lateral", left_mm, 0.0);
    expect_exact(made, "over_cut_mm", "lateral", beyond_mm, 0.0);
  }
}

TEST(Bounds, HoldForTheJointsMarginWhereItsGridIsHalved) {
  scenarios::Scenario scenario = testing::block_scenario();
  scenarios::JointSurface joint;
  joint.name = joint.title = "end";
  joint.around = "axis_proximal";
  joint.radius_mm = 100.0;
  joint.facing_in_bone = {0.0, -1.0, 0.0};
  joint.within_rad = 0.1;
  scenario.joint_surfaces = {joint};
  for (const double last_y_mm : {3.33, 0.0, -4.71}) {
    const ExaminedAttempt made =
        examined(scenario, {Stroke{.tilt_rad = 0.05, .last_y_mm = last_y_mm}});
    const auto finer =
        measure_joint_margin(made.examination.rebuilt, made.examination.plan, made.bone, 0.05);
    expect_exact(made, "joint_margin_mm", "", finer.value().margin_mm, 0.0);
  }
}

TEST(Bounds, AreNoughtForWhatIsCountedAndSmallForWhatIsPlane) {
  const ExaminedAttempt made = closed_by(9.0);
  for (const Measurement& each : made.examination.measurements) {
    if (!each.is_measured()) continue;
    const scenarios::MetricName& metric = *scenarios::find_metric(each.metric);
    if (scenarios::is_counted(metric)) {
      EXPECT_EQ(each.bound, 0.0) << each.metric;
      continue;
    }
    EXPECT_GE(each.bound, rounding_bound) << each.metric;
    const bool is_of_planes = metric.unit == "deg";
    EXPECT_LT(each.bound, is_of_planes ? 1e-3 : 1.0) << each.metric;
  }
}

}  // namespace
}  // namespace hallux::assessment

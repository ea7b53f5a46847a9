/// The worked Akin example: right hallux proximal phalanx, section 15 x 12.5 mm, cut 1 at 6 mm,
/// wedge 10 degrees, apex 1 mm short of the lateral cortex. Frame: x distal, y dorsal, z lateral.
/// The metrics below are the example's own, computed elsewhere and rounded to 1e-3; its item points
/// are rounded to 1e-2.
#include "assessment/metrics/akin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/points.h"
#include "simulator/base/units.h"

namespace hallux::assessment {
namespace {

constexpr double half_width_mm = 7.5, half_height_mm = 6.25, grid_mm = 0.25;
constexpr double planned_entry_mm = 6.0, planned_wedge_deg = 10.0, planned_apex_mm = 6.5;

/// Tilts: transverse (positive: medial edge distal) and sagittal (positive: plantar edge distal),
/// of both cuts.
struct Attempt {
  double x_entry_mm, transverse_deg, sagittal1_deg, wedge_deg, sagittal2_deg, apex_mm, reach_mm;
  double flatness_mm;
};

struct CutVector {
  double angle_deg, transverse_deg, sagittal_deg, entry_mm, exit_mm, max_mm, mean_mm;
};

struct Expected {
  CutVector cut1, cut2;
  double wedge_error_deg, wedge_sagittal_deg, base_mm, hinge_mm;
  std::array<double, 7> points;
};

constexpr Attempt expert{6.3, 0.8, -1.0, 10.4, -0.6, 6.4, 6.4, 0.15};
constexpr Attempt intermediate{6.9, -2.4, 3.1, 12.3, 1.4, 6.9, 6.9, 0.38};
constexpr Attempt novice{8.2, 5.2, -6.5, 15.4, -2.4, 7.6, 10.6, 0.85};

constexpr Expected expert_vector{{1.281, 0.8, -1.0, 0.3, 0.105, 0.345, 0.199},
                                 {1.337, 1.2, -0.6, 0.39, 0.086, 0.394, 0.229},
                                 0.4,
                                 0.4,
                                 2.558,
                                 1.1,
                                 {7.68, 8.0, 5.71, 12.0, 6.0, 7.0, 2.83}};
constexpr Expected intermediate_vector{{3.918, -2.4, 3.1, 0.9, 1.487, 1.674, 1.21},
                                       {1.383, -0.1, 1.4, 1.548, 1.573, 1.688, 1.538},
                                       2.3,
                                       -1.7,
                                       3.117,
                                       0.6,
                                       {4.67, 4.24, 5.67, 8.07, 4.69, 5.25, 2.07}};
constexpr Expected novice_vector{{8.296, 5.2, -6.5, 2.2, 0.926, 2.497, 1.517},
                                 {10.833, 10.6, -2.4, 4.033, 1.239, 3.984, 2.498},
                                 5.4,
                                 4.1,
                                 4.302,
                                 0.0,
                                 {0.0, 1.61, 0.0, 1.31, 2.07, 0.0, 0.5}};

FacePlane tilted_plane(double transverse_deg, double sagittal_deg, const Vec3& through_mm) {
  const double t = std::tan(radian_from_degree(transverse_deg));
  const double s = std::tan(radian_from_degree(sagittal_deg));
  const Vec3 normal = Vec3{1.0, s, t} / std::sqrt(1.0 + t * t + s * s);
  return {normal, glm::dot(normal, through_mm)};
}

/// The point of the plane at (y, z).
Vec3 on_plane(const FacePlane& plane, double y_mm, double z_mm) {
  const Vec3 foot{0.0, y_mm, z_mm};
  return foot + distance_along_mm(plane, foot, Vec3{1.0, 0.0, 0.0}) * Vec3{1.0, 0.0, 0.0};
}

std::pair<FacePlane, FacePlane> planes_of(const Attempt& attempt) {
  const FacePlane first = tilted_plane(attempt.transverse_deg, attempt.sagittal1_deg,
                                       Vec3{attempt.x_entry_mm, 0.0, -half_width_mm});
  const FacePlane second =
      tilted_plane(attempt.transverse_deg + attempt.wedge_deg, attempt.sagittal2_deg,
                   on_plane(first, 0.0, attempt.apex_mm));
  return {first, second};
}

/// The elliptic section from the medial cortex to where the blade reached.
std::vector<Vec3> samples_of(const FacePlane& plane, double reach_mm) {
  std::vector<Vec3> samples;
  for (int i = 0; i <= 60; ++i) {
    const double z = -half_width_mm + i * grid_mm;
    if (z > reach_mm + 1e-9) break;
    for (int j = 0; j <= 50; ++j) {
      const double y = -half_height_mm + j * grid_mm;
      const double across = y / half_height_mm, along = z / half_width_mm;
      if (across * across + along * along <= 1.0 + 1e-9) samples.push_back(on_plane(plane, y, z));
    }
  }
  return samples;
}

AkinMetrics metrics_of(const Attempt& attempt) {
  const auto [planned1, planned2] =
      planes_of({planned_entry_mm, 0.0, 0.0, planned_wedge_deg, 0.0, planned_apex_mm, 0.0, 0.0});
  const auto [first, second] = planes_of(attempt);
  const double reach_mm = std::min(attempt.reach_mm, half_width_mm);
  const std::vector<Vec3> samples1 = samples_of(first, reach_mm);
  const std::vector<Vec3> samples2 = samples_of(second, reach_mm);
  const OffsetPoints offsets{Vec3{0.0, 0.0, -half_width_mm}, Vec3{0.0, 0.0, planned_apex_mm},
                             Vec3{1.0, 0.0, 0.0}};
  return measure_akin(
      {{first, samples1}, {second, samples2}, half_width_mm - reach_mm, attempt.flatness_mm},
      {planned1, planned2, offsets});
}

FacePlane mirrored(const FacePlane& plane) {
  return {Vec3{plane.normal.x, plane.normal.y, -plane.normal.z}, plane.offset_mm};
}

std::vector<Vec3> mirrored(std::vector<Vec3> points) {
  for (Vec3& point : points) point.z = -point.z;
  return points;
}

/// The same attempt on a left foot that was not mirrored when it was loaded.
AkinMetrics mirrored_metrics_of(const Attempt& attempt) {
  const auto [planned1, planned2] =
      planes_of({planned_entry_mm, 0.0, 0.0, planned_wedge_deg, 0.0, planned_apex_mm, 0.0, 0.0});
  const auto [first, second] = planes_of(attempt);
  const double reach_mm = std::min(attempt.reach_mm, half_width_mm);
  const std::vector<Vec3> samples1 = mirrored(samples_of(first, reach_mm));
  const std::vector<Vec3> samples2 = mirrored(samples_of(second, reach_mm));
  const OffsetPoints offsets{Vec3{0.0, 0.0, half_width_mm}, Vec3{0.0, 0.0, -planned_apex_mm},
                             Vec3{1.0, 0.0, 0.0}};
  return measure_akin({{mirrored(first), samples1},
                       {mirrored(second), samples2},
                       half_width_mm - reach_mm,
                       attempt.flatness_mm},
                      {mirrored(planned1), mirrored(planned2), offsets});
}

void expect_cut(const FaceMetrics& cut, const CutVector& expected) {
  constexpr double rounded = 1e-3;
  EXPECT_NEAR(cut.angle_deg, expected.angle_deg, rounded);
  EXPECT_NEAR(cut.transverse_deg, expected.transverse_deg, rounded);
  EXPECT_NEAR(cut.sagittal_deg, expected.sagittal_deg, rounded);
  EXPECT_NEAR(cut.entry_mm, expected.entry_mm, rounded);
  EXPECT_NEAR(cut.exit_mm, expected.exit_mm, rounded);
  EXPECT_NEAR(cut.location_mm, expected.max_mm, rounded);
  EXPECT_NEAR(cut.mean_mm, expected.mean_mm, rounded);
}

/// Items A1 to A7 with the example's weights and knots.
std::array<std::int64_t, 7> points_of(const AkinMetrics& metrics) {
  return {lower_points_milli(metrics.cut1.angle_deg, 1.0, 8.0, 8000),
          lower_points_milli(metrics.cut1.location_mm, 0.5, 3.0, 8000),
          lower_points_milli(metrics.cut2.angle_deg, 1.0, 8.0, 6000),
          lower_points_milli(std::abs(metrics.wedge_error_deg), 0.5, 6.0, 12000),
          lower_points_milli(std::abs(metrics.wedge_sagittal_deg), 0.5, 6.0, 6000),
          band_points_milli(metrics.hinge_mm, {0.0, 0.8, 2.0, 3.5}, 7000),
          lower_points_milli(metrics.flatness_mm, 0.1, 1.0, 3000)};
}

void expect_vector(const Attempt& attempt, const Expected& expected) {
  const AkinMetrics metrics = metrics_of(attempt);
  expect_cut(metrics.cut1, expected.cut1);
  expect_cut(metrics.cut2, expected.cut2);
  EXPECT_NEAR(metrics.wedge_deg, attempt.wedge_deg, 1e-3);
  EXPECT_NEAR(metrics.wedge_error_deg, expected.wedge_error_deg, 1e-3);
  EXPECT_NEAR(metrics.wedge_sagittal_deg, expected.wedge_sagittal_deg, 1e-3);
  EXPECT_NEAR(metrics.base_mm, expected.base_mm, 1e-3);
  EXPECT_NEAR(metrics.hinge_mm, expected.hinge_mm, 1e-3);
  const std::array<std::int64_t, 7> points = points_of(metrics);
  for (std::size_t item = 0; item < points.size(); ++item) {
    EXPECT_NEAR(static_cast<double>(points[item]) / 1000.0, expected.points[item], 6e-3)
        << "A" << item + 1;
  }
}

TEST(Akin, ExpertHasTheMetricsAndPointsOfTheExample) { expect_vector(expert, expert_vector); }
TEST(Akin, IntermediateHasTheMetricsAndPointsOfTheExample) {
  expect_vector(intermediate, intermediate_vector);
}
TEST(Akin, NoviceHasTheMetricsAndPointsOfTheExample) { expect_vector(novice, novice_vector); }

TEST(Akin, PerfectPlanesEarnEveryPointOfTheFirstFiveItems) {
  const AkinMetrics metrics = metrics_of(
      {planned_entry_mm, 0.0, 0.0, planned_wedge_deg, 0.0, planned_apex_mm, planned_apex_mm, 0.0});
  const std::array<std::int64_t, 7> points = points_of(metrics);
  EXPECT_EQ(points, (std::array<std::int64_t, 7>{8000, 8000, 6000, 12000, 6000, 7000, 3000}));
}

TEST(Akin, AMirroredFootGivesTheSameNumbers) {
  for (const Attempt& attempt : {expert, intermediate, novice}) {
    const AkinMetrics right = metrics_of(attempt), left = mirrored_metrics_of(attempt);
    EXPECT_NEAR(left.cut1.angle_deg, right.cut1.angle_deg, 1e-9);
    EXPECT_NEAR(left.cut1.location_mm, right.cut1.location_mm, 1e-9);
    EXPECT_NEAR(left.cut2.angle_deg, right.cut2.angle_deg, 1e-9);
    // The transverse tilt counts towards z, so it and the wedge change sign; both are scored
    // without.
    EXPECT_NEAR(left.wedge_error_deg, -right.wedge_error_deg, 1e-9);
    EXPECT_NEAR(left.wedge_sagittal_deg, right.wedge_sagittal_deg, 1e-9);
    EXPECT_NEAR(left.base_mm, right.base_mm, 1e-9);
    EXPECT_EQ(points_of(left), points_of(right));
  }
}

}  // namespace
}  // namespace hallux::assessment

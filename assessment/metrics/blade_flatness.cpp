#include "assessment/metrics/blade_flatness.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "assessment/metrics/face_plane.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

namespace {

/// Both ends and the middle of the tooth line.
constexpr std::size_t points_per_sample = 3;

/// The most by which a point's distance changes from a sample to the next.
double greatest_change_mm(std::span<const ToothPoint> points,
                          std::span<const double> residuals_mm) {
  double greatest_mm = 0.0;
  for (std::size_t index = points_per_sample; index < points.size(); ++index) {
    const ToothPoint& before = points[index - points_per_sample];
    const bool follows = points[index].tick - before.tick <= simulator::ticks_per_line_max;
    if (!follows) continue;
    greatest_mm = std::max(greatest_mm,
                           std::abs(residuals_mm[index] - residuals_mm[index - points_per_sample]));
  }
  return greatest_mm;
}

}  // namespace

std::optional<Flatness> measure_flatness(std::span<const ToothPoint> points) {
  std::vector<Vec3> places_mm;
  for (const ToothPoint& point : points) places_mm.push_back(point.point_in_bone_mm);
  const std::optional<FacePlane> plane = fit_plane(places_mm, Vec3{1.0, 0.0, 0.0});
  if (!plane) return std::nullopt;
  Flatness flatness;
  std::vector<double> residuals_mm;
  double worst_mm = -1.0;
  for (const ToothPoint& point : points) {
    residuals_mm.push_back(signed_distance_mm(*plane, point.point_in_bone_mm));
    if (std::abs(residuals_mm.back()) <= worst_mm) continue;
    worst_mm = std::abs(residuals_mm.back());
    flatness.tick = point.tick;
    flatness.point_in_bone_mm = point.point_in_bone_mm;
  }
  flatness.flatness_mm = percentile(residuals_mm, 0.975) - percentile(residuals_mm, 0.025);
  flatness.bound_mm = 2.0 * greatest_change_mm(points, residuals_mm);
  return flatness;
}

}  // namespace hallux::assessment

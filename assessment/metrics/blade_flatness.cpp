#include "assessment/metrics/blade_flatness.h"

#include <cmath>
#include <vector>

#include "assessment/metrics/face_plane.h"

namespace hallux::assessment {

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
  return flatness;
}

}  // namespace hallux::assessment

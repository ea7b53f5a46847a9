#include "assessment/metrics/face_metrics.h"

#include <cmath>

#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

/// The same angle in (-180, 180].
double wrapped_deg(double angle_deg) noexcept {
  while (angle_deg > 180.0) angle_deg -= 360.0;
  while (angle_deg <= -180.0) angle_deg += 360.0;
  return angle_deg;
}

double offset_mm(const FacePlane& actual, const FacePlane& planned, const Vec3& point_mm,
                 const Vec3& direction) noexcept {
  return distance_along_mm(actual, point_mm, direction) -
         distance_along_mm(planned, point_mm, direction);
}

void add_distances(FaceMetrics& metrics, std::span<const Vec3> samples_in_bone_mm,
                   const FacePlane& planned) {
  if (samples_in_bone_mm.empty()) return;
  double sum = 0.0, squares = 0.0;
  for (const Vec3& sample : samples_in_bone_mm) {
    const double distance_mm = signed_distance_mm(planned, sample);
    sum += std::abs(distance_mm);
    squares += distance_mm * distance_mm;
    if (std::abs(distance_mm) <= metrics.location_mm) continue;
    metrics.location_mm = std::abs(distance_mm);
    metrics.worst_mm = distance_mm;
    metrics.worst_point_in_bone_mm = sample;
  }
  const double count = static_cast<double>(samples_in_bone_mm.size());
  metrics.mean_mm = sum / count;
  metrics.rms_mm = std::sqrt(squares / count);
}

}  // namespace

double transverse_tilt_rad(const Vec3& normal) noexcept { return std::atan2(normal.z, normal.x); }
double sagittal_tilt_rad(const Vec3& normal) noexcept { return std::atan2(normal.y, normal.x); }

FaceMetrics measure_face(std::span<const Vec3> samples_in_bone_mm, const FacePlane& actual,
                         const FacePlane& planned, const OffsetPoints& offsets) {
  FaceMetrics metrics;
  metrics.angle_deg = degree_from_radian(angle_between_rad(actual.normal, planned.normal));
  metrics.transverse_deg = wrapped_deg(
      degree_from_radian(transverse_tilt_rad(actual.normal) - transverse_tilt_rad(planned.normal)));
  metrics.sagittal_deg = wrapped_deg(
      degree_from_radian(sagittal_tilt_rad(actual.normal) - sagittal_tilt_rad(planned.normal)));
  metrics.entry_mm = offset_mm(actual, planned, offsets.entry_in_bone_mm, offsets.direction);
  metrics.exit_mm = offset_mm(actual, planned, offsets.exit_in_bone_mm, offsets.direction);
  add_distances(metrics, samples_in_bone_mm, planned);
  return metrics;
}

Vec3 deepest_direction(const FacePlane& actual, const FacePlane& planned) noexcept {
  // With n_actual = cos n + sin e the height above the planned face falls along +e.
  return actual.normal - glm::dot(actual.normal, planned.normal) * planned.normal;
}

}  // namespace hallux::assessment

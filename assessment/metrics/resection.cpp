#include "assessment/metrics/resection.h"

#include <algorithm>

namespace hallux::assessment {

ResectionMetrics measure_resection(const FacePlane& actual, const ResectionPlan& plan) noexcept {
  const Vec3& to_waste = plan.face.normal;
  const double depth_mm = distance_along_mm(actual, plan.depth_point_in_bone_mm, to_waste);
  const double planned_depth_mm = -signed_distance_mm(plan.face, plan.depth_point_in_bone_mm);
  const double exit_mm = distance_along_mm(actual, plan.exit_point_in_bone_mm, to_waste);
  const double planned_exit_mm = -signed_distance_mm(plan.face, plan.exit_point_in_bone_mm);
  ResectionMetrics metrics;
  metrics.depth_error_mm = depth_mm - planned_depth_mm;
  metrics.past_landmark_mm = std::max(0.0, -depth_mm);
  metrics.step_error_mm = exit_mm - planned_exit_mm;
  metrics.notch_mm = std::max(0.0, -metrics.step_error_mm);
  return metrics;
}

}  // namespace hallux::assessment

#include "assessment/metrics/akin.h"

#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

double wedge_deg(const FacePlane& first, const FacePlane& second) noexcept {
  return degree_from_radian(transverse_tilt_rad(second.normal) - transverse_tilt_rad(first.normal));
}

}  // namespace

AkinMetrics measure_akin(const AkinCuts& cuts, const AkinPlan& plan) {
  const FacePlane& first = cuts.cut1.plane;
  const FacePlane& second = cuts.cut2.plane;
  AkinMetrics metrics;
  metrics.cut1 = measure_face(cuts.cut1.samples_in_bone_mm, first, plan.cut1, plan.offsets);
  metrics.cut2 = measure_face(cuts.cut2.samples_in_bone_mm, second, plan.cut2, plan.offsets);
  metrics.wedge_deg = wedge_deg(first, second);
  metrics.wedge_error_deg = metrics.wedge_deg - wedge_deg(plan.cut1, plan.cut2);
  metrics.wedge_sagittal_deg =
      degree_from_radian(sagittal_tilt_rad(second.normal) - sagittal_tilt_rad(first.normal));
  const Vec3& entry_mm = plan.offsets.entry_in_bone_mm;
  metrics.base_mm = distance_along_mm(second, entry_mm, plan.offsets.direction) -
                    distance_along_mm(first, entry_mm, plan.offsets.direction);
  metrics.hinge_mm = cuts.hinge_mm;
  metrics.flatness_mm = cuts.flatness_mm;
  return metrics;
}

}  // namespace hallux::assessment

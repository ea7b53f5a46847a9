/// How deep a resection is and how it leaves the bone: the metrics of a Silver exostectomy beside
/// angle and location. Inside this room only.
#pragma once

#include "assessment/metrics/face_plane.h"

namespace hallux::assessment {

/// What the plan asks of the face at its two landmarks.
struct ResectionPlan {
  /// Normal to the waste.
  FacePlane face;
  Vec3 depth_point_in_bone_mm{0.0, 0.0, 0.0};
  Vec3 exit_point_in_bone_mm{0.0, 0.0, 0.0};
};

/// Signed numbers count along the planned normal: positive towards the waste (too little taken).
struct ResectionMetrics {
  /// Face at the depth landmark, actual minus planned.
  double depth_error_mm = 0.0;
  /// How far the face passes the depth landmark to the kept side; 0 if it does not.
  double past_landmark_mm = 0.0;
  /// Face at the exit landmark, actual minus planned: a ledge above 0, a notch below.
  double step_error_mm = 0.0;
  /// The part of the step that goes into the kept bone.
  double notch_mm = 0.0;
};

/// needs   the faces are not at right angles to each other
/// source  docs/metrics.md, "Silver"
ResectionMetrics measure_resection(const FacePlane& actual, const ResectionPlan& plan) noexcept;

}  // namespace hallux::assessment

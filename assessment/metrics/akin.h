/// The accuracy of an Akin osteotomy: two faces, the wedge between them and the hinge that is left
/// (items A1 to A7). Inside this room only.
#pragma once

#include <span>

#include "assessment/metrics/face_metrics.h"

namespace hallux::assessment {

/// A face as it was cut: its plane and samples on it. Both normals of an Akin look distal.
struct AkinFace {
  FacePlane plane;
  std::span<const Vec3> samples_in_bone_mm;
};

struct AkinPlan {
  FacePlane cut1, cut2;
  /// Entry at the medial cortex, exit at the planned apex, counted distally.
  OffsetPoints offsets;
};

struct AkinCuts {
  AkinFace cut1, cut2;
  /// Intact bone at the lateral cortex; 0 where it is cut through.
  double hinge_mm = 0.0;
  /// See measure_flatness.
  double flatness_mm = 0.0;
};

struct AkinMetrics {
  /// A1 cut1.angle_deg, A2 cut1.location_mm, A3 cut2.angle_deg.
  FaceMetrics cut1, cut2;
  /// Difference of the faces' transverse tilts.
  double wedge_deg = 0.0;
  /// A4: actual minus planned.
  double wedge_error_deg = 0.0;
  /// A5: difference of the faces' sagittal tilts; positive: plantar base.
  double wedge_sagittal_deg = 0.0;
  /// Gap at the entry.
  double base_mm = 0.0;
  /// A6, as given.
  double hinge_mm = 0.0;
  /// A7, as given.
  double flatness_mm = 0.0;
};

/// source  docs/metrics.md, "Akin"
AkinMetrics measure_akin(const AkinCuts& cuts, const AkinPlan& plan);

}  // namespace hallux::assessment

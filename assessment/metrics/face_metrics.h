/// How one finished face lies against the planned one. Inside this room only.
#pragma once

#include <span>

#include "assessment/metrics/face_plane.h"

namespace hallux::assessment {

/// The points at which a face's entry and exit offsets are said, and the direction in which they
/// count.
struct OffsetPoints {
  Vec3 entry_in_bone_mm{0.0, 0.0, 0.0};
  Vec3 exit_in_bone_mm{0.0, 0.0, 0.0};
  /// Unit; x is distal.
  Vec3 direction{1.0, 0.0, 0.0};
};

/// Signed offsets are actual minus planned.
struct FaceMetrics {
  /// Between the two normals.
  double angle_deg = 0.0;
  /// eT: difference of atan2(n_z, n_x) in the bone frame.
  double transverse_deg = 0.0;
  /// eS: difference of atan2(n_y, n_x) in the bone frame.
  double sagittal_deg = 0.0;
  double entry_mm = 0.0, exit_mm = 0.0;
  /// Greatest one-sided distance of a sample from the planned face.
  double location_mm = 0.0;
  /// Mean of the distances, without sign.
  double mean_mm = 0.0;
  double rms_mm = 0.0;
  /// The sample of `location_mm`, with its sign: positive towards the planned normal.
  double worst_mm = 0.0;
  Vec3 worst_point_in_bone_mm{0.0, 0.0, 0.0};
};

/// needs   both normals look to the same side; samples may be empty (the distances are then 0)
/// source  docs/metrics.md; the location is a one-sided distance: an ISO 1101 zone of position is
///         twice as wide
FaceMetrics measure_face(std::span<const Vec3> samples_in_bone_mm, const FacePlane& actual,
                         const FacePlane& planned, const OffsetPoints& offsets);

/// Transverse and sagittal tilt of a normal in the bone frame: atan2(n_z, n_x) and atan2(n_y, n_x)
/// [rad].
double transverse_tilt_rad(const Vec3& normal) noexcept;
double sagittal_tilt_rad(const Vec3& normal) noexcept;

/// The direction in the planned face towards which the actual one lies deepest (furthest against
/// the normal); length is the sine of the tilt.
Vec3 deepest_direction(const FacePlane& actual, const FacePlane& planned) noexcept;

}  // namespace hallux::assessment

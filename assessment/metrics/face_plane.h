/// Planes through measured points: total least squares with trimming, angles, percentiles.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "simulator/base/vector.h"

namespace hallux::assessment {

/// Points p with normal . p = offset.
struct FacePlane {
  /// Unit length.
  Vec3 normal{1.0, 0.0, 0.0};
  double offset_mm = 0.0;
};

/// Positive on the side of the normal [mm].
double signed_distance_mm(const FacePlane& plane, const Vec3& point_mm) noexcept;
/// How far one goes from `point_mm` along the unit `direction` to meet the plane [mm]; infinite
/// where they are parallel.
double distance_along_mm(const FacePlane& plane, const Vec3& point_mm,
                         const Vec3& direction) noexcept;
/// The angle between two unit vectors [0, pi]; exact also near 0, where acos is not.
double angle_between_rad(const Vec3& a, const Vec3& b) noexcept;

/// The plane of least squared distances, found again without the points beyond 2.5 standard
/// deviations until none is left out any more. Its normal looks to the side of `side`.
/// errors  nothing where the points lie on a line or are fewer than three
std::optional<FacePlane> fit_plane(std::span<const Vec3> points_mm, const Vec3& side);

/// The value below which `fraction` of the values lie, linear between neighbours in order.
/// needs   values are not empty; fraction in [0, 1]
double percentile(std::vector<double> values, double fraction);

}  // namespace hallux::assessment

/// Points and directions that a scenario of format 2 names, to place cuts, fragments and implants
/// by: each is made from landmarks, axes and earlier names, so that it lies right on any patient.
/// Inside this corner only.
#pragma once

#include <string>
#include <vector>

namespace hallux::scenarios {

/// Of a way from one point to another.
struct MoveAlong {
  /// A direction.
  std::string along;
  double mm = 0.0;
};

/// Moved      `from`, moved along directions
/// Between    on the line from `from` to `to`, at a share of the way
/// OnSurface  where the ray from `from` along a direction leaves the bone for the last time
enum class PointKind { Moved, Between, OnSurface };

struct NamedPoint {
  std::string name;
  /// Whose landmarks and surface are meant; empty: the patient's first.
  std::string bone;
  PointKind kind = PointKind::Moved;
  /// Landmarks of that bone, or points named before.
  std::string from, to;
  /// 0 at `from`, 1 at `to`.
  double share = 0.0;
  std::vector<MoveAlong> moves;
  /// OnSurface: the direction of the ray.
  std::string along;
  std::string origin;
};

/// Between      from the point `first` to the point `second`
/// SquareToBoth square to two directions, by the right hand from the first to the second
/// Turned       `first` turned about `second`, by the right hand
/// LaidSquare   `first` without its part along `second`
enum class DirectionKind { Between, SquareToBoth, Turned, LaidSquare };

/// Of unit length.
struct NamedDirection {
  std::string name;
  /// Whose landmarks and axes are meant; empty: the patient's first.
  std::string bone;
  DirectionKind kind = DirectionKind::Between;
  std::string first, second;
  double turn_rad = 0.0;
  std::string origin;
};

}  // namespace hallux::scenarios

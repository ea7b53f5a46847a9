/// What still stands of a bone while it is being cut: original bone minus opened kerfs minus bodies
/// taken out. Inside this room only.
///
/// Nothing is rebuilt when a kerf grows: the surface is put together from the original bone's tree
/// and the kerfs' fields when it is asked for. Its parts:
///
///     skin    the original surface outside every opened region
///     wall    a kerf's plane at +-thickness / 2, over its region, where bone stands behind
///     front   the upright face over the rim of a region
///
/// The nearest point of a part is either straight across from the point asked about or on the
/// part's border, and each border belongs to two parts, of which one has it as its own nearest
/// point or as a line that is looked at apart: skin over the planes by clipping triangles, skin on
/// a front by a ray along the rim, walls of two kerfs by the line in which they meet.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "simulator/cutting/field/kerf_set.h"
#include "simulator/cutting/remaining/rigid_advance.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

enum class BoneSide : std::uint8_t { Skin, Wall, Front };

struct RemainingPoint {
  double distance_mm = 0.0;
  Vec3 point_in_bone_mm{0.0, 0.0, 0.0};
  /// Out of the bone, unit length; of a triangle where skin is met.
  Vec3 normal{0.0, 0.0, 0.0};
  BoneSide side = BoneSide::Skin;
  /// Of a wall or front.
  std::int32_t kerf = -1;
};

/// Of one fragment. Borrows all it names. All questions: total, without allocation, bounded by the
/// trees and the fields.
struct RemainingBone {
  /// The outer surface as it was before these kerfs.
  const Bvh& original;
  FragmentKerfs kerfs;
  /// Bodies that kerfs cut free, in the frame of the bone.
  std::span<const Bvh* const> taken_out;

  /// Whether this point lies in a body that was taken out.
  bool is_taken_out(const Vec3& point_in_bone_mm) const noexcept;
  bool contains(const Vec3& point_in_bone_mm) const noexcept;

  /// The nearest point of what stands; nothing where it is `within_mm` away or more.
  /// ensures the distance is that to the solid that commit_patch makes of the same fields, within
  ///         the outline's slack of 0.2 um. Where the nearest place is one at which a front ends
  ///         askew at skin or at another kerf it may be too large, by less than half a node's
  ///         spacing; it is never too small by more than 5 um
  std::optional<RemainingPoint> nearest(
      const Vec3& point_in_bone_mm,
      double within_mm = std::numeric_limits<double>::infinity()) const noexcept;

  /// How far points carried by a body may move before the first of them comes to the surface.
  /// Points less than s apart let features through that are smaller than s. For fragments that are
  /// moved against what stands; nothing calls it yet.
  Advance first_contact(std::span<const Vec3> points_in_body_mm,
                        const RigidMotion& motion) const noexcept;
};

}  // namespace hallux::simulator

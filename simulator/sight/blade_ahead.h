/// The bone that stands ahead of the teeth: how far to it, and how far until they are through.
///
///     teeth |     to bone     |############| to the far side
///
/// For displays, never fed back.
#pragma once

#include <optional>
#include <span>

#include "simulator/cutting/field/kerf_set.h"
#include "simulator/mesh/bvh.h"
#include "simulator/tool/saw.h"

namespace hallux::simulator {

/// What stands of a fragment, in its frame; all borrowed.
struct StandingBone {
  /// Over what it was cut from, its canal with it.
  const Bvh& whole;
  FragmentKerfs kerfs;
  /// Bodies that were taken out of it.
  std::span<const Bvh* const> taken_out;
};

struct BladeAhead {
  /// Along the feed, of the tooth that meets bone first; 0: it stands in bone. Nothing where no
  /// tooth has bone ahead.
  std::optional<double> to_bone_mm;
  /// Along the feed, until the last tooth has no bone ahead.
  std::optional<double> to_far_side_mm;
  /// From the nearest tooth to the bone as it was, in any direction; 0 inside.
  double beside_mm = 0.0;
};

/// Whether bone stands at that point of the fragment's frame.
bool is_standing(const Vec3& point_mm, const StandingBone& bone) noexcept;

/// How far ahead bone is looked for.
inline constexpr double looked_ahead_mm = 80.0;

/// thread  any; about a millisecond
BladeAhead look_ahead(const RigidTransform& bone_from_tool, const Blade& blade,
                      const StandingBone& bone);

/// Of several fragments, each asked in its own frame: the first that is met, the last that is left.
BladeAhead ahead_of_both(const BladeAhead& one, const BladeAhead& other) noexcept;

}  // namespace hallux::simulator

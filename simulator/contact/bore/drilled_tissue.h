/// What still stands beside round holes: tissue, and the nearest surface for a ball of a tool; of
/// one fragment, and of all in the wound. Inside this corner only.
///
/// Of a fragment two things are asked: the tissue at a point, and the nearest standing surface. A
/// hole is open for tools that fit into it; for wider ones its mouth is skin.
#pragma once

#include <optional>
#include <span>

#include "simulator/contact/blade_contact.h"
#include "simulator/contact/wound.h"
#include "simulator/cutting/hole/capsule.h"

namespace hallux::simulator {

/// A ball of a tool and what it has asked: most balls are answered by that alone. The answers are
/// the same without it while the fragment loses bone, gains none, and lies where it was.
struct BallMemory {
  TissueMemory tissue;
  SurfaceMemory surface;
};

/// The middle of a ball of a tool, in the frame that is asked in. Holes are open for it from the
/// radius `needs_mm` on: the ball's own, or, of a tip, that of the whole tool.
struct ToolBall {
  Vec3 centre_mm{0.0, 0.0, 0.0};
  double needs_mm = 0.0;
};

struct BallSurface {
  /// Out of the bone, unit length.
  Vec3 normal{0.0, 0.0, 0.0};
  /// Of the ball's centre above the surface, negative in bone.
  double height_mm = 0.0;
};

/// Of each fragment its holes, in its frame.
using HolesOfFragments = OfFragments<std::span<const Capsule>>;

/// Of one fragment. Borrows what it names.
struct DrilledTissue {
  const RemainingTissue& bone;
  std::span<const Capsule> holes;

  /// Nothing in a hole.
  /// thread  haptic; allocates nothing
  Tissue at(const Vec3& point_in_body_mm, TissueMemory& memory) const noexcept;
  Tissue at(const Vec3& point_in_body_mm) const noexcept;
  /// The surface that a ball is within `within_mm` of, from its centre, or that it is in by at most
  /// a millimetre; deeper there is no way out.
  std::optional<BallSurface> near_ball(const ToolBall& ball, double within_mm,
                                       BallMemory& memory) const noexcept;
};

/// Of all fragments. Borrows what it names.
struct DrilledWound {
  const Wound& wound;
  const HolesOfFragments& holes;

  /// The hardest of all fragments; nothing in a hole.
  /// thread  haptic; allocates nothing
  Tissue at(const Vec3& point_in_wound_mm, OfFragments<TissueMemory>& memory) const noexcept;
  Tissue at(const Vec3& point_in_wound_mm) const noexcept;
  /// The same as if there were no holes.
  Tissue undrilled_at(const Vec3& point_in_wound_mm) const noexcept;
  /// Of the fragments that are near, the one whose surface the ball is nearest to or deepest in.
  std::optional<BallSurface> near_ball(const ToolBall& ball, double within_mm,
                                       OfFragments<BallMemory>& memory) const noexcept;
  bool is_in_hole(const Vec3& point_in_wound_mm) const noexcept;
  /// The fragment with the most of these points in bone, of as many the first; -1: none of them.
  /// memories  one for each point
  /// counts    whether a fragment of that number is asked about
  template <typename Counts>
  std::int32_t fragment_at(std::span<const Vec3> points_in_wound_mm,
                           std::span<OfFragments<TissueMemory>> memories,
                           const Counts& counts) const noexcept {
    std::int32_t found = -1, most = 0;
    for (std::int32_t number = 0; number < fragment_limit; ++number) {
      if (wound.fragment(number) == nullptr || !counts(number)) continue;
      const std::int32_t in_bone = points_in_bone_of(number, points_in_wound_mm, memories);
      if (in_bone > most) found = number;
      most = std::max(most, in_bone);
    }
    return found;
  }

 private:
  DrilledTissue drilled(std::int32_t number, const WoundFragment& standing) const noexcept {
    return {standing.tissue, holes[static_cast<std::size_t>(number)]};
  }
  std::int32_t points_in_bone_of(std::int32_t number, std::span<const Vec3> points_in_wound_mm,
                                 std::span<OfFragments<TissueMemory>> memories) const noexcept;
};

}  // namespace hallux::simulator

/// What still stands of a body beside the round holes in it: tissue, and the nearest surface for a
/// ball of a tool. Inside this corner only.
///
/// Of the body it asks two things: the tissue at a point, and the nearest standing surface. A hole
/// is open for tools that fit into it; for wider ones its mouth is skin.
#pragma once

#include <optional>
#include <span>

#include "simulator/contact/blade_contact.h"
#include "simulator/contact/tissue.h"
#include "simulator/cutting/hole/capsule.h"

namespace hallux::simulator {

/// A ball of a tool and what it has asked: most balls are answered by that alone. The answers are
/// the same without it while the body loses bone and gains none.
struct BallMemory {
  TissueMemory tissue;
  SurfaceMemory surface;
};

/// The middle of a ball of a tool. Holes are open for it from the radius `needs_mm` on: the ball's
/// own, or, of a tip, that of the whole tool.
struct ToolBall {
  Vec3 centre_in_body_mm{0.0, 0.0, 0.0};
  double needs_mm = 0.0;
};

struct BallSurface {
  /// Out of the bone, unit length.
  Vec3 normal{0.0, 0.0, 0.0};
  /// Of the ball's centre above the surface, negative in bone.
  double height_mm = 0.0;
};

/// Borrows what it names.
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

}  // namespace hallux::simulator

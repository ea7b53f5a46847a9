/// The pieces that came free and lie in the wound, as a hand sees them. Inside this corner only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "scenarios/hands/hand_aim.h"
#include "simulator/record/fragment_poses.h"

namespace hallux::scenarios {

/// thread  haptic; allocates nothing
class LoosePieces {
 public:
  /// More than it has room for lie there unseen.
  static constexpr std::size_t most = 8;

  /// fragments  that the event has been applied to
  void observe(const simulator::CutEvent& event,
               const simulator::FragmentPoses& fragments) noexcept;
  /// A piece on the waste's side of each of these faces, the newest first: from then on it is no
  /// longer among them. Nothing where none lies there.
  /// which  the cuts that are meant, by bits
  std::optional<std::int32_t> take_waste(std::span<const AimedCut> cuts,
                                         std::uint32_t which = ~0U) noexcept;
  /// Of that bone, the one that was seen nearest to a point; nothing where none lies there.
  std::optional<std::int32_t> nearest(const Vec3& point_in_bone_mm,
                                      std::size_t bone) const noexcept;

 private:
  struct Piece {
    std::int32_t id = 0;
    /// Of the patient's, in whose frame it lies.
    std::size_t bone = 0;
    Vec3 inside_in_bone_mm{0.0, 0.0, 0.0};
  };

  void forget(std::int32_t piece) noexcept;

  /// Of the piece that is told next.
  std::int32_t fragment_ = 0;
  std::array<Piece, most> pieces_{};
  std::size_t count_ = 0;
};

}  // namespace hallux::scenarios

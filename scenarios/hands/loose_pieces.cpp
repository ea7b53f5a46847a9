#include "scenarios/hands/loose_pieces.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace hallux::scenarios {

namespace {

bool is_waste(const Vec3& point_in_bone_mm, std::size_t bone, std::span<const AimedCut> cuts,
              std::uint32_t which) noexcept {
  for (std::size_t cut = 0; cut < cuts.size(); ++cut) {
    const ReferenceFace& face = cuts[cut].face;
    const bool is_asked = ((which >> cut) & 1U) != 0;
    if (!is_asked) continue;
    const bool is_beyond =
        cuts[cut].bone == bone && glm::dot(face.normal, point_in_bone_mm) > face.offset_mm;
    if (!is_beyond) return false;
  }
  return true;
}

}  // namespace

void LoosePieces::observe(const simulator::CutEvent& event,
                          const simulator::FragmentPoses& fragments) noexcept {
  using simulator::CutEventKind;
  if (event.kind == CutEventKind::PieceRemoved) forget(event.subject);
  if (event.kind == CutEventKind::PieceOfFragment)
    fragment_ = static_cast<std::int32_t>(event.value);
  if (event.kind != CutEventKind::PieceFreed) return;
  const auto bone = static_cast<std::size_t>(fragments[std::exchange(fragment_, 0)].bone);
  if (count_ == most) return;
  pieces_[count_++] = {event.subject, bone, simulator::transform_from(event.pose).translation_mm};
}

std::optional<std::int32_t> LoosePieces::take_waste(std::span<const AimedCut> cuts,
                                                    std::uint32_t which) noexcept {
  for (std::size_t i = count_; i-- > 0;) {
    if (!is_waste(pieces_[i].inside_in_bone_mm, pieces_[i].bone, cuts, which)) continue;
    const std::int32_t taken = pieces_[i].id;
    forget(taken);
    return taken;
  }
  return std::nullopt;
}

std::optional<std::int32_t> LoosePieces::nearest(const Vec3& point_in_bone_mm,
                                                 std::size_t bone) const noexcept {
  std::optional<std::int32_t> nearest;
  double least_mm2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count_; ++i) {
    const double away_mm2 = squared_length(pieces_[i].inside_in_bone_mm - point_in_bone_mm);
    if (pieces_[i].bone != bone || away_mm2 >= least_mm2) continue;
    least_mm2 = away_mm2;
    nearest = pieces_[i].id;
  }
  return nearest;
}

void LoosePieces::forget(std::int32_t piece) noexcept {
  const auto end = pieces_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto kept =
      std::remove_if(pieces_.begin(), end, [&](const Piece& known) { return known.id == piece; });
  count_ = static_cast<std::size_t>(kept - pieces_.begin());
}

}  // namespace hallux::scenarios

#include "scenarios/hands/loose_pieces.h"

#include <algorithm>

namespace hallux::scenarios {

namespace {

bool is_waste(const Vec3& point_in_bone_mm, std::span<const AimedCut> cuts,
              std::uint32_t which) noexcept {
  for (std::size_t cut = 0; cut < cuts.size(); ++cut) {
    const ReferenceFace& face = cuts[cut].face;
    const bool is_asked = ((which >> cut) & 1U) != 0;
    if (is_asked && glm::dot(face.normal, point_in_bone_mm) <= face.offset_mm) return false;
  }
  return true;
}

}  // namespace

void LoosePieces::observe(const simulator::CutEvent& event) noexcept {
  if (event.kind == simulator::CutEventKind::PieceRemoved) forget(event.subject);
  if (event.kind != simulator::CutEventKind::PieceFreed || count_ == most) return;
  pieces_[count_++] = {event.subject, simulator::transform_from(event.pose).translation_mm};
}

std::optional<std::int32_t> LoosePieces::take_waste(std::span<const AimedCut> cuts,
                                                    std::uint32_t which) noexcept {
  for (std::size_t i = count_; i-- > 0;) {
    if (!is_waste(pieces_[i].inside_in_bone_mm, cuts, which)) continue;
    const std::int32_t taken = pieces_[i].id;
    forget(taken);
    return taken;
  }
  return std::nullopt;
}

std::optional<std::int32_t> LoosePieces::nearest(const Vec3& point_in_bone_mm) const noexcept {
  const auto end = pieces_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto found = std::min_element(pieces_.begin(), end, [&](const Piece& a, const Piece& b) {
    return squared_length(a.inside_in_bone_mm - point_in_bone_mm) <
           squared_length(b.inside_in_bone_mm - point_in_bone_mm);
  });
  if (found == end) return std::nullopt;
  return found->id;
}

void LoosePieces::forget(std::int32_t piece) noexcept {
  const auto end = pieces_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto kept =
      std::remove_if(pieces_.begin(), end, [&](const Piece& known) { return known.id == piece; });
  count_ = static_cast<std::size_t>(kept - pieces_.begin());
}

}  // namespace hallux::scenarios

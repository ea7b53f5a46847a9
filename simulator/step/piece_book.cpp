#include "simulator/step/piece_book.h"

#include <algorithm>

namespace hallux::simulator {

void PieceBook::learn(std::span<FoundPiece> pieces) noexcept {
  pieces_ = pieces;
  announced_ = 0;
}

const FoundPiece* PieceBook::announce_next() noexcept {
  while (announced_ < pieces_.size()) {
    const FoundPiece& piece = pieces_[announced_++];
    if (!piece.is_new) continue;
    freed_last_ = piece.id;
    return &piece;
  }
  return nullptr;
}

std::int32_t PieceBook::announce_next_section() noexcept {
  const auto next = std::find(sections_.begin(), sections_.end(), Section::Covered);
  if (next == sections_.end()) return -1;
  *next = Section::Announced;
  return static_cast<std::int32_t>(next - sections_.begin());
}

const FoundPiece* PieceBook::take_out(std::int32_t piece) noexcept {
  if (piece == piece_freed_last) piece = freed_last_;
  if (piece <= 0 || removed_count_ == removed_piece_limit) return nullptr;
  const auto found = std::find_if(pieces_.begin(), pieces_.end(),
                                  [&](const FoundPiece& known) { return known.id == piece; });
  if (found == pieces_.end() || found->is_taken_out) return nullptr;
  found->is_taken_out = true;
  removed_[removed_count_++] = found->body.get();
  return &*found;
}

}  // namespace hallux::simulator

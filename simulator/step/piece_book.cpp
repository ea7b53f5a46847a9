#include "simulator/step/piece_book.h"

#include <algorithm>

namespace hallux::simulator {

void PieceBook::learn(std::span<const PieceBody> pieces) noexcept {
  pieces_ = pieces;
  announced_ = 0;
}

const PieceBody* PieceBook::announce_next() noexcept {
  while (announced_ < pieces_.size()) {
    const PieceBody& piece = pieces_[announced_++];
    if (!piece.is_new) continue;
    freed_last_ = piece.id;
    return &piece;
  }
  return nullptr;
}

const PieceBody* PieceBook::take_out(std::int32_t piece) noexcept {
  if (piece == piece_freed_last) piece = freed_last_;
  if (piece <= 0 || removed_count_ == removed_piece_limit) return nullptr;
  const auto body = std::find_if(pieces_.begin(), pieces_.end(),
                                 [&](const PieceBody& known) { return known.id == piece; });
  if (body == pieces_.end()) return nullptr;
  const std::span<const Bvh* const> out = removed();
  if (std::find(out.begin(), out.end(), body->bvh.get()) != out.end()) return nullptr;
  removed_[removed_count_++] = body->bvh.get();
  return &*body;
}

}  // namespace hallux::simulator

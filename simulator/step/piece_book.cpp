#include "simulator/step/piece_book.h"

#include <algorithm>

namespace hallux::simulator {

PieceBook::PieceBook(std::int32_t bones) noexcept : bone_count_(bones), fragment_count_(bones) {
  for (std::int32_t bone = 0; bone < bones; ++bone) own_[index(bone)].id = bone;
}

void PieceBook::learn(std::span<FoundPiece> pieces, std::int32_t fragment) noexcept {
  pieces_[index(fragment)] = pieces;
  announced_[index(fragment)] = 0;
}

KnownPiece PieceBook::announce_next() noexcept {
  for (std::int32_t fragment = 0; fragment < fragment_count_; ++fragment) {
    const std::span<FoundPiece> pieces = pieces_[index(fragment)];
    std::size_t& announced = announced_[index(fragment)];
    while (announced < pieces.size()) {
      FoundPiece& piece = pieces[announced++];
      if (!piece.is_new) continue;
      freed_last_ = piece.id;
      return {&piece, fragment, false};
    }
  }
  return {};
}

bool PieceBook::is_all_announced() const noexcept {
  for (std::int32_t fragment = 0; fragment < fragment_count_; ++fragment) {
    if (announced_[index(fragment)] != pieces_[index(fragment)].size()) return false;
  }
  return true;
}

std::int32_t PieceBook::announce_next_section() noexcept {
  const auto next = std::find(sections_.begin(), sections_.end(), Section::Covered);
  if (next == sections_.end()) return -1;
  *next = Section::Announced;
  return static_cast<std::int32_t>(next - sections_.begin());
}

KnownPiece PieceBook::find(std::int32_t piece) noexcept {
  if (piece == piece_freed_last) piece = freed_last_ > 0 ? freed_last_ : -1;
  for (std::int32_t fragment = 0; fragment < fragment_count_; ++fragment) {
    FoundPiece& own = own_[index(fragment)];
    if (own.is_taken_out) continue;
    if (own.id == piece) return {&own, fragment, true};
    for (FoundPiece& known : pieces_[index(fragment)]) {
      if (known.id == piece && !known.is_taken_out) return {&known, fragment, false};
    }
  }
  return {};
}

const FoundPiece* PieceBook::remove(const KnownPiece& known) noexcept {
  const bool is_bone = known.is_own && known.fragment < bone_count_;
  if (known.piece == nullptr || is_bone || all_removed_ == removed_piece_limit) return nullptr;
  known.piece->is_taken_out = true;
  if (!known.is_own) {
    ++all_removed_;
    std::size_t& count = removed_count_[index(known.fragment)];
    removed_[index(known.fragment)][count++] = known.piece->body.get();
  }
  return known.piece;
}

const FoundPiece* PieceBook::take_out(std::int32_t piece) noexcept { return remove(find(piece)); }

bool PieceBook::part(std::int32_t piece) noexcept {
  const KnownPiece known = find(piece);
  if (known.is_own || fragment_count_ == fragment_limit) return false;
  const FoundPiece* const parted = remove(known);
  if (parted == nullptr) return false;
  part_new(parted->id, parted->volume_mm3, parted->inside_mm);
  return true;
}

void PieceBook::part_new(std::int32_t piece, double volume_mm3, const Vec3& inside_mm) noexcept {
  FoundPiece& own = own_[index(fragment_count_++)];
  own.id = piece;
  own.volume_mm3 = volume_mm3;
  own.inside_mm = inside_mm;
  own.is_taken_out = false;
}

}  // namespace hallux::simulator

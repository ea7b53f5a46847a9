/// The book of pieces: known from the last jobs, announced one by one, wanted, taken out, parted.
/// Inside this corner only.
///
/// Each fragment has its pieces. One of them is the fragment itself: of a bone it stays for good;
/// of a piece that was parted it may still be taken out, and then nothing of that fragment is left.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "simulator/cutting/field/kerf_set.h"
#include "simulator/jobs/geometry_job.h"

namespace hallux::simulator {

/// Of all pieces of an attempt, those that may be taken out or parted.
inline constexpr std::size_t removed_piece_limit = 24;

/// A piece and the fragment that it is of; null where there is none of that number.
struct KnownPiece {
  FoundPiece* piece = nullptr;
  std::int32_t fragment = -1;
  /// It is the fragment itself.
  bool is_own = false;
};

/// Takes no memory: it borrows the pieces of jobs' results.
class PieceBook {
 public:
  /// The bones are pieces too, numbered from 0.
  /// bones  at most bone_limit
  explicit PieceBook(std::int32_t bones = 1) noexcept;

  /// The pieces of a fragment as a job found them, borrowed until the next are learned, the bodies
  /// of those that are taken out for the book's lifetime; those that came free are announced from
  /// the first.
  void learn(std::span<FoundPiece> pieces, std::int32_t fragment = 0) noexcept;
  /// The next piece that came free, out meanwhile or not; null where none is left to announce.
  KnownPiece announce_next() noexcept;
  bool is_all_announced() const noexcept;

  /// To be taken out as soon as the pieces are known; 0: none.
  void want(std::int32_t piece) noexcept { wanted_ = piece; }
  std::int32_t take_wanted() noexcept { return std::exchange(wanted_, 0); }
  /// What is there under a number, or under piece_freed_last, and was not taken out.
  KnownPiece find(std::int32_t piece) noexcept;
  /// Takes a piece out of the wound, and marks it.
  /// piece   its number, or piece_freed_last
  /// errors  null: no such piece, out already, a bone itself, or removed_piece_limit reached
  const FoundPiece* take_out(std::int32_t piece) noexcept;
  /// Makes a piece the own one of the next fragment: the one that it was of stands without it.
  /// errors  false: as take_out
  bool part(std::int32_t piece) noexcept;
  /// Makes a piece that no job found yet the own one of the next fragment.
  void part_new(std::int32_t piece, double volume_mm3, const Vec3& inside_mm) noexcept;
  /// A fragment's surface is another one now, in which what was taken out is missing already.
  void forget_removed(std::int32_t fragment) noexcept { removed_count_[index(fragment)] = 0; }

  std::int32_t fragment_count() const noexcept { return fragment_count_; }
  /// Nothing of the fragment is left.
  bool is_out(std::int32_t fragment) const noexcept { return own_[index(fragment)].is_taken_out; }
  std::span<const Bvh* const> removed(std::int32_t fragment = 0) const noexcept {
    return {removed_[index(fragment)].data(), removed_count_[index(fragment)]};
  }

  /// The kerf took its whole section; announced the first time.
  void cover_section(std::int32_t kerf) noexcept {
    Section& section = sections_[static_cast<std::size_t>(kerf)];
    if (section == Section::Open) section = Section::Covered;
  }
  /// The next kerf that took its section, or -1 where none is left to announce.
  std::int32_t announce_next_section() noexcept;

 private:
  enum class Section : std::uint8_t { Open, Covered, Announced };
  template <typename Value>
  using OfEach = std::array<Value, static_cast<std::size_t>(fragment_limit)>;

  static std::size_t index(std::int32_t fragment) noexcept {
    return static_cast<std::size_t>(fragment);
  }
  const FoundPiece* remove(const KnownPiece& known) noexcept;

  OfEach<std::span<FoundPiece>> pieces_{};
  OfEach<std::size_t> announced_{};
  OfEach<FoundPiece> own_{};
  OfEach<std::array<const Bvh*, removed_piece_limit>> removed_{};
  OfEach<std::size_t> removed_count_{};
  /// The bones are the first.
  std::int32_t bone_count_, fragment_count_;
  std::size_t all_removed_ = 0;
  /// The piece announced last; 0: none was.
  std::int32_t freed_last_ = 0;
  std::int32_t wanted_ = 0;
  std::array<Section, static_cast<std::size_t>(kerf_limit)> sections_{};
};

}  // namespace hallux::simulator

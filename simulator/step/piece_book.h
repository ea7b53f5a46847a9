/// The book of pieces: known from the last job, announced one by one, wanted, and taken out.
/// Inside this corner only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "simulator/cutting/field/kerf_set.h"
#include "simulator/jobs/geometry_job.h"

namespace hallux::simulator {

inline constexpr std::size_t removed_piece_limit = 8;

/// Takes no memory: it borrows the pieces of jobs' results.
class PieceBook {
 public:
  /// The pieces as a job found them, borrowed until the next are learned, the bodies of those that
  /// are taken out for the book's lifetime; those that came free are announced from the first.
  void learn(std::span<FoundPiece> pieces) noexcept;
  /// The next piece that came free, or null where none is left to announce.
  const FoundPiece* announce_next() noexcept;
  bool is_all_announced() const noexcept { return announced_ == pieces_.size(); }

  /// To be taken out as soon as the pieces are known; 0: none.
  void want(std::int32_t piece) noexcept { wanted_ = piece; }
  std::int32_t take_wanted() noexcept { return std::exchange(wanted_, 0); }
  /// Takes a piece out of the wound, and marks it.
  /// piece   its number, or piece_freed_last
  /// errors  null: no such piece, out already, or removed_piece_limit reached
  const FoundPiece* take_out(std::int32_t piece) noexcept;
  std::span<const Bvh* const> removed() const noexcept { return {removed_.data(), removed_count_}; }

  /// The kerf took its whole section; announced the first time.
  void cover_section(std::int32_t kerf) noexcept {
    Section& section = sections_[static_cast<std::size_t>(kerf)];
    if (section == Section::Open) section = Section::Covered;
  }
  /// The next kerf that took its section, or -1 where none is left to announce.
  std::int32_t announce_next_section() noexcept;

 private:
  enum class Section : std::uint8_t { Open, Covered, Announced };

  std::span<FoundPiece> pieces_;
  std::size_t announced_ = 0;
  /// The piece announced last; 0: none was.
  std::int32_t freed_last_ = 0;
  std::int32_t wanted_ = 0;
  std::array<const Bvh*, removed_piece_limit> removed_{};
  std::size_t removed_count_ = 0;
  std::array<Section, static_cast<std::size_t>(kerf_limit)> sections_{};
};

}  // namespace hallux::simulator

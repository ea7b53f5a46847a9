/// A bone after its kerfs: cut in order, split, its pieces numbered, some of them taken out.
///
///     bone --kerf 0--> cut(0) --kerf 1--> cut(1) ... --split--> pieces 0, 1, 2 ... and debris
///
/// One rule for whoever asks: the jobs of an attempt, its scoring, its replay, the live picture and
/// `hallux cut`. Who asks says how far each kerf is open at the moment that is meant. Two solids
/// are kept, that from which the kerf that grew last is cut and that which was asked for last: a
/// kerf that grows costs the cuts from it on.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "simulator/bone/numbered_pieces.h"
#include "simulator/bone/whole_bone.h"
#include "simulator/cutting/solid/commit_patch.h"

namespace hallux::simulator {

/// A kerf as far as it is open at one moment.
struct OpenedKerf {
  /// The number that the faces of its walls carry (FaceSource::kerf).
  std::int32_t number = 0;
  KerfPlane plane;
  FieldGrid grid;
  /// Without a corner where nothing was opened yet.
  RegionOutline region;
};

/// A solid with the tree over its mesh; borrowed from the bone until a kerf before it changes, or
/// another place is asked for.
struct SolidWithTree {
  const CutSolid& solid;
  const Bvh& bvh;
};

/// thread  one at a time; work without a bound: not the haptic one
class CutBone {
 public:
  /// needs   the mesh is closed
  explicit CutBone(IndexedMesh whole)
      : CutBone(std::make_unique<const WholeBone>(std::move(whole))) {}
  /// Borrows the bone.
  explicit CutBone(const WholeBone& whole) : CutBone(whole, NumberedPieces(whole.solid)) {}
  /// A fragment whose pieces are numbered already. Borrows it.
  CutBone(const WholeBone& whole, NumberedPieces pieces)
      : whole_(&whole), pieces_(std::move(pieces)) {}

  // The kerfs, by their place in the order of cutting.
  std::int32_t kerf_count() const noexcept { return static_cast<std::int32_t>(kerfs_.size()); }
  const OpenedKerf& kerf(std::int32_t place) const noexcept { return kerfs_[index(place)]; }
  /// Opens a kerf as far as this, more or less than before.
  /// needs   place <= kerf_count()
  void put_kerf(std::int32_t place, OpenedKerf kerf);
  /// The kerf at `place` becomes the last to be cut; the faces keep their numbers.
  void move_last(std::int32_t place);

  /// The bone that was never cut.
  const CutSolid& whole() const noexcept { return whole_->solid; }
  /// What the kerfs before this one leave; `kerf_count()`: all of them.
  SolidWithTree before(std::int32_t place);
  /// What this kerf takes of that.
  const KerfTally& cut(std::int32_t place);
  /// What all kerfs leave; pieces that were taken out count as if they lay there.
  const CutSolid& after_all();
  /// The same without one kerf, from which all others are cut.
  /// place   -1: none is left out
  CutSolid all_but(std::int32_t place);

  /// Numbers the pieces that the kerfs leave as they are now open.
  void number_pieces() { number_pieces(next_piece_); }
  /// The same of a fragment that is not alone: the next number is the attempt's.
  void number_pieces(std::int32_t& next_piece) {
    pieces_.number(split_pieces(after_all()), next_piece);
  }
  /// See NumberedPieces.
  const Bvh* take_out(std::int32_t piece) { return pieces_.take_out(piece); }
  const NumberedPieces& pieces() const noexcept { return pieces_; }
  /// The pieces alone, for who makes other bones of them.
  NumberedPieces release_pieces() && { return std::move(pieces_); }

 private:
  /// One more kerf, and the bone after it while that is kept; its tree once it was asked for.
  struct Stage {
    KerfTally tally;
    std::optional<CutSolid> solid;
    std::unique_ptr<const Bvh> bvh;
  };

  explicit CutBone(std::unique_ptr<const WholeBone> own)
      : own_(std::move(own)), whole_(own_.get()), pieces_(whole_->solid) {}

  static std::size_t index(std::int32_t place) noexcept { return static_cast<std::size_t>(place); }
  /// After so many kerfs; needs it is kept.
  const CutSolid& kept_after(std::size_t count) const noexcept;
  SolidWithTree with_tree_after(std::size_t count);
  /// Cuts what is not cut yet, or not kept, of the kerfs before this one.
  const CutSolid& solid_before(std::int32_t place);
  void cut_next(std::size_t place);
  void forget_all_but(std::size_t count) noexcept;

  /// Null where it is borrowed.
  std::unique_ptr<const WholeBone> own_;
  const WholeBone* whole_;
  std::vector<OpenedKerf> kerfs_;
  /// After the first kerf, the second ...; those that still hold.
  std::deque<Stage> stages_;
  /// Place of the kerf that was put last.
  std::size_t grown_ = 0;
  NumberedPieces pieces_;
  /// Of a bone that is alone.
  std::int32_t next_piece_ = 1;
};

}  // namespace hallux::simulator

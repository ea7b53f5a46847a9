/// The bones of a running attempt as they are shown: which part of them is due anew, and its
/// geometry.
///
///     samples, events, requests --> AttemptGeometry --> base of the kerf that grows, its patch
///                                                  '--> whole fragments: one was parted or taken
///                                                       out, lost a piece, or has no patch
///
/// A patch shows a kerf on its fragment without it. Where that cannot be had, because what the kerf
/// freed was taken out already, or the blade saws a second fragment along with the first, the whole
/// fragment is due instead, twice a second.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "simulator/bone/growing_kerf.h"
#include "simulator/cutting/hole/bore_set.h"
#include "simulator/cutting/hole/implant_set.h"
#include "simulator/cutting/slice/section.h"
#include "simulator/jobs/geometry_job.h"

namespace hallux::simulator {

/// What the patch of the kerf that grows lies on.
struct PatchBase {
  std::int32_t fragment = 0;
  /// Empty and without a tree where nothing else was cut: it is the bone of that number as it was.
  CutSolid solid;
  std::unique_ptr<const Bvh> tree;

  bool is_uncut() const noexcept { return tree == nullptr; }
};

/// A fragment that is to be shown anew; without triangles where it was taken out.
struct DueFragment {
  std::int32_t fragment = 0;
  CutSolid solid;
};

/// A piece that came free.
struct FreedPiece {
  std::int32_t id = 0, fragment = 0;
  CutSolid solid;
};

/// thread  one at a time; work without a bound: not the haptic one
class LiveCut {
 public:
  /// Borrows the bones' solids and their trees.
  LiveCut(std::span<const BoneToCut> bones, const Tray& tray, const PlannedBridges& bridges = {});
  LiveCut(const BoneToCut& bone, const Tray& tray, const PlannedBridges& bridges = {})
      : LiveCut(std::span(&bone, 1), tray, bridges) {}

  // What the loop feeds, in its order. The same jobs run at the same places as the loop's own, so
  // pieces have the same numbers here.
  void apply(const ToolSample& sample);
  void apply(const CutEvent& event);
  void apply(const JobRequest& request);

  /// Whether anything may have changed that is not shown yet.
  bool is_due() const noexcept;

  // What is due, to be asked in this order.
  /// Nothing where the base of the last patch still holds, or none can be had.
  std::optional<PatchBase> take_base();
  /// The patch on the base that was taken last.
  /// errors  false where none is due, or its outline is not simple: the patch stays as it was
  bool build_patch(SolidPatch& patch);
  /// Fragments as meshes of their own; each replaces a patch that lies on it.
  std::vector<DueFragment> take_due();

  /// The pieces that came free and were not taken out, where they changed since the last call.
  std::optional<std::vector<FreedPiece>> take_free_pieces();

  /// The kerf in which the teeth were last, as far as it is open now; nothing before the first.
  std::optional<KerfOpening> kerf_at_hand() const;
  std::optional<KerfPlane> plane_at_hand() const;
  /// In which that kerf is; 0 before the first.
  std::int32_t fragment_at_hand() const noexcept;
  /// Any kerf as far as it is open now.
  KerfOpening opening_of(std::int32_t kerf) const;

  /// Where a fragment lies now, also while forceps lead it.
  RigidTransform world_from_fragment(std::int32_t fragment) const noexcept;
  /// That the forceps hold; -1: none.
  std::int32_t gripped() const noexcept { return gripped_; }

  // For questions about what stands.
  const KerfSet& kerfs() const noexcept { return geometry_.kerfs(); }
  const BoreSet& bores() const noexcept { return bores_; }
  const ImplantSet& implants() const noexcept { return implants_; }
  std::int32_t fragment_count() const noexcept { return geometry_.fragment_count(); }
  bool is_out(std::int32_t fragment) const noexcept { return geometry_.is_out(fragment); }
  std::int32_t own_piece(std::int32_t fragment) const noexcept {
    return geometry_.own_piece(fragment);
  }
  /// What a fragment was cut from since it is one.
  SolidWithTree whole(std::int32_t fragment = 0) { return geometry_.whole(fragment); }
  std::vector<const Bvh*> taken_out(std::int32_t fragment = 0) const {
    return geometry_.taken_out(fragment);
  }
  /// As they were worked out last, largest first, the fragment's own among them; without what was
  /// taken out. All but the fragment's own have their tree.
  const std::vector<PieceBody>& pieces(std::int32_t fragment = 0) const noexcept {
    return geometry_.pieces(fragment);
  }

 private:
  enum class Due : std::uint8_t { No, Soon, Now };

  Due& due(std::int32_t fragment) noexcept { return due_[static_cast<std::size_t>(fragment)]; }
  void grow_on(const SolidWithTree& base);
  void stop_growing() noexcept;
  void renew_free_pieces();

  AttemptGeometry geometry_;
  BoreSet bores_;
  ImplantSet implants_;
  /// Of the kerf at hand; null where it has no base.
  std::unique_ptr<GrowingKerf> growing_;
  std::int32_t kerf_at_hand_ = -1;
  std::vector<FreedPiece> free_pieces_;
  bool are_free_pieces_due_ = false;
  /// In which the teeth were last.
  std::int32_t kerf_ = -1;
  bool has_grown_ = false;
  std::array<Due, static_cast<std::size_t>(fragment_limit)> due_{};
  std::int64_t tick_ = 0, whole_tick_ = 0;
  std::int32_t gripped_ = -1;
  RigidTransform world_from_gripped_;
};

}  // namespace hallux::simulator

/// The bone of a running attempt as it is shown: which part of it is due anew, and its geometry.
///
///     samples, events, requests --> AttemptGeometry --> base of the kerf that grows, its patch
///                                                  '--> the whole: a piece was taken out, or no
///                                                       patch can be had
///
/// A patch shows a kerf on the bone without it. Where that bone cannot be had, because what the
/// kerf freed was taken out already, the whole is due instead, twice a second. A hinge that closes
/// takes the place of all that was due.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "simulator/bone/growing_kerf.h"
#include "simulator/cutting/slice/section.h"
#include "simulator/jobs/geometry_job.h"

namespace hallux::simulator {

/// What the patch of the kerf that grows lies on.
struct PatchBase {
  /// Empty and without a tree where nothing else was cut: it is the bone as it was.
  CutSolid solid;
  std::unique_ptr<const Bvh> tree;

  bool is_uncut() const noexcept { return tree == nullptr; }
};

/// A piece that came free.
struct FreedPiece {
  std::int32_t id = 0;
  CutSolid solid;
};

/// thread  one at a time; work without a bound: not the haptic one
class LiveCut {
 public:
  /// Borrows the bone's solid and its tree.
  LiveCut(const BoneToCut& bone, const Tray& tray, const PlannedBridges& bridges = {});

  // What the loop feeds, in its order. The same jobs run at the same places as the loop's own, so
  // pieces have the same numbers here.
  void apply(const ToolSample& sample);
  void apply(const CutEvent& event);
  void apply(const JobRequest& request);

  /// Whether anything may have changed that is not shown yet.
  bool is_due() const noexcept { return has_grown_ || is_whole_due_; }

  // What is due, to be asked in this order.
  /// Nothing where the base of the last patch still holds, or none can be had.
  std::optional<PatchBase> take_base();
  /// The patch on the base that was taken last.
  /// errors  false where none is due, or its outline is not simple: the patch stays as it was
  bool build_patch(SolidPatch& patch);
  /// What lies in the wound, as a mesh of its own.
  std::optional<CutSolid> take_whole();

  /// The pieces that came free and were not taken out, where they changed since the last call.
  std::optional<std::vector<FreedPiece>> take_free_pieces();

  /// The kerf in which the teeth were last, as far as it is open now; nothing before the first.
  std::optional<KerfOpening> kerf_at_hand() const;
  std::optional<KerfPlane> plane_at_hand() const;
  /// Any kerf as far as it is open now.
  KerfOpening opening_of(std::int32_t kerf) const;

  // For questions about what stands.
  const KerfSet& kerfs() const noexcept { return geometry_.kerfs(); }
  SolidWithTree whole() { return geometry_.whole(); }
  std::vector<const Bvh*> taken_out() const { return geometry_.taken_out(); }
  /// As they were worked out last, largest first, the bone (number 0) among them; without what was
  /// taken out. All but the bone have their tree.
  const std::vector<PieceBody>& pieces() const noexcept { return geometry_.pieces(); }

  /// The halves of the hinge, once it has closed; null before. It lives as long as this.
  const ClosedHinge* closed_hinge() const noexcept;

 private:
  void grow_on(const SolidWithTree& base);

  AttemptGeometry geometry_;
  /// Of the kerf at hand; null where it has no base.
  std::unique_ptr<GrowingKerf> growing_;
  std::int32_t kerf_at_hand_ = -1;
  std::unique_ptr<const JobResult> hinge_;
  std::vector<FreedPiece> free_pieces_;
  bool are_free_pieces_due_ = false;
  /// In which the teeth were last.
  std::int32_t kerf_ = -1;
  bool has_grown_ = false;
  bool is_whole_due_ = false;
  std::int64_t tick_ = 0, whole_tick_ = 0;
};

}  // namespace hallux::simulator

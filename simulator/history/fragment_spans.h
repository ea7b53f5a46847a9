/// The fragments of a recording from one parting to the next: the solid that each stands as, the
/// kerfs that cut it meanwhile, and what was taken out of it. Inside this corner only.
///
///     bone, kerfs --FragmentParted--> what is left, kerfs --FragmentParted--> ...
///                               '---> the piece, kerfs ...
///
/// Pieces have the numbers that the attempt gave them: they are numbered at the ticks at which its
/// jobs did so, by the same rule. Where a recording tells no jobs, a piece that was parted is known
/// by the place that its event told.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/bone/close_bridge.h"
#include "simulator/history/bone_at_tick.h"
#include "simulator/mesh/bones.h"

namespace hallux::simulator {

/// A fragment between two partings.
struct FragmentSpan {
  std::int64_t from_tick = 0, until_tick = never_tick;
  std::unique_ptr<const WholeBone> whole;
  /// In the order of cutting.
  std::vector<std::int32_t> kerfs;
  /// Of what was taken out of the fragment, that which is missing in the solid already.
  std::size_t taken_before = 0;
};

/// A piece as it was when it was taken out.
struct TakenPiece {
  std::int64_t tick = 0;
  std::unique_ptr<const Bvh> body;
  /// The box around it, a little wider.
  Vec3 low_mm{0.0, 0.0, 0.0}, high_mm{0.0, 0.0, 0.0};

  TakenPiece(std::int64_t taken_tick, const IndexedMesh& piece);
  /// Whether a triangle of the bone with that middle is of the piece: on its surface but for
  /// rounding, or within it, where a kerf went on through the place at which it had lain.
  bool has(const Vec3& middle_mm) const noexcept;
};

struct SpannedFragment {
  /// By time; none where nothing is known of its solid.
  std::vector<FragmentSpan> spans;
  /// By time.
  std::vector<TakenPiece> taken;
  /// When all of it was taken out.
  std::int64_t out_tick = never_tick;
};

struct SpansRequest {
  const Bones& bones;
  const Recording& recording;
  const std::vector<KerfGrowth>& growths;
  const PlannedBridges& bridges;
  /// Of fragment_events.
  const std::vector<CutEvent>& events;
};

/// One for each fragment, as FragmentPoses numbers them.
/// errors  Cancelled
/// thread  work's; seconds where pieces were taken out or parted
std::vector<SpannedFragment> fragment_spans(const SpansRequest& request,
                                            const Progress& progress = {});

}  // namespace hallux::simulator

/// The bone at every moment of a recorded attempt, so that any of them can be shown at once.
/// Inside this corner only.
///
/// What the blade opened is kept as one field a kerf with the tick at which each node opened: the
/// kerf of a moment is a threshold of it. In a stretch of time in which only one kerf grows the
/// others stand still: they are cut into a solid that is made once, and the one that grows is a
/// patch on it, built from the outline of the moment:
///
///     time       ---- kerf 0 grows ----|---- kerf 1 grows ----|-- kerf 0 again --
///     solid      the whole bone         bone less kerf 0       bone less kerf 1
///     patch      kerf 0, by outline     kerf 1, by outline     kerf 0, by outline
///
/// Pieces have the numbers that the attempt gave them: they are numbered at the ticks at which its
/// jobs did so, by the same rule. A piece that was taken out is left out from then on; a closed
/// hinge has two halves.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/bone/close_bridge.h"
#include "simulator/cutting/field/opened_field.h"
#include "simulator/cutting/slice/slab_slice.h"
#include "simulator/mesh/bone.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

/// What an attempt was made on and with.
struct HistoryRequest {
  const Bone& bone;
  const Recording& recording;
  /// Of the recording, one per kerf.
  std::vector<OpenedField> opened;
  /// As the operation planned it.
  PlannedBridges bridges;
};

/// What a kerf opened, and when.
struct KerfGrowth {
  OpenedField opened;
  /// Ticks at which something opened, ascending.
  std::vector<std::int32_t> ticks;

  /// How many of them are not after this tick: the kerf looks the same wherever that is the same.
  std::size_t grown_at(std::int64_t tick) const noexcept;
};

/// A stretch of time in which at most one kerf grows.
struct BoneStretch {
  std::int64_t from_tick = 0;
  /// That kerf; -1: none ever does.
  std::int32_t growing = -1;
  /// The bone with the other kerfs as they are.
  CutSolid solid;
  /// Of the growing kerf; null for none.
  std::unique_ptr<const SlabSlice> contact;
  /// Per piece that is taken out its triangles of the solid, ascending; empty where it is taken out
  /// later.
  std::vector<std::vector<std::uint32_t>> of_piece;
};

struct TakenPiece {
  std::int64_t tick = 0;
  std::unique_ptr<const Bvh> body;
};

/// The two halves after a hinge was closed.
struct ClosedHalves {
  std::int64_t tick = 0;
  CutSolid fixed, moved;
  RigidTransform bone_from_moved;
};

/// Never changes once it was built.
struct BoneHistory {
  std::vector<KerfGrowth> kerfs;
  /// By time, the first from the beginning.
  std::vector<BoneStretch> stretches;
  /// By time.
  std::vector<TakenPiece> taken;
  std::optional<ClosedHalves> closed;

  std::size_t stretch_at(std::int64_t tick) const noexcept;
};

/// A triangle lies on the surface of the piece that it belongs to but for rounding.
bool lies_on(const Bvh& body, const Vec3& point_mm);

/// `progress` is told the fraction done and may throw to stop it.
/// errors  Cancelled
/// thread  work's; seconds
std::shared_ptr<const BoneHistory> build_history(HistoryRequest request,
                                                 const Progress& progress = {});

}  // namespace hallux::simulator

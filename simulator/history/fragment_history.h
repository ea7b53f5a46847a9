/// A fragment of a recorded attempt at every moment: solids that stand still for a while, and on
/// each of them one kerf that grows. Inside this corner only.
///
/// What the blade opened is kept as one field a kerf with the tick at which each node opened: the
/// kerf of a moment is a threshold of it. In a stretch of time in which only one kerf of a fragment
/// grows the others stand still: they are cut into a solid that is made once, and the one that
/// grows is a patch on it, built from the outline of the moment:
///
///     time       ---- kerf 0 grows ----|---- kerf 1 grows ----|-- parted --
///     solid      the whole bone         bone less kerf 0       what is left
///     patch      kerf 0, by outline     kerf 1, by outline     the next kerf
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "simulator/cutting/hole/hole_rim.h"
#include "simulator/cutting/slice/slab_slice.h"
#include "simulator/history/bone_at_tick.h"
#include "simulator/history/fragment_path.h"
#include "simulator/history/fragment_spans.h"
#include "simulator/history/metal_history.h"

namespace hallux::simulator {

/// A rim of a bore on a solid, as if the bore were open to its end.
struct BoreRim {
  /// Of MetalHistory::bores.
  std::size_t bore = 0;
  HoleRim rim;
  /// When what it lies on was taken out.
  std::int64_t gone_tick = never_tick;
};

/// A stretch of time in which at most one kerf of the fragment grows.
struct BoneStretch {
  std::int64_t from_tick = 0, until_tick = never_tick;
  /// That kerf; -1: none ever does.
  std::int32_t growing = -1;
  /// The fragment with its other kerfs as they are.
  CutSolid solid;
  /// Of the growing kerf; null for none.
  std::unique_ptr<const SlabSlice> contact;
  /// Of what was taken out of the fragment, that which is missing in the solid already.
  std::size_t taken_before = 0;
  /// Per piece that is taken out, behind those, its triangles of the solid, ascending; empty where
  /// it is taken out later.
  std::vector<std::vector<std::uint32_t>> of_piece;
  std::vector<BoreRim> rims;
};

/// Never changes once it was built.
struct FragmentHistory {
  /// Whose frame it has, what it was parted from, and when.
  FragmentPaths::Origin origin;
  /// When all of it was taken out.
  std::int64_t out_tick = never_tick;
  /// By time, the first from when it was parted; none where nothing is known of it.
  std::vector<BoneStretch> stretches;
  /// By time.
  std::vector<TakenPiece> taken;
  FragmentPath path;
  /// What it was cut from since nothing more was parted from it; null where it is the only
  /// fragment.
  std::unique_ptr<const WholeBone> whole;

  /// Whether it is a fragment of its own, not taken out, and known.
  bool is_there(std::int64_t tick) const noexcept {
    return !stretches.empty() && tick >= origin.from_tick && tick < out_tick;
  }
  /// needs   stretches
  std::size_t stretch_at(std::int64_t tick) const noexcept;
};

/// Fills in the stretches and what was taken out, from spans whose solids it takes.
/// fragment  its number
/// errors    Cancelled
void build_stretches(FragmentHistory& history, SpannedFragment spanned, std::int32_t fragment,
                     const std::vector<KerfGrowth>& growths, const std::vector<BoreGrowth>& bores,
                     const Progress& progress);

}  // namespace hallux::simulator

/// A cut that is done: the patch becomes part of the solid. Inside this room only.
#pragma once

#include "simulator/cutting/solid/solid_patch.h"

namespace hallux::simulator {

/// The solid with the patch in the place of the hidden triangles.
/// needs   the patch was built on this solid
/// ensures closed and oriented, each directed edge once; triangles that were not hidden keep their
///         order and their bits; cost grows with the whole solid: a job, not a frame
/// thread  worker
CutSolid commit_patch(const CutSolid& solid, const SolidPatch& patch);

/// What one kerf took of a solid.
struct KerfTally {
  /// By opened_volume_mm3.
  double removed_mm3 = 0.0;
  /// Of every skin that the region reaches, all within the slab is gone.
  bool takes_section = false;
  /// How often the plane was moved to get past a refusal; expected 0.
  std::uint32_t nudges = 0;
};

/// And what it leaves of it.
struct KerfCut : KerfTally {
  CutSolid solid;
};

/// Contact, patch and commit in one go. Where the patch is refused, the plane is moved by 2^-18 mm
/// along its normal and everything is built again, up to eight times; then the solid stays as it
/// was.
/// needs   bvh was built over solid.mesh; region was outlined in this plane on this grid
/// ensures a pure function; nothing reached leaves the solid as it is
/// thread  worker
KerfCut cut_kerf(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane, std::int32_t kerf,
                 const FieldGrid& grid, const RegionOutline& region);

}  // namespace hallux::simulator

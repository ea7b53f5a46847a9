/// One kerf that grows on a solid that stands still: a patch for each frame.
#pragma once

#include "simulator/bone/cut_bone.h"
#include "simulator/cutting/field/region_outline.h"
#include "simulator/cutting/slice/slab_slice.h"
#include "simulator/cutting/solid/solid_patch.h"

namespace hallux::simulator {

class GrowingKerf {
 public:
  /// Slices the contact; borrows nothing afterwards.
  /// stands  the bone without this kerf; has triangles
  /// number  what the faces of its walls carry
  GrowingKerf(const SolidWithTree& stands, const KerfPlane& plane, std::int32_t number,
              const FieldGrid& grid);
  GrowingKerf(const GrowingKerf&) = delete;
  GrowingKerf& operator=(const GrowingKerf&) = delete;

  /// The patch of what the field has open now, at a cost of what changed since the last call.
  /// needs   the same field each time
  /// errors  false where its outline is not simple: the patch stays as it was
  bool build(const KerfField& field, SolidPatch& patch);
  /// The same of any region.
  bool build(const RegionOutline& region, SolidPatch& patch) {
    return builder_.build(region, patch);
  }
  /// What the field had open when a patch of it was built last.
  const RegionOutline& region() const noexcept { return tracker_.outline(); }

 private:
  SlabSlice contact_;
  PatchBuilder builder_;
  OutlineTracker tracker_;
};

}  // namespace hallux::simulator

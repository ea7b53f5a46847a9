/// What a region takes out of a bone, by code that shares nothing with the patch.
#pragma once

#include <cstdint>
#include <span>

#include "simulator/cutting/field/kerf.h"
#include "simulator/cutting/field/region_outline.h"
#include "simulator/cutting/pieces/cut_solid.h"

namespace hallux::simulator {

/// The volume of the bone within the kerf's slab over the region [mm3]: the integral over the
/// region of the height of bone that stands there.
/// needs   solid is closed
/// thread  worker; cost grows with the strip's triangles times the outline's corners
/// source  docs/cutting.md, "The balance"
double opened_volume_mm3(const CutSolid& solid, const KerfPlane& plane,
                         const RegionOutline& region);
/// Of one region of a section alone: the bone that its triangles enclose within the slab.
double opened_volume_mm3(const CutSolid& solid, std::span<const std::uint32_t> triangles,
                         const KerfPlane& plane, const RegionOutline& region);

}  // namespace hallux::simulator

/// The cutting method: takes a kerf's slab out of a solid, region by region.
///
/// This first method is the two-plane clip (thesis 4.4.2): it acts on regions that the swept field covers wholly. What
/// replaces it keeps these functions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulator/cutting/section.h"

namespace hallux::simulator {

/// The regions of a section that the field covers wholly, as one flag per region.
std::vector<std::uint8_t> covered_regions(const SectionMask& mask, const KerfField& field);
/// The regions of which the field covers any node.
std::vector<std::uint8_t> touched_regions(const SectionMask& mask, const KerfField& field);

/// The solid without the slab's part in each flagged region; all other triangles stay as they are, bit for bit.
/// needs   section was sliced from this solid and bvh; is_removed has one flag per region
/// ensures the result is closed and oriented; new faces carry {kerf, side}
CutSolid remove_slab(const CutSolid& solid, const Bvh& bvh, const Section& section,
                     std::int32_t kerf, std::span<const std::uint8_t> is_removed);

/// The volume that remove_slab takes away, integrated from section areas by code that shares nothing with the clip [mm3].
double slab_volume_mm3(const CutSolid& solid, const Section& section,
                       std::span<const std::uint8_t> is_removed);

}  // namespace hallux::simulator

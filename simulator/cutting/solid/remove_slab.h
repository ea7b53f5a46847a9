/// The two-plane clip (thesis 4.4.2): takes a slab out of a solid wholly, region by region. With a
/// slab without thickness it divides the solid and loses nothing. Inside this room only.
#pragma once

#include <cstdint>
#include <span>

#include "simulator/cutting/slice/section.h"

namespace hallux::simulator {

/// The solid without the slab's part in each flagged region; all other triangles stay as they are,
/// bit for bit.
/// needs   section was sliced from this solid and bvh; is_removed has one flag per region
/// ensures the result is closed and oriented; new faces carry {kerf, side}
CutSolid remove_slab(const CutSolid& solid, const Bvh& bvh, const Section& section,
                     std::int32_t kerf, std::span<const std::uint8_t> is_removed);

}  // namespace hallux::simulator

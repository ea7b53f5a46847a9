/// The volume of a slab's part of a solid, from section areas alone.
#pragma once

#include <cstdint>
#include <span>

#include "simulator/cutting/slice/section.h"

namespace hallux::simulator {

/// The volume that remove_slab takes away, integrated from section areas by code that shares
/// nothing with the clip [mm3].
double slab_volume_mm3(const CutSolid& solid, const Section& section,
                       std::span<const std::uint8_t> is_removed);

}  // namespace hallux::simulator

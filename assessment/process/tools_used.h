/// With which tools of the tray kerfs were sawn. Inside this room only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "assessment/rebuild/rebuild.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

/// The blade that began a kerf.
/// needs   rebuilt from that recording
const simulator::Blade& blade_of_kerf(const simulator::Recording& recording,
                                      const RebuiltBone& rebuilt, std::int32_t kerf);

/// The first tick at which one of these kerfs was cut with another tool than that on the tray's
/// `place`; nothing where none was.
/// needs   samples and events are in the order of their ticks
std::optional<std::int64_t> first_cut_with_another(const simulator::Recording& recording,
                                                   std::span<const std::int32_t> kerfs,
                                                   std::int32_t place);

}  // namespace hallux::assessment

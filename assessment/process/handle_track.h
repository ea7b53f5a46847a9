/// The speed of the handle over an attempt, from the tape. Inside this room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "simulator/record/tape_lines.h"

namespace hallux::assessment {

/// Ticks that follow each other while the attempt's clock ran; one entry a tick.
struct HandleStretch {
  std::int64_t first_tick = 0;
  /// By central differences of the low-passed place; one-sided at both ends.
  std::vector<double> speed_mm_s;
  /// Bits of ToolStatus at the end of the tick; of the line that covers it.
  std::vector<std::uint32_t> status;

  std::int64_t tick_at(std::size_t index) const noexcept {
    return first_tick + static_cast<std::int64_t>(index);
  }
};

/// The handle's place is low-passed over each stretch (10 Hz, there and back). Between lines that
/// cover several ticks it is taken as having moved evenly; a pause and a gap end a stretch.
/// together  so many lines count as one (see followed_places)
/// needs     tape and samples are in the order of their ticks
/// errors    those of whoever keeps the tape
std::vector<HandleStretch> handle_stretches(const simulator::Recorded& recorded,
                                            std::size_t together = 1);

/// Calls visit(first, last), both ends included, for each longest run of ticks of a stretch for
/// which `holds(index)` is true.
template <typename Holds, typename Visit>
void for_each_run(const HandleStretch& stretch, Holds&& holds, Visit&& visit) {
  const std::size_t count = stretch.speed_mm_s.size();
  std::size_t first = count;
  for (std::size_t index = 0; index <= count; ++index) {
    const bool holds_here = index < count && holds(index);
    if (holds_here && first == count) first = index;
    if (holds_here || first == count) continue;
    visit(first, index - 1);
    first = count;
  }
}

}  // namespace hallux::assessment

/// A place followed from tick to tick over an attempt, low-passed. Inside this corner only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "simulator/base/vector.h"
#include "simulator/record/tape_lines.h"

namespace hallux::assessment {

/// Ticks that follow each other while the attempt's clock ran; one entry a tick, of 28 bytes: who
/// follows a place twice lets go of the first before.
struct PlaceStretch {
  std::int64_t first_tick = 0;
  std::array<std::vector<double>, 3> axes_mm;
  /// Bits of ToolStatus at the end of the tick; of the line that covers it.
  std::vector<std::uint32_t> status;

  std::size_t count() const noexcept { return status.size(); }
  Vec3 at_mm(std::size_t index) const {
    return {axes_mm[0][index], axes_mm[1][index], axes_mm[2][index]};
  }
};

/// Where the followed thing was at the end of a line; nothing ends the stretch.
using PlaceAt = std::function<std::optional<Vec3>(const simulator::TapeLine& line,
                                                  const simulator::ToolSample& sample)>;

/// Low-passed over each stretch (10 Hz, there and back). Over a line that covers several ticks the
/// thing is taken as having moved evenly; a pause and a gap end a stretch.
/// together  so many lines count as one, as if the last of them alone had been recorded: what twice
///           the steps would make of it
/// needs   tape and samples are in the order of their ticks
/// errors  those of whoever keeps the tape
std::vector<PlaceStretch> followed_places(const simulator::Recorded& recorded,
                                          const PlaceAt& place_at, std::size_t together = 1);

}  // namespace hallux::assessment

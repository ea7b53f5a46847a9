/// The time that samples cover, and stretches of them; when an event was said last.
/// Inside this room only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "simulator/record/record.h"

namespace hallux::assessment {

/// 0 where nothing was sampled.
inline std::int64_t last_tick_of(const simulator::Recording& recording) noexcept {
  return recording.samples.empty() ? 0 : recording.samples.back().tick;
}

/// Of the events of that kind, about that subject where one is asked for; nothing where there is
/// none.
inline std::optional<std::int64_t> last_tick_of(const simulator::Recording& recording,
                                                simulator::CutEventKind kind,
                                                std::optional<std::size_t> subject = {}) noexcept {
  std::optional<std::int64_t> tick;
  for (const simulator::CutEvent& event : recording.events) {
    const bool is_about = !subject || event.subject == static_cast<std::int32_t>(*subject);
    if (event.kind == kind && is_about) tick = event.tick;
  }
  return tick;
}

/// The event that closed a hinge of the plan last, or null. Old engines numbered no hinges, and had
/// one.
inline const simulator::CutEvent* closing_of(const simulator::Recording& recording,
                                             std::size_t hinge) noexcept {
  const simulator::CutEvent* closing = nullptr;
  for (const simulator::CutEvent& event : recording.events) {
    const bool is_of_it = event.subject < 0 || event.subject == static_cast<std::int32_t>(hinge);
    if (event.kind == simulator::CutEventKind::HingeClosed && is_of_it) closing = &event;
  }
  return closing;
}

/// The ticks that a sample covers: those since the one before, where no more were missed than one
/// line of a tape may cover.
inline std::int64_t ticks_covered(std::span<const simulator::ToolSample> samples,
                                  std::size_t index) noexcept {
  if (index == 0) return 1;
  const std::int64_t since = samples[index].tick - samples[index - 1].tick;
  return since > simulator::ticks_per_line_max ? 1 : std::max<std::int64_t>(since, 0);
}

/// Calls visit(first, last), both ends included, for each longest stretch of samples for which
/// `holds(index)` is true; more missed ticks than a line of a tape may cover end one.
template <typename Holds, typename Visit>
void for_each_stretch(std::span<const simulator::ToolSample> samples, Holds&& holds,
                      Visit&& visit) {
  std::size_t first = 0;
  bool is_open = false;
  for (std::size_t index = 0; index <= samples.size(); ++index) {
    const bool holds_here = index < samples.size() && holds(index);
    const bool is_cut_off =
        is_open && (!holds_here ||
                    samples[index].tick - samples[index - 1].tick > simulator::ticks_per_line_max);
    if (is_cut_off) visit(first, index - 1);
    if (holds_here && (!is_open || is_cut_off)) first = index;
    is_open = holds_here;
  }
}

}  // namespace hallux::assessment

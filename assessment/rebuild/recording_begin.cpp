#include "assessment/rebuild/recording_begin.h"

#include <algorithm>
#include <iterator>

namespace hallux::assessment {

simulator::Recording begin_of(const simulator::Recording& recording, std::int64_t last_tick) {
  simulator::Recording begin;
  begin.engine = recording.engine;
  const auto is_within = [last_tick](const auto& row) { return row.tick <= last_tick; };
  std::copy_if(recording.samples.begin(), recording.samples.end(),
               std::back_inserter(begin.samples), is_within);
  std::copy_if(recording.events.begin(), recording.events.end(), std::back_inserter(begin.events),
               is_within);
  return begin;
}

bool is_sawn_between(const simulator::Recording& recording, std::int64_t after_tick,
                     std::int64_t last_tick) noexcept {
  const auto end_of = [&](std::int64_t tick) {
    return std::partition_point(
        recording.samples.begin(), recording.samples.end(),
        [tick](const simulator::ToolSample& sample) { return sample.tick <= tick; });
  };
  return std::any_of(end_of(after_tick), end_of(last_tick),
                     [](const simulator::ToolSample& sample) {
                       return sample.kerf >= 0 && has(sample.status, simulator::ToolStatus::SawOn);
                     });
}

}  // namespace hallux::assessment

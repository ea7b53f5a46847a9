#include "assessment/process/pace.h"

#include <algorithm>

#include "assessment/process/sample_spans.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::Recording;
using simulator::ToolSample;
using simulator::ToolStatus;

constexpr double idle_mm_s = 2.0;
constexpr std::int64_t least_idle_ticks = 1500;

std::optional<std::int64_t> first_tick_of(const Recording& recording, CutEventKind kind) {
  for (const CutEvent& event : recording.events) {
    if (event.kind == kind) return event.tick;
  }
  return std::nullopt;
}

/// The running time in (first, last].
Finding running_time(const Recording& recording, std::int64_t first_tick, std::int64_t last_tick) {
  // Both ends, and each pause's, lie within the ticks of a sample.
  std::int64_t ticks = 0, edge_ticks = 2;
  bool did_run = true;
  for (std::size_t index = 0; index < recording.samples.size(); ++index) {
    const ToolSample& sample = recording.samples[index];
    if (sample.tick <= first_tick || sample.tick > last_tick) continue;
    const bool runs = has(sample.status, ToolStatus::Running);
    if (runs) ticks += ticks_covered(recording.samples, index);
    if (runs != did_run) edge_ticks += ticks_covered(recording.samples, index);
    did_run = runs;
  }
  return {second_from_tick(ticks), first_tick, last_tick, second_from_tick(edge_ticks)};
}

std::optional<std::int64_t> first_cutting_tick(const Recording& recording) {
  const auto found = std::find_if(
      recording.samples.begin(), recording.samples.end(),
      [](const ToolSample& sample) { return has(sample.status, ToolStatus::Cutting); });
  if (found == recording.samples.end()) return std::nullopt;
  return found->tick;
}

Finding idle_time(std::span<const HandleStretch> stretches) {
  Finding idle;
  std::int64_t sum_ticks = 0, longest_ticks = 0, edge_ticks = 0;
  for (const HandleStretch& stretch : stretches) {
    for_each_run(
        stretch,
        [&](std::size_t index) {
          return stretch.speed_mm_s[index] < idle_mm_s &&
                 !has(stretch.status[index], ToolStatus::Cutting) &&
                 !has(stretch.status[index], ToolStatus::Boring);
        },
        [&](std::size_t first, std::size_t last) {
          const auto ticks = static_cast<std::int64_t>(last - first + 1);
          if (ticks <= least_idle_ticks) return;
          sum_ticks += ticks;
          edge_ticks += 2;
          if (ticks <= longest_ticks) return;
          longest_ticks = ticks;
          idle.first_tick = stretch.tick_at(first);
          idle.last_tick = stretch.tick_at(last);
        });
  }
  idle.value = second_from_tick(sum_ticks);
  idle.bound = second_from_tick(edge_ticks);
  return idle;
}

}  // namespace

Pace measure_pace(const Recording& recording, std::span<const HandleStretch> stretches) {
  Pace pace;
  pace.idle_s = idle_time(stretches);
  const auto started = first_tick_of(recording, CutEventKind::Started);
  const auto finished = first_tick_of(recording, CutEventKind::Finished);
  const auto cutting = first_cutting_tick(recording);
  if (started && finished) pace.time_s = running_time(recording, *started, *finished);
  if (started && cutting) pace.planning_s = running_time(recording, *started, *cutting);
  return pace;
}

}  // namespace hallux::assessment

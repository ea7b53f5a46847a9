#include "assessment/process/saw_care.h"

#include <algorithm>

#include "assessment/process/sample_spans.h"
#include "assessment/process/tool_place.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using simulator::ToolSample;
using simulator::ToolStatus;

constexpr std::int64_t least_air_ticks = 2000;

bool runs(const ToolSample& sample) noexcept { return has(sample.status, ToolStatus::SawOn); }
bool touches(const ToolSample& sample) noexcept {
  return has(sample.status, ToolStatus::InContact);
}

Finding air_time(std::span<const ToolSample> samples, const simulator::Bvh& surface,
                 const RigidTransform& bone_from_world) {
  Finding air;
  std::int64_t longest_ticks = 0, sum_ticks = 0, edge_ticks = 0;
  NearBone near(surface);
  for_each_stretch(
      samples,
      [&](std::size_t index) {
        const ToolSample& sample = samples[index];
        return runs(sample) && !touches(sample) &&
               near.holds(tip_in_bone_mm(sample, bone_from_world));
      },
      [&](std::size_t first, std::size_t last) {
        const std::int64_t ticks =
            samples[last].tick - samples[first].tick + ticks_covered(samples, first);
        if (ticks <= least_air_ticks) return;
        sum_ticks += ticks;
        edge_ticks += ticks_covered(samples, first) + ticks_covered(samples, last);
        if (ticks <= longest_ticks) return;
        longest_ticks = ticks;
        air.first_tick = samples[first].tick;
        air.last_tick = samples[last].tick;
      });
  air.value = second_from_tick(sum_ticks);
  air.bound = second_from_tick(edge_ticks);
  return air;
}

Finding start_in_bone(std::span<const ToolSample> samples) {
  for (std::size_t index = 1; index < samples.size(); ++index) {
    const bool is_switched_on = runs(samples[index]) && !runs(samples[index - 1]);
    if (!is_switched_on || !touches(samples[index - 1])) continue;
    return {1.0, samples[index].tick, samples[index].tick};
  }
  return {};
}

std::optional<Finding> wet_share(std::span<const ToolSample> samples) {
  std::int64_t sawn_ticks = 0, wet_ticks = 0, edge_ticks = 0;
  bool was_cutting = false, was_wet = false;
  Finding share;
  bool is_found = false;
  for (std::size_t index = 0; index < samples.size(); ++index) {
    const ToolSample& sample = samples[index];
    const bool is_cutting = has(sample.status, ToolStatus::Cutting);
    const bool is_wet = is_cutting && has(sample.status, ToolStatus::Irrigated);
    const bool is_edge = is_cutting != was_cutting || is_wet != was_wet;
    if (is_edge) edge_ticks += ticks_covered(samples, index);
    was_cutting = is_cutting;
    was_wet = is_wet;
    if (!is_cutting) continue;
    const std::int64_t ticks = ticks_covered(samples, index);
    sawn_ticks += ticks;
    if (is_wet) {
      wet_ticks += ticks;
    } else if (!is_found) {
      is_found = true;
      share.first_tick = share.last_tick = sample.tick;
    }
  }
  if (sawn_ticks == 0) return std::nullopt;
  const auto count = static_cast<double>(sawn_ticks);
  share.value = static_cast<double>(wet_ticks) / count;
  // All or nothing stays so, wherever the sawing began and ended.
  const bool is_mixed = wet_ticks > 0 && wet_ticks < sawn_ticks;
  share.bound = is_mixed ? std::min(1.0, static_cast<double>(edge_ticks) / count) : 0.0;
  return share;
}

}  // namespace

SawCare measure_saw_care(const simulator::Recording& recording, const simulator::Bvh& surface,
                         const RigidTransform& bone_from_world) {
  const std::span<const ToolSample> samples = recording.samples;
  return {air_time(samples, surface, bone_from_world), start_in_bone(samples), wet_share(samples)};
}

}  // namespace hallux::assessment

#include "assessment/process/break_throughs.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"
#include "simulator/record/sample_force.h"

namespace hallux::assessment {

namespace {

using simulator::CutEvent;
using simulator::ToolSample;

constexpr std::int64_t plunge_ticks = 200, before_ticks = 20, after_ticks = 50;

std::span<const ToolSample> between(std::span<const ToolSample> samples, std::int64_t first_tick,
                                    std::int64_t last_tick) {
  const auto first = std::lower_bound(
      samples.begin(), samples.end(), first_tick,
      [](const ToolSample& sample, std::int64_t tick) { return sample.tick < tick; });
  const auto last = std::upper_bound(
      first, samples.end(), last_tick,
      [](std::int64_t tick, const ToolSample& sample) { return tick < sample.tick; });
  return {first, last};
}

void raise_plunge(BreakThroughs& worst, const BreakThroughWorld& world, const CutEvent& event) {
  const auto after = between(world.recording.samples, event.tick, event.tick + plunge_ticks);
  if (after.empty()) return;
  const RigidTransform bone_from_tool_then =
      world.bone_from_world * transform_from(after.front().world_from_tool);
  const Vec3 feed = axis_x(bone_from_tool_then);
  double before_mm = 0.0, longest_mm = 0.0;
  for (const ToolSample& sample : after) {
    const RigidTransform bone_from_tool =
        world.bone_from_world * transform_from(sample.world_from_tool);
    double furthest_mm = -INFINITY;
    for (const double aside_mm : {-0.5 * world.blade.width_mm, 0.5 * world.blade.width_mm}) {
      const Vec3 tooth_mm = transform_point(bone_from_tool, Vec3{0.0, aside_mm, 0.0});
      const double plunge_mm = glm::dot(feed, tooth_mm - bone_from_tool_then.translation_mm);
      furthest_mm = std::max(furthest_mm, plunge_mm);
      if (plunge_mm <= worst.plunge_mm.value) continue;
      worst.plunge_mm = {plunge_mm, event.tick, sample.tick, worst.plunge_mm.bound};
      worst.plunge_in_bone_mm = tooth_mm;
    }
    if (&sample != &after.front())
      longest_mm = std::max(longest_mm, std::abs(furthest_mm - before_mm));
    before_mm = furthest_mm;
  }
  // Where the teeth stood as they left bone, and where they were furthest, each within a tick.
  worst.plunge_mm.bound = std::max(worst.plunge_mm.bound, 2.0 * longest_mm);
}

/// The greatest less the least of what `of(index)` says, for indices below `count`.
template <typename Of>
double range_of(std::size_t count, Of&& of) {
  double least = INFINITY, greatest = -INFINITY;
  for (std::size_t index = 0; index < count; ++index) {
    least = std::min(least, of(index));
    greatest = std::max(greatest, of(index));
  }
  return greatest > least ? greatest - least : 0.0;
}

void raise_force(BreakThroughs& worst, const BreakThroughWorld& world, const CutEvent& event) {
  const auto before = between(world.recording.samples, event.tick - before_ticks, event.tick - 1);
  if (before.empty()) return;
  double sum_newton = 0.0;
  for (const ToolSample& sample : before) sum_newton += simulator::force_size_newton(sample);
  const double mean_newton = sum_newton / static_cast<double>(before.size());
  if (worst.force_newton && worst.force_newton->value >= mean_newton) return;
  // A tick sooner or later one of them is another one.
  const double range_newton = range_of(
      before.size(), [&](std::size_t i) { return simulator::force_size_newton(before[i]); });
  worst.force_newton = Finding{mean_newton, before.front().tick, event.tick,
                               range_newton / static_cast<double>(before.size())};
}

void raise_speed(BreakThroughs& worst, const BreakThroughWorld& world, const CutEvent& event) {
  const auto after = between(world.recording.samples, event.tick, event.tick + after_ticks);
  if (after.size() < 2) return;
  const RigidTransform first = transform_from(after.front().world_from_tool);
  const RigidTransform last = transform_from(after.back().world_from_tool);
  const double way_mm = glm::dot(last.translation_mm - first.translation_mm, axis_x(first));
  const double speed_mm_s =
      std::max(0.0, way_mm / second_from_tick(after.back().tick - after.front().tick));
  if (worst.speed_mm_s && worst.speed_mm_s->value >= speed_mm_s) return;
  // A tick sooner or later one of the ways from tick to tick is another one.
  const double range_mm = range_of(after.size() - 1, [&](std::size_t i) {
    const Vec3 step_mm = transform_from(after[i + 1].world_from_tool).translation_mm -
                         transform_from(after[i].world_from_tool).translation_mm;
    return glm::dot(step_mm, axis_x(first));
  });
  worst.speed_mm_s = Finding{speed_mm_s, after.front().tick, after.back().tick,
                             range_mm / second_from_tick(after.back().tick - after.front().tick)};
}

}  // namespace

BreakThroughs measure_break_throughs(const BreakThroughWorld& world,
                                     std::span<const std::int32_t> kerfs) {
  BreakThroughs worst;
  for (const CutEvent& event : world.recording.events) {
    if (event.kind != simulator::CutEventKind::Breakthrough) continue;
    if (std::find(kerfs.begin(), kerfs.end(), event.subject) == kerfs.end()) continue;
    raise_plunge(worst, world, event);
    raise_force(worst, world, event);
    raise_speed(worst, world, event);
  }
  return worst;
}

}  // namespace hallux::assessment

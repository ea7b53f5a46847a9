#include "assessment/process/effect_steps.h"

#include <algorithm>

#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

/// A cell's dose over steps of 16 ticks is within this factor of the exact one
/// (HeatSteps in tests/assessment/process).
constexpr double dose_factor = 1.25;

}  // namespace

EffectSteps::EffectSteps(const simulator::Blade& blade, std::size_t zones)
    : blade_(blade), zones_(zones) {}

double EffectSteps::way_mm(const simulator::ToolSample& sample) const noexcept {
  if (last_tick_ < 0) return 0.0;
  const RigidTransform before = transform_from(last_pose_);
  const RigidTransform now = transform_from(sample.world_from_tool);
  const double half_mm = 0.5 * blade_.width_mm;
  double longest_mm = 0.0;
  for (const double x_mm : {0.0, -blade_.depth_mm}) {
    for (const double y_mm : {-half_mm, half_mm}) {
      const Vec3 corner_mm{x_mm, y_mm, 0.0};
      longest_mm = std::max(longest_mm, length_of(transform_point(now, corner_mm) -
                                                  transform_point(before, corner_mm)));
    }
  }
  return longest_mm;
}

void EffectSteps::note(const simulator::ToolSample& sample, const simulator::ToolEffects& effects) {
  const auto ticks =
      std::clamp<std::int64_t>(sample.tick - last_tick_, 1, simulator::ticks_per_line_max);
  note_zones(sample, effects.danger().tracks(), second_from_tick(ticks));
  const double hot_s = effects.heat().summary().hot_s;
  const bool is_hot = hot_s > hot_s_;
  if (is_hot != is_hot_)
    hot_bound_s_ +=
        second_from_tick(static_cast<std::int64_t>(simulator::HeatField::group_count) * ticks);
  is_hot_ = is_hot;
  hot_s_ = hot_s;
  last_tick_ = sample.tick;
  last_pose_ = sample.world_from_tool;
}

void EffectSteps::note_zones(const simulator::ToolSample& sample,
                             std::span<const simulator::DangerTrack> tracks, double span_s) {
  for (std::size_t index = 0; index < zones_.size(); ++index) {
    const simulator::DangerTrack& track = tracks[index];
    Zone& zone = zones_[index];
    const bool is_in = track.contact_s > zone.contact_s;
    if (is_in != zone.is_in) zone.bound_s += span_s;
    zone.is_in = is_in;
    zone.contact_s = track.contact_s;
    if (track.state != simulator::DangerState::Far)
      zone.way_mm = std::max(zone.way_mm, way_mm(sample));
  }
}

double EffectSteps::danger_bound_s(std::size_t zone,
                                   const simulator::DangerTrack& track) const noexcept {
  const bool has_grazed = track.contact_s == 0.0 && danger_bound_mm(zone, track) > 0.0;
  return zones_[zone].bound_s + (has_grazed ? step_s : 0.0);
}

double EffectSteps::danger_bound_mm(std::size_t zone,
                                    const simulator::DangerTrack& track) const noexcept {
  const double deepest_mm = 0.5 * zones_[zone].way_mm - track.least_mm;
  return std::max(0.0, deepest_mm) - std::max(0.0, -track.least_mm);
}

double EffectSteps::hot_bound_s() const noexcept { return hot_bound_s_; }

double necrotic_bound_mm3(const simulator::HeatField& heat) noexcept {
  const std::int64_t unsure = heat.cells_with_dose(simulator::necrosis_dose_min / dose_factor,
                                                   simulator::necrosis_dose_min * dose_factor);
  return static_cast<double>(unsure) * simulator::heat_cell_volume_mm3;
}

}  // namespace hallux::assessment

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

double EffectSteps::way_mm(const simulator::ToolSample& sample) noexcept {
  const RigidTransform world_from_tool = transform_from(sample.world_from_tool);
  const double half_mm = 0.5 * blade_.width_mm, depth_mm = blade_.depth_mm;
  const std::array<Vec3, 4> corners{Vec3{0.0, -half_mm, 0.0}, Vec3{0.0, half_mm, 0.0},
                                    Vec3{-depth_mm, -half_mm, 0.0}, Vec3{-depth_mm, half_mm, 0.0}};
  double longest_mm = 0.0;
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    const Vec3 place_mm = transform_point(world_from_tool, corners[corner]);
    longest_mm = std::max(longest_mm, length_of(place_mm - corners_mm_[corner]));
    corners_mm_[corner] = place_mm;
  }
  return last_tick_ < 0 ? 0.0 : longest_mm;
}

void EffectSteps::note(const simulator::ToolSample& sample, const simulator::ToolEffects& effects) {
  const double way_mm = this->way_mm(sample);
  const auto ticks =
      std::clamp<std::int64_t>(sample.tick - last_tick_, 1, simulator::ticks_per_line_max);
  last_tick_ = sample.tick;
  const double span_s = second_from_tick(ticks);
  for (std::size_t index = 0; index < zones_.size(); ++index) {
    const simulator::DangerTrack& track = effects.danger().tracks()[index];
    Zone& zone = zones_[index];
    const bool is_in = track.contact_s > zone.contact_s;
    if (is_in != zone.is_in) zone.bound_s += span_s;
    zone.is_in = is_in;
    zone.contact_s = track.contact_s;
    if (track.state != simulator::DangerState::Far) zone.way_mm = std::max(zone.way_mm, way_mm);
  }
  const double hot_s = effects.heat().summary().hot_s;
  const bool is_hot = hot_s > hot_s_;
  if (is_hot != is_hot_) hot_bound_s_ += simulator::HeatField::group_count * span_s;
  is_hot_ = is_hot;
  hot_s_ = hot_s;
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

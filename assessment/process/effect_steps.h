/// How coarsely heat and danger zones are followed: what their bounds are made of.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulator/step/tool_effects.h"

namespace hallux::assessment {

class EffectSteps {
 public:
  EffectSteps(const simulator::Blade& blade, std::size_t zones);

  /// needs   samples in their order, each after the effects took it
  void note(const simulator::ToolSample& sample, const simulator::ToolEffects& effects);

  /// Of the time at or below 0 mm: the tick in which each such time began or ended.
  double danger_bound_s(std::size_t zone, const simulator::DangerTrack& track) const noexcept;
  /// Of the depth: between two ticks the blade comes no nearer than by half its way.
  double danger_bound_mm(std::size_t zone, const simulator::DangerTrack& track) const noexcept;
  /// Of the time with hot bone: a cell is followed every 16th tick.
  double hot_bound_s() const noexcept;

 private:
  struct Zone {
    double contact_s = 0.0, bound_s = 0.0;
    /// The longest way of the blade in a tick while it was near the zone.
    double way_mm = 0.0;
    bool is_in = false;
  };

  void note_zones(const simulator::ToolSample& sample,
                  std::span<const simulator::DangerTrack> tracks, double span_s);
  /// The longest way of a corner of the blade since the sample before.
  double way_mm(const simulator::ToolSample& sample) const noexcept;

  simulator::Blade blade_;
  std::vector<Zone> zones_;
  simulator::QuantisedPose last_pose_;
  double hot_s_ = 0.0, hot_bound_s_ = 0.0;
  std::int64_t last_tick_ = -1;
  bool is_hot_ = false;
};

/// Of the volume that heat killed: the cells whose dose is so near to the limit that halving the
/// steps in time might decide otherwise.
double necrotic_bound_mm3(const simulator::HeatField& heat) noexcept;

}  // namespace hallux::assessment

/// What a hand did over an attempt, moment by moment: push, heat and depth, and what came of it.
/// For pictures and tables.
#pragma once

#include <cstdint>
#include <vector>

#include "scenarios/hands/feeling_hand.h"
#include "scenarios/scenario.h"

namespace hallux::tests {

/// Every so many ticks.
inline constexpr std::int64_t ticks_per_moment = 50;

struct HandMoment {
  double time_s = 0.0;
  /// Along the feed, the most since the moment before.
  double push_newton = 0.0;
  double hottest_celsius = 37.0;
  /// Of the teeth, from the first bone of the section; below 0 in front of it.
  double depth_mm = 0.0;
  bool is_rinsed = false;
};

struct HandTrace {
  std::vector<HandMoment> moments;
  /// From the first to the last bone of the section.
  double bone_mm = 0.0;
  double peak_newton = 0.0;
  /// How far the teeth came beyond the last bone.
  double beyond_mm = 0.0;
  /// Time in which any bone was above 47 degrees.
  double hot_s = 0.0;
  double hottest_celsius = 37.0;
  double necrotic_mm3 = 0.0;
  /// Cut without water.
  double dry_s = 0.0;
  double cut_s = 0.0;
  std::int32_t zone_contacts = 0;
  /// In contact, summed over the zones.
  double zone_s = 0.0;
};

/// The hand's attempt at the scenario's first cut, traced over all of it.
HandTrace trace_hand(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                     const scenarios::Plan& plan, scenarios::FeelingHand& hand);

}  // namespace hallux::tests

/// What the saw did over an attempt: force, feed, advance and heat over time, and the danger zones
/// that it touched.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/effect_track.h"
#include "scenarios/scenario.h"
#include "simulator/base/progress.h"
#include "simulator/contact/heat.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/mesh/bones.h"
#include "simulator/record/guidance.h"
#include "simulator/record/record.h"

namespace hallux::ui {

struct TracePoint {
  double time_s = 0.0;
  /// Greatest in this stretch of time.
  double force_newton = 0.0;
  /// Of the teeth in their kerf; nothing outside one.
  std::optional<double> advance_mm;
  /// Way of the teeth through bone in this stretch.
  double fed_mm = 0.0;
  /// Of all bone, at its end.
  double hottest_celsius = simulator::body_celsius;
};

struct TraceMark {
  double time_s = 0.0;
  std::string text;
};

struct Traces {
  std::vector<TracePoint> points;
  std::vector<TraceMark> marks;
  /// Of the whole attempt.
  simulator::HeatSummary heat;
  /// Of the blade, by its bending.
  double greatest_deflection_mm = 0.0;
};

/// What a danger zone had of the running saw.
struct ZoneContact {
  std::string title;
  int count = 0;
  double duration_s = 0.0;
  /// When it was first touched; 0 where it never was.
  double first_s = 0.0;
};

/// Force, feed, advance and heat in at most `points_max` stretches of equal time.
/// is_guided  a guide led the hand
/// needs   `kerfs` as the recording opened them
/// errors  Cancelled
Traces traces_of(const simulator::Recording& recording, simulator::Bones bones, bool is_guided,
                 const simulator::KerfSet& kerfs, std::size_t points_max = 480,
                 const Progress& progress = {});

/// How often and how long the running saw was in each danger zone of the scenario, in its order.
std::vector<ZoneContact> zone_contacts(const scenarios::Scenario& scenario,
                                       const simulator::Recording& recording);
/// The same; nothing where the recording is of an engine that watched no zones.
std::vector<ZoneContact> watched_zones(const scenarios::Scenario& scenario,
                                       const simulator::Recording& recording);

}  // namespace hallux::ui

#include "assessment/measure_process.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "assessment/make_measurement.h"
#include "assessment/number_text.h"
#include "assessment/process/entries.h"
#include "assessment/process/free_movements.h"
#include "assessment/process/handle_track.h"
#include "assessment/process/pace.h"
#include "assessment/process/pushes.h"
#include "assessment/process/sample_spans.h"
#include "assessment/process/saw_care.h"
#include "assessment/process/step_order.h"
#include "assessment/process/tool_path.h"
#include "assessment/process/tool_place.h"
#include "assessment/process/wrong_bones.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using simulator::ToolSample;

/// Gathers the attempt's metrics, with the tool's place at their moments.
class ProcessList {
 public:
  explicit ProcessList(const Evidence& evidence)
      : evidence_(evidence), bone_from_world_(inverse(evidence.bones.first().world_from_bone)) {}

  void add(Metric metric, const Finding& finding) {
    made_.push_back(measured(metric, finding, tool_at(finding.first_tick)));
  }
  void add(Metric metric, const std::optional<Finding>& finding, Absence otherwise) {
    if (finding) return add(metric, *finding);
    made_.push_back(absent(metric, otherwise, {}));
  }
  void add(Measurement measurement) { made_.push_back(std::move(measurement)); }
  Measurement& last() { return made_.back(); }
  std::vector<Measurement> take() { return std::move(made_); }

 private:
  /// In the bone's frame, at the first sample from this tick on.
  Vec3 tool_at(std::int64_t tick) const {
    const auto& samples = evidence_.recording.samples;
    const auto found = std::lower_bound(
        samples.begin(), samples.end(), tick,
        [](const ToolSample& sample, std::int64_t wanted) { return sample.tick < wanted; });
    if (found == samples.end()) return {0.0, 0.0, 0.0};
    return tip_in_bone_mm(*found, bone_from_world_);
  }

  const Evidence& evidence_;
  RigidTransform bone_from_world_;
  std::vector<Measurement> made_;
};

/// One zone's three metrics, or those of all of them together.
struct ZoneSum {
  std::int64_t contacts = 0;
  double contact_s = 0.0, depth_mm = 0.0;
  double bound_s = 0.0, bound_mm = 0.0;
  std::optional<ZoneContacts> touched;
};

ZoneSum sum_of(const FollowedEffects& effects, std::size_t zone) {
  const simulator::DangerTrack& track = effects.zone(zone);
  return {track.contacts,
          track.contact_s,
          std::max(0.0, -track.least_mm),
          effects.danger_bound_s(zone),
          effects.danger_bound_mm(zone),
          effects.contacts(zone)};
}

void add_to(ZoneSum& all, const ZoneSum& one) {
  all.contacts += one.contacts;
  all.contact_s += one.contact_s;
  // The deepest of all is no deeper than any zone could be.
  const double deepest_mm = std::max(all.depth_mm + all.bound_mm, one.depth_mm + one.bound_mm);
  all.depth_mm = std::max(all.depth_mm, one.depth_mm);
  all.bound_mm = deepest_mm - all.depth_mm;
  all.bound_s += one.bound_s;
  if (!one.touched) return;
  if (!all.touched) {
    all.touched = one.touched;
    return;
  }
  if (one.touched->first_tick < all.touched->first_tick) {
    all.touched->first_tick = one.touched->first_tick;
    all.touched->place_in_bone_mm = one.touched->place_in_bone_mm;
  }
  all.touched->last_tick = std::max(all.touched->last_tick, one.touched->last_tick);
}

void add_zone(ProcessList& list, const ZoneSum& sum, const std::string& zone,
              const std::vector<std::string>& titles, std::int64_t end_tick) {
  const ZoneContacts at = sum.touched.value_or(ZoneContacts{0, end_tick, {0.0, 0.0, 0.0}});
  const Moment moment{at.first_tick, at.last_tick};
  struct Row {
    Metric metric;
    double value, bound;
  };
  for (const auto& [metric, value, bound] :
       {Row{Metric::DangerContactsCount, static_cast<double>(sum.contacts), 0.0},
        Row{Metric::DangerS, sum.contact_s, sum.bound_s},
        Row{Metric::DangerDepthMm, sum.depth_mm, sum.bound_mm}}) {
    list.add(measured(metric, value, moment, at.place_in_bone_mm));
    list.last().bound += bound;
    list.last().zone = zone;
    if (!titles.empty()) list.last().detail = {DetailKind::Zones, {}, titles};
  }
}

/// The titles of the zones that were touched.
std::vector<std::string> touched_titles(const Evidence& evidence, const FollowedEffects& effects) {
  std::vector<std::string> titles;
  for (std::size_t zone = 0; zone < evidence.plan.danger_zones.size(); ++zone) {
    if (effects.zone(zone).contacts != 0)
      titles.push_back(evidence.scenario.danger_zones[zone].title);
  }
  return titles;
}

void add_zones(ProcessList& list, const Evidence& evidence, const FollowedEffects& effects) {
  const std::int64_t end_tick = last_tick_of(evidence.recording);
  ZoneSum all;
  for (std::size_t zone = 0; zone < evidence.plan.danger_zones.size(); ++zone) {
    const ZoneSum sum = sum_of(effects, zone);
    add_to(all, sum);
    add_zone(list, sum, evidence.plan.danger_zones[zone].name,
             {evidence.scenario.danger_zones[zone].title}, end_tick);
  }
  add_zone(list, all, "", touched_titles(evidence, effects), end_tick);
}

void add_heat(ProcessList& list, const FollowedEffects& effects, std::int64_t end_tick) {
  const auto add = [&](Metric metric, double value, const std::optional<HeatPlace>& place) {
    const HeatPlace at = place.value_or(HeatPlace{0, {0.0, 0.0, 0.0}});
    list.add(measured(metric, value, {at.tick, place ? at.tick : end_tick}, at.place_in_bone_mm));
    list.last().bound +=
        metric == Metric::HotS ? effects.hot_bound_s() : effects.necrotic_bound_mm3();
  };
  add(Metric::HotS, effects.heat().hot_s, effects.hot());
  list.last().detail = {
      DetailKind::Hottest, {rounded_to_micro(effects.heat().hottest_celsius)}, {}};
  add(Metric::NecroticMm3, effects.heat().necrotic_mm3, effects.dead());
}

void add_pushes(ProcessList& list, const Evidence& evidence) {
  const Pushes pushes = measure_pushes(evidence.recording);
  list.add(Metric::ForcePeakNewton, pushes.peak_newton, Absence::NotMade);
  list.add(Metric::ForceP95Newton, pushes.p95_newton, Absence::NotMade);
  list.add(Metric::SideLoadNewton, pushes.side_newton, Absence::NotMade);
}

void add_saw_care(ProcessList& list, const Evidence& evidence, const simulator::Bvh& surface) {
  const SawCare care = measure_saw_care(evidence.recording, surface,
                                        inverse(evidence.bones.first().world_from_bone));
  list.add(Metric::AirCuttingS, care.air_s);
  list.add(Metric::StartedInBone, care.started_in_bone);
  list.add(Metric::IrrigatedShare, care.irrigated_share, Absence::NotMade);
}

/// A recording without its tape does not tell how the handle moved.
Absence absence_of_movements(const Evidence& evidence) {
  return evidence.tape.count() == 0 ? Absence::NotRecorded : Absence::Undefined;
}

struct HandleFacts {
  Pace pace;
  FreeMovements movements;
};

/// The handle's track, tens of megabytes of a long attempt, is let go of.
HandleFacts handle_facts(const Evidence& evidence) {
  const std::vector<HandleStretch> stretches = handle_stretches(evidence.recorded());
  return {measure_pace(evidence.recording, stretches), free_movements(stretches)};
}

void add_movements(ProcessList& list, const Evidence& evidence, const simulator::Bvh& surface) {
  const auto [pace, movements] = handle_facts(evidence);
  const Smoothness smoothness =
      measure_smoothness(movements, free_movements(handle_stretches(evidence.recorded(), 2)));
  const Absence why = absence_of_movements(evidence);
  list.add(Metric::Sparc, smoothness.sparc, why);
  list.add(Metric::Ldlj, smoothness.ldlj, why);
  list.add(Metric::TimeS, pace.time_s, Absence::NotDone);
  list.add(Metric::PlanningS, pace.planning_s, Absence::NotMade);
  if (why == Absence::NotRecorded) {
    list.add(absent(Metric::IdleS, why, {}));
    list.add(absent(Metric::PathRatio, why, {}));
    return;
  }
  list.add(Metric::IdleS, pace.idle_s);
  list.add(Metric::PathRatio, measure_path_ratio(evidence, surface), Absence::NotMade);
}

/// Of an attempt that never began.
std::vector<Measurement> nothing_recorded(const Evidence& evidence) {
  std::vector<Measurement> made;
  const auto add = [&](Metric metric, const std::string& zone) {
    made.push_back(absent(metric, Absence::NotMade, {}));
    made.back().done_fraction = 0.0;
    made.back().zone = zone;
  };
  for (const scenarios::MetricName& metric : scenarios::known_metrics()) {
    const bool is_of_attempt = metric.subject == scenarios::MetricSubject::Attempt;
    if (is_of_attempt && metric.metric != Metric::JointMarginMm) add(metric.metric, "");
    if (metric.subject != scenarios::MetricSubject::Zone) continue;
    for (const scenarios::PlannedZone& zone : evidence.plan.danger_zones)
      add(metric.metric, zone.name);
    add(metric.metric, "");
  }
  return made;
}

}  // namespace

std::vector<Measurement> measure_process(const Evidence& evidence, const FollowedEffects& effects,
                                         const simulator::Bvh& surface) {
  if (evidence.recording.samples.empty()) return nothing_recorded(evidence);
  ProcessList list(evidence);
  add_zones(list, evidence, effects);
  add_heat(list, effects, last_tick_of(evidence.recording));
  add_pushes(list, evidence);
  list.add(Metric::RestartsCount, measure_restarts(evidence));
  add_saw_care(list, evidence, surface);
  add_movements(list, evidence, surface);
  list.add(Metric::WrongBonesCount, measure_wrong_bones(evidence));
  std::vector<Measurement> made = list.take();
  made.push_back(measured(Metric::StepOrder, measure_step_order(evidence), {}));
  const double done = done_fraction_of(evidence.faces);
  for (Measurement& each : made) each.done_fraction = done;
  return made;
}

}  // namespace hallux::assessment

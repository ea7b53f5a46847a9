#include "ui/report/traces.h"

#include <algorithm>
#include <utility>

#include "simulator/base/progress.h"
#include "simulator/base/units.h"
#include "simulator/jobs/lying_bones.h"
#include "simulator/record/sample_force.h"

namespace hallux::ui {

namespace {

using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::FragmentPoses;
using simulator::Recording;
using simulator::ToolSample;

/// Recordings of earlier ones say nothing of danger zones.
constexpr std::int32_t first_engine_that_watched_zones = 3;

/// Events that the report names.
constexpr std::pair<CutEventKind, const char*> mark_texts[] = {
    {CutEventKind::PlaneFrozen, "plane frozen"},  {CutEventKind::Breakthrough, "through"},
    {CutEventKind::PieceFreed, "piece free"},     {CutEventKind::HingeClosed, "closed"},
    {CutEventKind::DangerContact, "danger zone"}, {CutEventKind::Kick, "kick"}};

}  // namespace

std::vector<ZoneContact> zone_contacts(const scenarios::Scenario& scenario,
                                       const Recording& recording) {
  std::vector<ZoneContact> contacts;
  for (const scenarios::DangerZone& zone : scenario.danger_zones) {
    contacts.push_back({zone.title});
  }
  std::vector<std::optional<std::int64_t>> begun(contacts.size());
  const auto end_contact = [&](std::size_t zone, std::int64_t tick) {
    if (const auto from = std::exchange(begun[zone], std::nullopt)) {
      contacts[zone].duration_s += second_from_tick(tick - *from);
    }
  };
  for (const CutEvent& event : recording.events) {
    const auto zone = static_cast<std::size_t>(event.subject);
    const bool is_contact = event.kind == CutEventKind::DangerContact;
    if ((!is_contact && event.kind != CutEventKind::DangerLeft) || zone >= contacts.size())
      continue;
    end_contact(zone, event.tick);
    if (!is_contact) continue;
    if (contacts[zone].count++ == 0) contacts[zone].first_s = second_from_tick(event.tick);
    begun[zone] = event.tick;
  }
  for (std::size_t zone = 0; zone < contacts.size() && !recording.samples.empty(); ++zone) {
    end_contact(zone, recording.samples.back().tick);
  }
  return contacts;
}

std::vector<ZoneContact> watched_zones(const scenarios::Scenario& scenario,
                                       const Recording& recording) {
  if (recording.engine < first_engine_that_watched_zones) return {};
  return zone_contacts(scenario, recording);
}

Traces traces_of(const Recording& recording, simulator::Bones bones, bool is_guided,
                 const simulator::KerfSet& kerfs, std::size_t points_max,
                 const Progress& progress) {
  Traces traces;
  const std::size_t count = recording.samples.size();
  const std::size_t stretch = std::max<std::size_t>(1, (count + points_max - 1) / points_max);
  std::optional<double> before_mm;  // the advance at the sample before, where that cut too
  FragmentPoses fragments = poses_of(bones);
  auto event = recording.events.begin();
  for (std::size_t index = 0; index < count; ++index) {
    const ToolSample& sample = recording.samples[index];
    for (; event != recording.events.end() && event->tick <= sample.tick; ++event)
      fragments.apply(*event);
    if (index % stretch == 0) {
      TracePoint point;
      point.time_s = second_from_tick(sample.tick);
      traces.points.push_back(point);
    }
    TracePoint& point = traces.points.back();
    point.force_newton = std::max(point.force_newton, simulator::force_size_newton(sample));
    const std::optional<double> last_mm = std::exchange(before_mm, std::nullopt);
    if (sample.kerf < 0 || sample.kerf >= kerfs.count()) continue;
    const RigidTransform fragment_from_tool =
        fragments[kerfs.fragment_of(sample.kerf)].fragment_from_world *
        transform_from(sample.world_from_tool);
    point.advance_mm = planar_pose(kerfs.plane(sample.kerf), fragment_from_tool).tip_mm.x;
    if (!has(sample.status, simulator::ToolStatus::Cutting)) continue;
    before_mm = point.advance_mm;
    if (last_mm) point.fed_mm += std::max(0.0, *before_mm - *last_mm);
  }
  const assessment::EffectTrack effects =
      assessment::track_effects(bones, kerfs.tray(), is_guided, recording, stretch, progress);
  for (std::size_t point = 0; point < traces.points.size(); ++point) {
    traces.points[point].hottest_celsius = effects.hottest_celsius[point];
  }
  traces.heat = effects.heat;
  traces.greatest_deflection_mm = effects.greatest_deflection_mm;
  for (const CutEvent& said : recording.events) {
    for (const auto& [kind, text] : mark_texts)
      if (kind == said.kind) traces.marks.push_back({second_from_tick(said.tick), text});
  }
  return traces;
}

}  // namespace hallux::ui

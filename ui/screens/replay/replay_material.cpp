#include "ui/screens/replay/replay_material.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/base/units.h"
#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {

namespace {

using database::Action;
using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::Recording;
using simulator::ToolSample;
using simulator::ToolStatus;

constexpr double load_share = 0.1;
constexpr std::size_t track_points = 2400;
constexpr std::size_t speed_ticks = 20;
/// Further from every planned face the hand is on its way; no distance is said.
constexpr double near_plan_mm = 12.0;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct EventWords {
  CutEventKind kind;
  Meaning meaning;
  std::string_view words;
};
constexpr EventWords event_words[] = {
    {CutEventKind::Started, Meaning::Neutral, "replay.event.started"},
    {CutEventKind::Scratch, Meaning::Warn, "replay.event.scratch"},
    {CutEventKind::Kick, Meaning::Warn, "replay.event.kick"},
    {CutEventKind::PlaneFrozen, Meaning::Info, "replay.event.plane_frozen"},
    {CutEventKind::Breakthrough, Meaning::Neutral, "replay.event.breakthrough"},
    {CutEventKind::SectionCovered, Meaning::Good, "replay.event.section_covered"},
    {CutEventKind::PieceFreed, Meaning::Good, "replay.event.piece_freed"},
    {CutEventKind::PieceRemoved, Meaning::Neutral, "replay.event.piece_removed"},
    {CutEventKind::StepDone, Meaning::Neutral, "replay.event.step_done"},
    {CutEventKind::Paused, Meaning::Neutral, "replay.event.paused"},
    {CutEventKind::Resumed, Meaning::Neutral, "replay.event.resumed"},
    {CutEventKind::Fault, Meaning::Bad, "replay.event.fault"},
    {CutEventKind::Finished, Meaning::Good, "replay.event.finished"},
    {CutEventKind::Abandoned, Meaning::Warn, "replay.event.abandoned"},
    {CutEventKind::KerfRefused, Meaning::Warn, "replay.event.kerf_refused"},
    {CutEventKind::HingeClosed, Meaning::Good, "replay.event.hinge_closed"},
    {CutEventKind::HingeRefused, Meaning::Bad, "replay.event.hinge_refused"},
    {CutEventKind::BoneHot, Meaning::Warn, "replay.event.bone_hot"},
    {CutEventKind::BoneNecrosis, Meaning::Bad, "replay.event.bone_necrosis"},
    {CutEventKind::DangerContact, Meaning::Bad, "replay.event.danger_contact"},
    {CutEventKind::DangerLeft, Meaning::Neutral, "replay.event.danger_left"},
};

std::vector<ReplayEvent> events_of(const Recording& recording) {
  std::vector<ReplayEvent> events;
  for (const CutEvent& event : recording.events) {
    const auto* words =
        std::find_if(std::begin(event_words), std::end(event_words),
                     [&](const EventWords& each) { return each.kind == event.kind; });
    if (words == std::end(event_words)) continue;
    events.push_back({second_from_tick(event.tick), words->meaning, words->words});
  }
  return events;
}

/// A step lasts from the one before it to when it was declared done; the last one to the end.
std::vector<TimelineStep> steps_of(const Recording& recording, const scenarios::Scenario& scenario,
                                   double duration_s) {
  std::vector<TimelineStep> steps;
  double begin_s = 0.0;
  std::size_t next = 0;
  const auto add = [&](std::size_t index, double end_s) {
    if (index >= scenario.steps.size() || end_s <= begin_s) return;
    steps.push_back({begin_s, end_s, scenario.steps[index].title});
    begin_s = end_s;
    next = index + 1;
  };
  for (const CutEvent& event : recording.events) {
    if (event.kind == CutEventKind::StepDone && event.subject >= 0)
      add(static_cast<std::size_t>(event.subject), second_from_tick(event.tick));
  }
  add(next, duration_s);
  return steps;
}

double force_of(const ToolSample& sample) noexcept {
  const Vec3 force_mn(sample.force_mn[0], sample.force_mn[1], sample.force_mn[2]);
  return glm::length(force_mn) / 1000.0;
}

/// How the blade stands to the planned face that it is meant for: a degree counts as a millimetre.
struct ToPlan {
  double distance_mm = unknown, tilt_rad = unknown;
};
ToPlan to_plan(const scenarios::Plan& plan, const RigidTransform& bone_from_tool, double kerf_mm) {
  ToPlan nearest;
  double least = std::numeric_limits<double>::infinity();
  const Vec3 upwards = transform_direction(bone_from_tool, Vec3(0.0, 0.0, 1.0));
  for (const scenarios::PlannedCut& cut : plan.cuts) {
    const Vec3& normal = cut.face.normal;
    const double off_mm =
        glm::dot(normal, bone_from_tool.translation_mm) - cut.face.offset_mm - 0.5 * kerf_mm;
    const double cosine = std::min(1.0, std::abs(glm::dot(normal, upwards)));
    const double tilt_rad = std::acos(cosine);
    const double misfit = std::abs(off_mm) + degree_from_radian(tilt_rad);
    if (misfit >= least) continue;
    least = misfit;
    nearest = {off_mm, tilt_rad};
  }
  return std::abs(nearest.distance_mm) <= near_plan_mm ? nearest : ToPlan{};
}

void thin_out(ReplayMaterial& material) {
  const std::size_t step = std::max<std::size_t>(1, material.samples.size() / track_points);
  const RigidTransform bone_from_world = inverse(material.world_from_bone);
  for (std::size_t i = 0; i < material.samples.size(); i += step) {
    const std::size_t end = std::min(i + step, material.samples.size());
    double force = 0.0;
    for (std::size_t j = i; j < end; ++j) force = std::max(force, force_of(material.samples[j]));
    const ToolSample& sample = material.samples[i];
    const double time_s = second_from_tick(sample.tick);
    const ToPlan plan =
        to_plan(material.plan, bone_from_world * transform_from(sample.world_from_tool),
                material.scenario.blade.size.kerf_mm);
    material.force_newton.push_back({time_s, force});
    material.to_plan_mm.push_back({time_s, std::abs(plan.distance_mm)});
  }
}

void measure_bone(ReplayMaterial& material, const simulator::Bone& bone) {
  material.world_from_bone = bone.world_from_bone;
  Vec3 low = bone.outer.points_mm.front(), high = low;
  for (const Vec3& point : bone.outer.points_mm) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  material.middle_in_bone_mm = 0.5 * (low + high);
  material.radius_mm = std::max(1.0, 0.5 * glm::length(high - low));
}

struct Loaded {
  AttemptMaterial attempt;
  std::optional<database::StoredScore> score;
  AttemptRights rights;
};

Loaded load_for(Visit& visit, const database::AttemptId& id) {
  return visit.in_turn([&](database::Session& session, database::Database& database) {
    const database::AttemptHeader header = header_for(session, id);
    std::optional<database::AttemptDesk> desk = session.desk_for(Action::ViewAttempt, header.id);
    return Loaded{load_attempt(database, *desk, header.id), desk->score(header.id),
                  rights_to(session, header)};
  });
}

}  // namespace

std::shared_ptr<const ReplayMaterial> load_replay(Visit& visit, const database::AttemptId& id,
                                                  WorkReport& report) {
  Loaded loaded = load_for(visit, id);
  AttemptMaterial& attempt = loaded.attempt;
  auto material = std::make_shared<ReplayMaterial>();
  material->header = attempt.header;
  material->rights = loaded.rights;
  if (loaded.score) material->card = loaded.score->card;
  material->plan = plan_on(attempt.scenario, attempt.bone);
  measure_bone(*material, attempt.bone);
  const std::string name =
      "replay " + attempt.header.id.text + " " + std::to_string(attempt.recording.samples.size());
  material->history = build_history(
      {attempt.bone, attempt.scenario.blade.size, material->plan, attempt.recording, name},
      [&](double fraction) {
        if (!report.reached(load_share + (1.0 - load_share) * fraction))
          throw Cancelled("stopped before the bone could be shown");
      });
  material->events = events_of(attempt.recording);
  const std::int64_t last_tick =
      attempt.recording.samples.empty() ? 1 : attempt.recording.samples.back().tick;
  material->duration_s = std::max(0.001, second_from_tick(last_tick));
  material->steps = steps_of(attempt.recording, attempt.scenario, material->duration_s);
  material->samples = std::move(attempt.recording.samples);
  material->scenario = std::move(attempt.scenario);
  thin_out(*material);
  return material;
}

HandAtMoment hand_at(const ReplayMaterial& material, double time_s) noexcept {
  HandAtMoment hand;
  const auto tick = static_cast<std::int64_t>(std::llround(time_s / step_s));
  const auto next = std::upper_bound(
      material.samples.begin(), material.samples.end(), tick,
      [](std::int64_t wanted, const ToolSample& sample) { return wanted < sample.tick; });
  if (material.samples.empty()) return hand;
  const auto index = next == material.samples.begin()
                         ? std::size_t{0}
                         : static_cast<std::size_t>(next - material.samples.begin()) - 1;
  const ToolSample& sample = material.samples[index];
  hand.world_from_tool = transform_from(sample.world_from_tool);
  hand.is_saw_on = has(sample.status, ToolStatus::SawOn);
  hand.is_paused = !has(sample.status, ToolStatus::Running);
  hand.force_newton = force_of(sample);
  const ToolSample& before = material.samples[index - std::min(index, speed_ticks)];
  const Vec3 way =
      hand.world_from_tool.translation_mm - transform_from(before.world_from_tool).translation_mm;
  if (sample.tick > before.tick)
    hand.speed_mm_s = glm::length(way) / second_from_tick(sample.tick - before.tick);
  const ToPlan plan =
      to_plan(material.plan, inverse(material.world_from_bone) * hand.world_from_tool,
              material.scenario.blade.size.kerf_mm);
  hand.to_plan_mm = plan.distance_mm;
  hand.tilt_rad = plan.tilt_rad;
  return hand;
}

}  // namespace hallux::ui

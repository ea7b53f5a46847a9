// All of a replay, made once beside the window, so that any moment of it can be shown at once.
// Load, follow the kerfs, make the look, cut the history, thin out the curves: each takes its
// measured share of the bar. A curve has no more points than a wide window has pixels; force keeps
// the greatest of each stretch, so that no peak is lost. The tool is compared with what is planned
// for its kind and fits it best.
#include "ui/screens/replay/replay_material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>

#include "scenarios/site/plan_in_first.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/progress.h"
#include "simulator/base/units.h"
#include "simulator/bone/contact_points.h"
#include "simulator/record/sample_force.h"
#include "ui/jobs/attempt_jobs.h"
#include "ui/jobs/cached_fields.h"
#include "ui/jobs/made_attempt.h"
#include "ui/report/traces.h"
#include "ui/screens/pictures/bone_viewport.h"
#include "ui/screens/pictures/cached_look.h"

namespace hallux::ui {

namespace {

using database::Action;
using simulator::ToolSample;
using simulator::ToolStatus;

constexpr const char* stopped = "stopped before the bone could be shown";
/// Of what is left after loading.
constexpr double follow_share = 0.3, look_share = 0.5, history_share = 0.75;
constexpr double load_share = 0.1;
/// Of a replay that is made: operating takes by far the longest.
constexpr double made_share = 0.75;
/// Of what it makes: the bone, the operation, its score.
constexpr std::array stage_ends{0.1, 0.8, 1.0};
constexpr std::size_t track_points = 2400;
constexpr std::size_t speed_ticks = 20;

/// Of all bones, in the frame of the first.
void measure_bones(ReplayMaterial& material, const simulator::Bones& bones) {
  material.world_from_bone = bones.first().world_from_bone;
  const simulator::IndexedMesh outsides = outsides_of(bones);
  Vec3 low = outsides.points_mm.front(), high = low;
  for (const Vec3& point : outsides.points_mm) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  material.middle_in_bone_mm = 0.5 * (low + high);
  material.radius_mm = std::max(1.0, 0.5 * glm::length(high - low));
}

struct LoadedAttempt {
  AttemptMaterial attempt;
  std::optional<database::StoredScore> score;
  std::vector<simulator::DisplayFact> display_facts;
  AttemptRights rights;
  std::filesystem::path directory;
};

LoadedAttempt load_for(SignedInSession& signed_in, const database::AttemptId& id) {
  return signed_in.in_turn([&](database::Session& session, database::Database& database) {
    const database::AttemptHeader header = header_for(session, id);
    std::optional<database::AttemptDesk> desk = session.desk_for(Action::ViewAttempt, header.id);
    return LoadedAttempt{load_attempt(database, *desk, header.id), told_score(*desk, header.id),
                         desk->display_facts(header.id), rights_to(session, header),
                         database.directory()};
  });
}

/// What is opened of the bone, from a cache or followed anew.
using FollowKerfs =
    std::function<assessment::OpenedFields(const AttemptMaterial& attempt, const Progress&)>;

/// What a material is made from.
struct ReplayOrder {
  AttemptMaterial attempt;
  std::filesystem::path directory;
  /// Of its pictures: another recording has another.
  std::string name;
  FollowKerfs follow;
};

/// Of the bones as they were before anything was cut.
std::vector<PlannedFace> faces_of(const HistoryPicture& picture, const scenarios::Plan& plan,
                                  const simulator::Bones& bones) {
  std::deque<simulator::Bvh> trees;
  std::vector<simulator::SolidWithTree> wholes;
  for (std::size_t bone = 0; bone < bones.size(); ++bone) {
    const simulator::CutSolid& whole = picture.stretches[bone].front().solid;
    wholes.push_back({whole, trees.emplace_back(whole.mesh)});
  }
  return planned_faces(wholes, plan, bones);
}

/// The rest of the material, whose header, rights, card and views are there.
void complete(ReplayMaterial& material, ReplayOrder order, const Progress& reached) {
  AttemptMaterial& attempt = order.attempt;
  const scenarios::Plan plan = plan_on(attempt.scenario, attempt.bones);
  material.plan = plan_in_first(plan, attempt.bones);
  material.tray = scenarios::tray_of(attempt.scenario);
  measure_bones(material, attempt.bones);
  cancelled_as(stopped, [&] {
    assessment::OpenedFields opened = order.follow(attempt, part_of(reached, 0.0, follow_share));
    std::vector<BoneLook> looks;
    const double share = (look_share - follow_share) / static_cast<double>(attempt.bones.size());
    for (const simulator::Bone& bone : attempt.bones) {
      const double begin = follow_share + share * static_cast<double>(looks.size());
      looks.push_back(
          cached_look_of(order.directory, bone, part_of(reached, begin, begin + share)));
    }
    auto history = simulator::build_history(
        {attempt.bones, attempt.recording, std::move(opened), planned_bridges(plan), material.tray},
        part_of(reached, look_share, history_share));
    material.bone = picture_of(std::move(history), std::move(looks), order.name,
                               part_of(reached, history_share, 1.0));
  });
  material.faces = faces_of(*material.bone, plan, attempt.bones);
  material.events = events_of(attempt.recording);
  material.duration_s = duration_s_of(attempt.recording);
  material.steps = steps_of(attempt.recording, attempt.scenario, material.duration_s);
  material.samples = std::move(attempt.recording.samples);
  material.scenario = std::move(attempt.scenario);
  material.curves = curves_of(material, {0.0, material.duration_s});
}

/// Nothing while no saw is in the hand.
ToPlan sawn_to_plan(const ReplayMaterial& material, const ToolAtMoment& tool,
                    const RigidTransform& bone_from_tool) noexcept {
  if (tool.held != HeldTool::Saw) return {};
  return saw_to_plan(material.plan, bone_from_tool,
                     std::get<simulator::Saw>(*tool.tool).blade.kerf_mm);
}

ToPlan hand_to_plan(const ReplayMaterial& material, const ToolAtMoment& tool,
                    const RigidTransform& bone_from_tool) {
  switch (tool.held) {
    case HeldTool::Driver:
      return driver_to_plan(material.plan, bone_from_tool, *tool.tool);
    case HeldTool::Forceps: {
      const auto fragment = static_cast<std::size_t>(tool.grip->fragment);
      const auto& fragments = material.bone->history->fragments;
      const bool is_known = fragment < fragments.size() && fragments[fragment].whole != nullptr;
      if (!is_known) return {};
      const auto bone = static_cast<std::size_t>(fragments[fragment].origin.bone);
      const RigidTransform own_from_first =
          inverse(material.bone->history->world_from_bones[bone]) * material.world_from_bone;
      return piece_moved(own_from_first * bone_from_tool,
                         simulator::centroid_of(fragments[fragment].whole->solid.mesh));
    }
    case HeldTool::Saw:
      break;
  }
  return sawn_to_plan(material, tool, bone_from_tool);
}

Progress progress_to(WorkReport& report) {
  return [&report](double fraction) { return report.reached(fraction); };
}

/// Of making an attempt, by its stages: each begins where the one before ended.
StageProgress stages_of(const Progress& whole) {
  return [whole, stage = std::size_t{0}](const std::string&) mutable {
    const std::size_t now = std::min(stage++, stage_ends.size() - 1);
    return part_of(whole, now == 0 ? 0.0 : stage_ends[now - 1], stage_ends[now]);
  };
}

}  // namespace

std::shared_ptr<const ReplayMaterial> load_replay(SignedInSession& signed_in,
                                                  const database::AttemptId& id,
                                                  WorkReport& report) {
  LoadedAttempt loaded = load_for(signed_in, id);
  auto material = std::make_shared<ReplayMaterial>();
  material->header = loaded.attempt.header;
  material->rights = loaded.rights;
  if (loaded.score) material->card = loaded.score->card;
  material->seen = SeenViews(std::move(loaded.display_facts));
  const std::string name = "replay " + loaded.attempt.header.id.text + " " +
                           std::to_string(loaded.attempt.recording.samples.size());
  const FollowKerfs follow = [&](const AttemptMaterial& attempt, const Progress& progress) {
    return fields_of(attempt, loaded.directory, progress);
  };
  complete(*material, {std::move(loaded.attempt), loaded.directory, name, follow},
           part_of(progress_to(report), load_share, 1.0));
  return material;
}

std::shared_ptr<const ReplayMaterial> make_replay(const scenarios::Scenario& scenario,
                                                  const std::filesystem::path& directory,
                                                  WorkReport& report) {
  const Progress whole = progress_to(report);
  ScriptedAttempt expert;
  expert.scenario = scenario;
  MadeAttempt made = make_attempt(expert, stages_of(part_of(whole, 0.0, made_share)));
  auto material = std::make_shared<ReplayMaterial>();
  material->header = made.material.header;
  material->card = std::move(made.card);
  const FollowKerfs follow = [](const AttemptMaterial& attempt, const Progress& progress) {
    return assessment::opened_fields(scenarios::tray_of(attempt.scenario), attempt.bones,
                                     attempt.recording, progress);
  };
  const std::string name = "replay made " + std::to_string(picture_id(scenario.text));
  complete(*material, {std::move(made.material), directory, name, follow},
           part_of(whole, made_share, 1.0));
  return material;
}

Curves curves_of(const ReplayMaterial& material, const TimeRange& range) {
  const std::vector<ToolSample>& samples = material.samples;
  const auto at_or_after = [&](double time_s) {
    const auto tick = static_cast<std::int64_t>(std::floor(time_s / step_s));
    const auto found = std::lower_bound(
        samples.begin(), samples.end(), tick,
        [](const ToolSample& sample, std::int64_t wanted) { return sample.tick < wanted; });
    return static_cast<std::size_t>(found - samples.begin());
  };
  // One beyond each end, so that a curve leaves through the edge.
  const std::size_t first =
      at_or_after(range.begin_s) - std::min<std::size_t>(at_or_after(range.begin_s), 1);
  const std::size_t last = std::min(at_or_after(range.end_s) + 2, samples.size());
  const std::size_t step = std::max<std::size_t>(1, (last - std::min(first, last)) / track_points);
  const RigidTransform bone_from_world = inverse(material.world_from_bone);
  Curves curves;
  for (std::size_t i = first; i < last; i += step) {
    const std::size_t end = std::min(i + step, last);
    double force = 0.0;
    for (std::size_t j = i; j < end; ++j)
      force = std::max(force, simulator::force_size_newton(samples[j]));
    const double time_s = second_from_tick(samples[i].tick);
    const ToPlan plan = sawn_to_plan(
        material, tool_at(material.bone->history->hand, material.tray, samples[i].tick),
        bone_from_world * transform_from(samples[i].world_from_tool));
    curves.force_newton.push_back({time_s, force});
    curves.to_plan_mm.push_back({time_s, std::abs(plan.distance_mm)});
  }
  return curves;
}

HandAtMoment hand_at(const ReplayMaterial& material, double time_s) noexcept {
  HandAtMoment hand;
  const auto tick = static_cast<std::int64_t>(std::llround(time_s / step_s));
  const auto next = std::upper_bound(
      material.samples.begin(), material.samples.end(), tick,
      [](std::int64_t wanted, const ToolSample& sample) { return wanted < sample.tick; });
  hand.tool = tool_at(material.bone->history->hand, material.tray, tick);
  if (material.samples.empty()) return hand;
  const auto index = next == material.samples.begin()
                         ? std::size_t{0}
                         : static_cast<std::size_t>(next - material.samples.begin()) - 1;
  const ToolSample& sample = material.samples[index];
  hand.world_from_tool = transform_from(sample.world_from_tool);
  hand.tool = tool_at(material.bone->history->hand, material.tray, sample.tick);
  hand.is_running =
      has(sample.status, ToolStatus::SawOn) || has(sample.status, ToolStatus::DriveOn);
  hand.is_paused = !has(sample.status, ToolStatus::Running);
  hand.force_newton = simulator::force_size_newton(sample);
  const ToolSample& before = material.samples[index - std::min(index, speed_ticks)];
  const Vec3 way =
      hand.world_from_tool.translation_mm - transform_from(before.world_from_tool).translation_mm;
  if (sample.tick > before.tick)
    hand.speed_mm_s = glm::length(way) / second_from_tick(sample.tick - before.tick);
  hand.to_plan =
      hand_to_plan(material, hand.tool, inverse(material.world_from_bone) * hand.world_from_tool);
  return hand;
}

}  // namespace hallux::ui

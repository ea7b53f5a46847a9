#include "assessment/assess.h"

#include <iterator>
#include <utility>

#include "assessment/ledger.h"
#include "assessment/measure_closing.h"
#include "assessment/measure_cut.h"
#include "assessment/measure_deed.h"
#include "assessment/measure_hinge.h"
#include "assessment/measure_joint.h"
#include "assessment/measure_piece.h"
#include "assessment/measure_process.h"
#include "assessment/rebuild/open_kerfs.h"
#include "assessment/sawn_after_done.h"
#include "assessment/sentences.h"

namespace hallux::assessment {

namespace {

/// Of the whole work; the rest is to measure it.
constexpr double rebuilt_share = 0.8;
constexpr std::size_t samples_per_report = 4096;

/// With each sample as the kerfs stood then.
void follow_again(FollowedEffects& effects, const scenarios::Scenario& scenario,
                  const simulator::Bone& bone, const simulator::Recording& recording,
                  const Progress& progress) {
  simulator::KerfSet kerfs(scenario.saw.blade, bone.world_from_bone);
  const auto count = static_cast<double>(recording.samples.size());
  open_kerfs(
      kerfs, recording, [](std::int64_t) {},
      [&](std::size_t index, const simulator::FieldWindow&) {
        effects.follow(recording.samples[index], kerfs);
        if (index % samples_per_report == 0) report(progress, static_cast<double>(index) / count);
      });
}

/// Opens the kerfs once, and follows their heat on the way; of fields that were kept, which know no
/// time between, in a way of its own.
RebuiltBone rebuild_and_follow(FollowedEffects& effects, const scenarios::Scenario& scenario,
                               const simulator::Bone& bone, const simulator::Recording& recording,
                               const Progress& progress, const OpenedFields* opened) {
  const simulator::Blade& blade = scenario.saw.blade;
  if (opened != nullptr) {
    follow_again(effects, scenario, bone, recording, part_of(progress, 0.0, 0.5));
    return rebuild(bone, blade, recording, part_of(progress, 0.5, 1.0), opened);
  }
  return rebuild(bone, blade, recording, progress, nullptr,
                 [&](const simulator::ToolSample& sample, const simulator::KerfSet& kerfs) {
                   effects.follow(sample, kerfs);
                 });
}

void add(std::vector<Measurement>& all, std::vector<Measurement> made) {
  std::move(made.begin(), made.end(), std::back_inserter(all));
}

void measure_all(Examination& examination, const Evidence& evidence, const FollowedEffects& effects,
                 const Progress& progress) {
  std::vector<Measurement>& all = examination.measurements;
  all = measure_geometry(evidence);
  for (std::size_t cut = 0; cut < evidence.plan.cuts.size(); ++cut) {
    note_sawn_after_done(all, evidence.scenario, evidence.plan.cuts[cut].name, evidence.faces[cut],
                         evidence.recording);
  }
  add(all, measure_deeds(evidence, progress));
  add(all, measure_closings(evidence));
  add(all, measure_process(evidence, effects));
}

}  // namespace

Examination assess_fully(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                         const simulator::Recording& recording, std::string_view device_class,
                         const Progress& progress, const OpenedFields* opened) {
  // The plan comes first: a scenario that does not fit the bone is refused before the long work.
  scenarios::Plan plan = plan_on(scenario, bone);
  FollowedEffects effects(bone, scenario.saw, plan);
  RebuiltBone rebuilt = rebuild_and_follow(effects, scenario, bone, recording,
                                           part_of(progress, 0.0, rebuilt_share), opened);
  Examination examination{std::move(plan), std::move(rebuilt), {}, {}, {}};
  for (std::size_t cut = 0; cut < examination.plan.cuts.size(); ++cut)
    examination.faces.push_back(
        faces_of_cut(examination.rebuilt, examination.plan, cut, {scenario.steps, recording}));
  const Evidence evidence{scenario, examination.plan, examination.rebuilt, examination.faces,
                          bone,     recording};
  measure_all(examination, evidence, effects, part_of(progress, rebuilt_share, 1.0));
  examination.card =
      score_measurements(scenario, examination.measurements, device_class, recording.engine);
  return examination;
}

std::vector<Measurement> measure_geometry(const Evidence& evidence) {
  const simulator::Bvh surface(evidence.bone.outer);
  std::vector<Measurement> all;
  for (std::size_t cut = 0; cut < evidence.plan.cuts.size(); ++cut)
    add(all, measure_cut(cut, evidence));
  for (const scenarios::PlannedHinge& hinge : evidence.plan.hinges)
    add(all, measure_hinge(hinge, evidence, all));
  add(all, measure_pieces(evidence, surface));
  all.push_back(joint_margin_measurement(evidence));
  return all;
}

database::ScoreCard score_measurements(const scenarios::Scenario& scenario,
                                       std::span<const Measurement> measurements,
                                       std::string_view device_class, std::int32_t engine) {
  scenarios::Scenario scored = scenario;
  scored.rubric = rubric_for(scenario.rubric, device_class);
  database::ScoreCard card = score_rubric(scored.rubric, measurements);
  card.scenario = scenario.name;
  card.scenario_version = scenario.version;
  card.engine = engine;
  card.is_reviewed = scenario.is_reviewed;
  explain(card, scored, measurements);
  return card;
}

database::ScoreCard assess(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                           const simulator::Recording& recording, std::string_view device_class,
                           const Progress& progress) {
  return assess_fully(scenario, bone, recording, device_class, progress).card;
}

}  // namespace hallux::assessment

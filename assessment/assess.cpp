#include "assessment/assess.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "assessment/card_facts.h"
#include "assessment/fixation/measure_fragments.h"
#include "assessment/fixation/measure_implants.h"
#include "assessment/fixation/what_is_left.h"
#include "assessment/ledger.h"
#include "assessment/measure_closing.h"
#include "assessment/measure_cut.h"
#include "assessment/measure_deed.h"
#include "assessment/measure_hinge.h"
#include "assessment/measure_joint.h"
#include "assessment/measure_piece.h"
#include "assessment/measure_process.h"
#include "assessment/process/sawn_after_done.h"
#include "assessment/rebuild/bound.h"
#include "assessment/rebuild/geometry_bounds.h"
#include "assessment/sentences.h"
#include "scenarios/tray/laid_out_tools.h"

namespace hallux::assessment {

namespace {

/// Of the whole work; the rest is to measure it.
constexpr double rebuilt_share = 0.8;

/// Opens the kerfs once, and follows their heat on the way.
RebuiltBone rebuild_and_follow(FollowedEffects& effects, const scenarios::Scenario& scenario,
                               const scenarios::Plan& plan, const simulator::Bones& bones,
                               const simulator::Recording& recording, const Progress& progress) {
  const auto follow = [&](const simulator::ToolSample& sample, const simulator::KerfSet& kerfs) {
    effects.follow(sample, kerfs);
  };
  return rebuild(bones, scenarios::tray_of(scenario), recording, progress, nullptr, follow,
                 hinges_of(plan));
}

void find_faces(Examination& examination, const scenarios::Scenario& scenario,
                const simulator::Recording& recording) {
  for (std::size_t cut = 0; cut < examination.plan.cuts.size(); ++cut)
    examination.faces.push_back(
        faces_of_cut(examination.rebuilt, examination.plan, cut, {scenario.steps, recording}));
}

void add(std::vector<Measurement>& all, std::vector<Measurement> made) {
  std::move(made.begin(), made.end(), std::back_inserter(all));
}

/// With the first measurement of such a cut.
void remark_sawn_after_done(std::vector<Measurement>& all, const Evidence& evidence) {
  for (std::size_t cut = 0; cut < evidence.plan.cuts.size(); ++cut) {
    const std::string& name = evidence.plan.cuts[cut].name;
    const auto first = std::ranges::find(all, name, &Measurement::cut);
    if (first != all.end() &&
        is_sawn_after_done(evidence.scenario, name, evidence.faces[cut], evidence.recording))
      first->remark = Remark::SawnAfterDone;
  }
}

/// Of the patient's bones, that in whose frame a measurement has its place: the first for what is
/// about none of the plan's parts.
std::size_t bone_of(const Measurement& measurement, const scenarios::Plan& plan) {
  if (const auto* cut = find_cut(plan, measurement.cut)) return cut->bone;
  if (const auto* hinge = find_hinge(plan, measurement.hinge)) return hinge->bone;
  if (const auto* fragment = find_fragment(plan.fixation, measurement.fragment))
    return fragment->bone;
  return 0;
}

void measure_all(Examination& examination, const Evidence& evidence, const FollowedEffects& effects,
                 const Progress& progress) {
  std::vector<Measurement>& all = examination.measurements;
  const BoneSurfaces surfaces(evidence.bones, effects.surfaces());
  all = measure_geometry(evidence, surfaces);
  remark_sawn_after_done(all, evidence);
  add(all, measure_deeds(evidence, progress));
  add(all, measure_closings(evidence));
  const scenarios::PlannedFixation& fixation = evidence.plan.fixation;
  if (!fixation.fragments.empty() || !fixation.implants.empty()) {
    const WhatIsLeft left =
        what_is_left(evidence.recording, evidence.rebuilt, evidence.bones, evidence.plan);
    add(all, measure_fragments(left, evidence));
    add(all, measure_implants(left, evidence));
  }
  add(all, measure_process(evidence, effects, surfaces.together()));
  say_in_first(all, evidence);
}

void bound_geometry(std::vector<Measurement>& all, const Evidence& evidence) {
  for (Measurement& each : all) {
    if (!each.is_measured()) continue;
    const scenarios::Metric metric = scenarios::find_metric(each.metric)->metric;
    std::optional<double> bound;
    if (!each.hinge.empty()) bound = bound_of_hinge(metric, each.hinge, evidence);
    if (!each.cut.empty()) bound = bound_of_cut(metric, each.cut, evidence);
    if (bound) each.bound = *bound + rounding_bound;
  }
}

}  // namespace

Examination assess_fully(const scenarios::Scenario& scenario, simulator::Bones bones,
                         const simulator::Recorded& recorded, std::string_view device_class,
                         const Progress& progress) {
  const simulator::Recording& recording = recorded.outputs;
  // The plan comes first: a scenario that does not fit the bone is refused before the long work.
  scenarios::Plan plan = plan_on(scenario, bones);
  FollowedEffects effects(bones, scenario.saw, plan);
  RebuiltBone rebuilt = rebuild_and_follow(effects, scenario, plan, bones, recording,
                                           part_of(progress, 0.0, rebuilt_share));
  Examination examination{std::move(plan), std::move(rebuilt), {}, {}, {}};
  find_faces(examination, scenario, recording);
  const Evidence evidence{scenario, examination.plan, examination.rebuilt, examination.faces,
                          bones,    recording,        recorded.tape};
  measure_all(examination, evidence, effects, part_of(progress, rebuilt_share, 1.0));
  examination.card =
      score_measurements(scenario, examination.measurements, device_class, recording.engine);
  return examination;
}

Examination examine_measured(const scenarios::Scenario& scenario, simulator::Bones bones,
                             const simulator::Recording& recording, std::string_view device_class,
                             Measured measured, const Progress& progress) {
  scenarios::Plan plan = plan_on(scenario, bones);
  RebuiltBone rebuilt = rebuild(bones, scenarios::tray_of(scenario), recording, progress,
                                &measured.opened, {}, hinges_of(plan));
  Examination examination{std::move(plan), std::move(rebuilt), {}, {}, {}};
  find_faces(examination, scenario, recording);
  examination.measurements = std::move(measured.measurements);
  examination.card =
      score_measurements(scenario, examination.measurements, device_class, recording.engine);
  return examination;
}

void say_in_first(std::vector<Measurement>& all, const Evidence& evidence) {
  if (evidence.bones.size() == 1) return;
  for (Measurement& each : all) {
    const std::size_t bone = bone_of(each, evidence.plan);
    each.place_in_bone_mm =
        transform_point(first_from(evidence.bones, bone), each.place_in_bone_mm);
  }
}

std::vector<Measurement> measure_geometry(const Evidence& evidence, const BoneSurfaces& surfaces) {
  std::vector<Measurement> all;
  for (std::size_t cut = 0; cut < evidence.plan.cuts.size(); ++cut)
    add(all, measure_cut(cut, evidence));
  for (const scenarios::PlannedHinge& hinge : evidence.plan.hinges)
    add(all, measure_hinge(hinge, evidence, all));
  add(all, measure_pieces(evidence, surfaces));
  all.push_back(joint_margin_measurement(evidence));
  bound_geometry(all, evidence);
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
  add_facts(card, scored, measurements);
  say(card);
  return card;
}

}  // namespace hallux::assessment

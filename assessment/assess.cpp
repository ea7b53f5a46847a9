#include "assessment/assess.h"

#include <iterator>
#include <utility>

#include "assessment/ledger.h"
#include "assessment/measure_cut.h"
#include "assessment/measure_deed.h"
#include "assessment/measure_hinge.h"
#include "assessment/sentences.h"

namespace hallux::assessment {

namespace {

/// Of the whole work; the rest is whether pieces are out.
constexpr double rebuilt_share = 0.9;

}  // namespace

Examination assess_fully(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                         const simulator::Recording& recording, const Progress& progress,
                         const OpenedFields* opened) {
  // The plan comes first: a scenario that does not fit the bone is refused before the long work.
  scenarios::Plan plan = plan_on(scenario, bone);
  Examination examination{
      std::move(plan),
      rebuild(bone, scenario.saw.blade, recording, part_of(progress, 0.0, rebuilt_share), opened),
      {},
      {},
      {}};
  for (std::size_t cut = 0; cut < examination.plan.cuts.size(); ++cut) {
    examination.faces.push_back(faces_of_cut(examination.rebuilt, examination.plan, cut));
    std::vector<Measurement> made = measure_cut(
        examination.plan.cuts[cut], examination.faces.back(), examination.rebuilt, bone, recording);
    std::move(made.begin(), made.end(), std::back_inserter(examination.measurements));
  }
  const HingeEvidence evidence{examination.plan, examination.rebuilt, examination.faces, bone,
                               recording};
  for (const scenarios::PlannedHinge& hinge : examination.plan.hinges) {
    std::vector<Measurement> made = measure_hinge(hinge, evidence, examination.measurements);
    std::move(made.begin(), made.end(), std::back_inserter(examination.measurements));
  }
  std::vector<Measurement> deeds = measure_deeds(
      scenario, {examination.plan, examination.rebuilt, examination.faces, bone, recording},
      part_of(progress, rebuilt_share, 1.0));
  std::move(deeds.begin(), deeds.end(), std::back_inserter(examination.measurements));
  database::ScoreCard& card = examination.card;
  card = score_rubric(scenario.rubric, examination.measurements);
  card.scenario = scenario.name;
  card.scenario_version = scenario.version;
  card.engine = recording.engine;
  card.is_reviewed = scenario.is_reviewed;
  explain(card, scenario, examination.measurements);
  return examination;
}

database::ScoreCard assess(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                           const simulator::Recording& recording, const Progress& progress) {
  return assess_fully(scenario, bone, recording, progress).card;
}

}  // namespace hallux::assessment

/// A face's turns and its offset are said against the plan: the planned face is turned so that the
/// axis in it rises out of it (roll), then about the axis as it was (tilt), and shifted along its
/// normal, all at the middle of the face. A stop shifts a kerf in its own plane, from where that
/// took it: the blade reached from outside, so that what it opened moves as a whole.
#include "assessment/what_if.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "assessment/ledger.h"
#include "assessment/measure_hinge.h"
#include "assessment/number_text.h"
#include "assessment/rebuild/bodies.h"
#include "assessment/rebuild/moved_kerf.h"
#include "scenarios/metric_names.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::MetricName;
using scenarios::MetricSubject;
using scenarios::PlannedCut;
using scenarios::PlannedHinge;
using scenarios::RubricItem;

constexpr std::size_t proposals_most = 3;

std::string named(std::string_view kind, const std::string& subject) {
  return subject.empty() ? std::string(kind) : std::string(kind) + ":" + subject;
}

Vec3 middle_of(const CutFace& face) {
  Vec3 sum{0.0, 0.0, 0.0};
  for (const Vec3& sample_mm : face.samples_in_bone_mm) sum += sample_mm;
  return sum / static_cast<double>(face.samples_in_bone_mm.size());
}

/// How a face lies against its plan.
struct FacePose {
  double tilt_rad = 0.0, roll_rad = 0.0, offset_mm = 0.0;
  Vec3 middle_in_bone_mm{0.0, 0.0, 0.0};
};

FacePose pose_of(const CutFace& face, const PlannedCut& cut) {
  const Vec3& normal = cut.face.normal;
  FacePose pose;
  pose.middle_in_bone_mm = middle_of(face);
  const double along = glm::dot(face.plane.normal, normal);
  const double across = glm::dot(face.plane.normal, glm::cross(cut.contained_in_bone, normal));
  pose.tilt_rad = std::atan2(across, along);
  pose.roll_rad =
      std::atan2(glm::dot(face.plane.normal, cut.contained_in_bone), std::hypot(along, across));
  pose.offset_mm = distance_along_mm(face.plane, pose.middle_in_bone_mm, normal) +
                   glm::dot(normal, pose.middle_in_bone_mm) - cut.face.offset_mm;
  return pose;
}

RigidTransform shift_by(const Vec3& way_mm) { return {Quat{1.0, 0.0, 0.0, 0.0}, way_mm}; }

/// What a metric of the work is called as a change: its id, and what it is about.
std::string change_of(const Measurement& measurement) {
  for (const std::string* subject :
       {&measurement.zone, &measurement.fragment, &measurement.implant, &measurement.cut}) {
    if (!subject->empty()) return named(measurement.metric, *subject);
  }
  return named(measurement.metric, "");
}

/// Those whose value a change replaces: no face and no piece tells them.
bool is_of_work(const MetricName& metric, const Measurement& measurement) noexcept {
  if (metric.metric == Metric::JointMarginMm) return false;
  if (metric.subject == MetricSubject::Attempt || metric.subject == MetricSubject::Zone)
    return true;
  if (!measurement.fragment.empty() || !measurement.implant.empty()) return true;
  return metric.metric == Metric::PlungeMm || metric.metric == Metric::BreakthroughNewton ||
         metric.metric == Metric::BreakthroughMmS || metric.metric == Metric::RightTool ||
         (metric.metric == Metric::OverCutMm && measurement.hinge.empty());
}

/// The value nearest to what was that earns all of the points.
double full_value(const RubricItem& item, double value) noexcept {
  if (!item.is_band) return item.full;
  return std::clamp(value, item.full_low, item.full_high);
}

/// Puts what was measured again in the place of what was.
void replace_in(std::vector<Measurement>& all, const std::vector<Measurement>& made) {
  for (const Measurement& each : made) {
    const auto old = std::find_if(all.begin(), all.end(),
                                  [&](const Measurement& one) { return is_of_same(one, each); });
    if (old == all.end()) continue;
    const double done_fraction = old->done_fraction;
    const Remark remark = old->remark;
    *old = each;
    old->done_fraction = done_fraction;
    old->remark = remark;
  }
}

std::int64_t lost_milli(const database::ScoreCard& card, const std::string& item) {
  for (const database::LedgerLine& line : card.ledger) {
    if (line.kind == database::LedgerKind::Metric && line.item == item)
      return line.points_lost_milli;
  }
  return 0;
}

std::vector<std::string> lifted_gates(const database::ScoreCard& before,
                                      const database::ScoreCard& after) {
  std::vector<std::string> lifted;
  for (const database::GateResult& was : before.gates) {
    const auto now = std::ranges::find(after.gates, was.name, &database::GateResult::name);
    if (was.is_triggered && now != after.gates.end() && !now->is_triggered)
      lifted.push_back(was.name);
  }
  return lifted;
}

/// Towards the plan: the bridge that was planned, or no deviation.
double planned_value(const KnownChange& change, const scenarios::Plan& plan) {
  for (const PlannedHinge& hinge : plan.hinges) {
    if (change.name == named("stop", hinge.name)) return hinge.bridge.line.thickness_mm;
  }
  return 0.0;
}

}  // namespace

WhatIf::WhatIf(const scenarios::Scenario& scenario, simulator::Bones bones,
               const simulator::Recording& recording, std::string_view device_class,
               Examination examination)
    : scenario_(scenario),
      bones_(bones),
      recording_(recording),
      device_class_(device_class),
      examination_(std::move(examination)),
      fields_(kept_fields(examination_.rebuilt.fields)),
      surfaces_(bones) {
  for (std::size_t cut = 0; cut < examination_.plan.cuts.size(); ++cut) know_cut(cut);
  for (const PlannedHinge& hinge : examination_.plan.hinges) know_hinge(hinge);
  know_metrics();
}

Evidence WhatIf::evidence() const noexcept {
  return {scenario_, examination_.plan, examination_.rebuilt, examination_.faces,
          bones_,    recording_};
}

void WhatIf::know_cut(std::size_t cut) {
  const PlannedCut& planned = examination_.plan.cuts[cut];
  const CutFace* face = counting_face(evidence(), planned.name);
  if (face == nullptr) return;
  const FacePose pose = pose_of(*face, planned);
  known_.push_back(
      {named("tilt", planned.name), "deg", rounded_to_micro(degree_from_radian(pose.tilt_rad))});
  known_.push_back(
      {named("roll", planned.name), "deg", rounded_to_micro(degree_from_radian(pose.roll_rad))});
  known_.push_back({named("offset", planned.name), "mm", rounded_to_micro(pose.offset_mm)});
}

void WhatIf::know_hinge(const PlannedHinge& hinge) {
  const std::vector<KerfBridge> bridges = bridges_left(hinge, evidence());
  if (bridges.empty()) return;
  const auto least = std::ranges::min_element(bridges, {}, &KerfBridge::left_mm);
  known_.push_back({named("stop", hinge.name), "mm", rounded_to_micro(least->left_mm)});
}

void WhatIf::know_metrics() {
  for (const Measurement& each : examination_.measurements) {
    const MetricName* metric = scenarios::find_metric(each.metric);
    if (metric == nullptr || !is_of_work(*metric, each) || !each.is_measured()) continue;
    known_.push_back({change_of(each), std::string(metric->unit), each.value, true});
  }
}

const KnownChange& WhatIf::find(const std::string& name) const {
  const auto found = std::ranges::find(known_, name, &KnownChange::name);
  if (found != known_.end()) return *found;
  std::string names;
  for (const KnownChange& each : known_) names += (names.empty() ? "" : ", ") + each.name;
  throw scenarios::ScenarioError("there is no change \"" + name +
                                 "\" of this attempt; use one of: " + names);
}

bool WhatIf::moves(const std::vector<Change>& changes) const {
  return std::ranges::any_of(changes,
                             [&](const Change& change) { return !find(change.name).is_replaced; });
}

namespace {

/// By how much a change asks for more than there was, where it is asked for.
std::optional<double> asked(const std::vector<Change>& changes,
                            const std::vector<KnownChange>& known, const std::string& name) {
  const auto change = std::ranges::find(changes, name, &Change::name);
  if (change == changes.end()) return std::nullopt;
  return change->to - std::ranges::find(known, name, &KnownChange::name)->from;
}

/// Rolled where the face has no tilt, so that each of the two turns changes itself alone; all about
/// the middle of the face, and the shift last.
RigidTransform move_of_cut(const std::vector<Change>& changes,
                           const std::vector<KnownChange>& known, const PlannedCut& cut,
                           const CutFace& face) {
  const FacePose pose = pose_of(face, cut);
  const auto more_deg = [&](const char* kind) {
    return asked(changes, known, named(kind, cut.name));
  };
  const auto turn = [&](const Vec3& axis, double angle_rad) {
    return turn_about(pose.middle_in_bone_mm, axis, angle_rad);
  };
  const auto tilt_deg = more_deg("tilt"), roll_deg = more_deg("roll");
  RigidTransform move;
  if (tilt_deg || roll_deg) {
    const double to_rad = pose.tilt_rad + radian_from_degree(tilt_deg.value_or(0.0));
    const Vec3 roll_axis = glm::cross(cut.face.normal, cut.contained_in_bone);
    move = turn(cut.contained_in_bone, to_rad) *
           turn(roll_axis, radian_from_degree(roll_deg.value_or(0.0))) *
           turn(cut.contained_in_bone, -pose.tilt_rad);
  }
  if (const auto more_mm = asked(changes, known, named("offset", cut.name)))
    move = shift_by(*more_mm * cut.face.normal) * move;
  return move;
}

/// The way in its own plane that lets the kerf end elsewhere.
Vec3 stop_shift(const simulator::KerfPlane& plane, const Vec3& outward, double more_mm) {
  const Vec3 normal = axis_z(plane.bone_from_kerf);
  const Vec3 along = outward - glm::dot(outward, normal) * normal;
  const double size = length_of(along);
  return (-more_mm / (size * size)) * along;
}

/// The attempt with some of its kerfs elsewhere.
struct MovedAttempt {
  simulator::Recording recording;
  OpenedFields fields;
  std::optional<RebuiltBone> rebuilt;
  std::vector<std::vector<CutFace>> faces;
};

/// The bone as the kerfs lie now; each face counts as it did before, and is as finished.
void rebuild_moved(MovedAttempt& moved, const Evidence& before) {
  moved.rebuilt.emplace(rebuild(before.bones, scenarios::tray_of(before.scenario), moved.recording,
                                {}, &moved.fields, {}, hinges_of(before.plan)));
  moved.faces.assign(before.faces.size(), {});
  for (std::size_t cut = 0; cut < before.faces.size(); ++cut) {
    for (const CutFace& was : before.faces[cut]) {
      CutFace face = face_of_kerf(*moved.rebuilt, was.kerf, before.plan, cut);
      face.done_fraction = was.done_fraction;
      face.is_finished = was.is_finished;
      moved.faces[cut].push_back(std::move(face));
    }
  }
}

/// Whether a kerf lies in another plane now: else the bone is as it was, to the bit.
bool has_moved(const OpenedFields& fields, const OpenedFields& before) {
  const auto is_same = [](const simulator::OpenedField& a, const simulator::OpenedField& b) {
    return a.plane.bone_from_kerf.rotation == b.plane.bone_from_kerf.rotation &&
           a.plane.bone_from_kerf.translation_mm == b.plane.bone_from_kerf.translation_mm;
  };
  return !std::ranges::equal(fields, before, is_same);
}

Evidence evidence_of(const MovedAttempt& moved, const Evidence& before) {
  return {before.scenario, before.plan, *moved.rebuilt, moved.faces, before.bones, moved.recording};
}

}  // namespace

std::vector<Measurement> WhatIf::measured_again(const std::vector<Change>& changes) const {
  const Evidence before = evidence();
  MovedAttempt moved{
      {recording_.engine, {}, recording_.samples, recording_.events}, fields_, {}, {}};
  const auto move = [&](std::int32_t kerf, const RigidTransform& bone_from_moved) {
    move_kerf(moved.recording, moved.fields,
              bones_[bone_of(examination_.rebuilt, kerf)].world_from_bone, {kerf, bone_from_moved});
  };
  for (const PlannedCut& cut : examination_.plan.cuts) {
    const CutFace* face = counting_face(before, cut.name);
    if (face != nullptr) move(face->kerf, move_of_cut(changes, known_, cut, *face));
  }
  if (has_moved(moved.fields, fields_)) rebuild_moved(moved, before);
  for (const PlannedHinge& hinge : examination_.plan.hinges) {
    const auto stop = std::ranges::find(changes, named("stop", hinge.name), &Change::name);
    if (stop == changes.end()) continue;
    // Of the bridge that the kerfs leave where they were turned and shifted to.
    const Evidence turned = moved.rebuilt ? evidence_of(moved, before) : before;
    for (const KerfBridge& bridge : bridges_left(hinge, turned)) {
      const simulator::KerfPlane& plane = turned.rebuilt.fields.plane(bridge.kerf);
      move(bridge.kerf,
           shift_by(stop_shift(plane, hinge.bridge.line.outward, stop->to - bridge.left_mm)));
    }
    rebuild_moved(moved, before);
  }
  if (!moved.rebuilt) rebuild_moved(moved, before);
  const Evidence after = evidence_of(moved, before);
  std::vector<Measurement> made = measure_geometry(after, surfaces_);
  say_in_first(made, after);
  return made;
}

WhatIfOutcome WhatIf::with(const std::vector<Change>& changes) const {
  // What is unknown is refused before the long work.
  for (const Change& change : changes) find(change.name);
  WhatIfOutcome outcome;
  outcome.measurements = examination_.measurements;
  if (moves(changes)) replace_in(outcome.measurements, measured_again(changes));
  for (const Change& change : changes) {
    if (!find(change.name).is_replaced) continue;
    for (Measurement& each : outcome.measurements) {
      if (change_of(each) != change.name || !each.is_measured()) continue;
      each.value = rounded_to_micro(change.to);
      each.remark = Remark::Assumed;
    }
  }
  outcome.card =
      score_measurements(scenario_, outcome.measurements, device_class_, recording_.engine);
  return outcome;
}

std::vector<Change> WhatIf::candidates() const {
  std::vector<Change> changes;
  const scenarios::Rubric rubric = rubric_for(scenario_.rubric, device_class_);
  for (const KnownChange& known : known_) {
    if (!known.is_replaced) {
      changes.push_back({known.name, planned_value(known, examination_.plan)});
      continue;
    }
    for (const RubricItem& item : rubric.items) {
      const Measurement* measurement = find_measurement(examination_.measurements, item);
      if (measurement == nullptr || change_of(*measurement) != known.name) continue;
      if (lost_milli(examination_.card, item.id) > 0)
        changes.push_back({known.name, full_value(item, known.from)});
    }
  }
  return changes;
}

Proposals WhatIf::propose(const Progress& progress) const {
  Proposals proposals;
  const std::vector<Change> all = candidates();
  for (std::size_t index = 0; index < all.size(); ++index) {
    report(progress, static_cast<double>(index) / static_cast<double>(all.size()));
    const database::ScoreCard card = with({all[index]}).card;
    const std::int64_t gain_milli = card.score_milli - examination_.card.score_milli;
    if (gain_milli <= 0) continue;
    ProposedChange proposed{find(all[index].name),
                            all[index].to,
                            gain_milli,
                            {},
                            lifted_gates(examination_.card, card)};
    for (const RubricItem& item : scenario_.rubric.items) {
      if (lost_milli(card, item.id) < lost_milli(examination_.card, item.id))
        proposed.items.push_back(item.id);
    }
    proposals.changes.push_back(std::move(proposed));
  }
  std::ranges::stable_sort(proposals.changes, std::ranges::greater{}, &ProposedChange::gain_milli);
  if (proposals.changes.size() > proposals_most) proposals.changes.resize(proposals_most);
  std::vector<Change> together;
  for (const ProposedChange& each : proposals.changes)
    together.push_back({each.change.name, each.to});
  proposals.score_milli = with(together).card.score_milli;
  proposals.gain_milli = proposals.score_milli - examination_.card.score_milli;
  report(progress, 1.0);
  return proposals;
}

}  // namespace hallux::assessment

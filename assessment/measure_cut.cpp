/// The first of the cut's faces is the one that is judged; all of them can have done harm at the
/// two landmarks. Each metric is a value, a moment and a place, so that the replay can be led
/// there. A cut that was never made has all its metrics, none of them measured: the rubric then
/// knows what was lost.
#include "assessment/measure_cut.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "assessment/blade_track.h"
#include "assessment/make_measurement.h"
#include "assessment/metrics/blade_flatness.h"
#include "assessment/metrics/face_metrics.h"
#include "assessment/metrics/resection.h"
#include "assessment/number_text.h"
#include "assessment/process/break_throughs.h"
#include "assessment/process/over_cut.h"
#include "assessment/process/tools_used.h"
#include "assessment/rebuild/overhang.h"
#include "scenarios/metric_names.h"
#include "scenarios/site/bone_words.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::PlannedCut;

/// A cut along the bone is planned from landmarks of depth and exit; one across it is not.
bool is_metric_of(const scenarios::MetricName& metric, const PlannedCut& planned) noexcept {
  using scenarios::MetricSubject;
  if (metric.subject == MetricSubject::CutAlong) return planned.is_along_bone;
  if (metric.subject == MetricSubject::CutAcross) return !planned.is_along_bone;
  // Of a cut that stops at a hinge it is the hinge's.
  if (metric.metric == Metric::OverCutMm) return planned.hinge.empty();
  return metric.subject == MetricSubject::Cut || metric.subject == MetricSubject::CutOrHinge ||
         metric.subject == MetricSubject::CutOrImplant;
}

Measurement measurement(const PlannedCut& planned, Metric metric, double value,
                        const Moment& moment, const Vec3& place_in_bone_mm) {
  Measurement made = measured(metric, value, moment, place_in_bone_mm);
  made.cut = planned.name;
  return made;
}

Measurement absent_of(const PlannedCut& planned, Metric metric, Absence why) {
  Measurement made = absent(metric, why, planned.depth_point_in_bone_mm);
  made.cut = planned.name;
  return made;
}

std::vector<Measurement> nothing_measured(const PlannedCut& planned) {
  std::vector<Measurement> measurements;
  for (const scenarios::MetricName& metric : scenarios::known_metrics()) {
    if (!is_metric_of(metric, planned)) continue;
    measurements.push_back(absent_of(planned, metric.metric, Absence::NotMade));
  }
  return measurements;
}

/// Only where the blade was can it have gone too far; a finished face reaches through the bone.
bool reaches(const CutFace& face, const RebuiltBone& rebuilt, const Vec3& point_in_bone_mm) {
  if (face.is_finished && !face.samples_in_bone_mm.empty()) return true;
  return is_opened_at(face, rebuilt, point_in_bone_mm);
}

/// The deepest that any face went at the two landmarks.
struct Harm {
  double past_landmark_mm = 0.0, notch_mm = 0.0;
  std::int32_t past_kerf = -1, notch_kerf = -1;
};

Harm worst_harm(const std::vector<CutFace>& faces, const RebuiltBone& rebuilt,
                const ResectionPlan& plan) {
  Harm harm;
  for (const CutFace& face : faces) {
    const ResectionMetrics metrics = measure_resection(face.plane, plan);
    const bool is_past = reaches(face, rebuilt, plan.depth_point_in_bone_mm);
    const bool is_at_exit = reaches(face, rebuilt, plan.exit_point_in_bone_mm);
    if (is_past && metrics.past_landmark_mm > harm.past_landmark_mm) {
      harm.past_landmark_mm = metrics.past_landmark_mm;
      harm.past_kerf = face.kerf;
    }
    if (is_at_exit && metrics.notch_mm > harm.notch_mm) {
      harm.notch_mm = metrics.notch_mm;
      harm.notch_kerf = face.kerf;
    }
  }
  return harm;
}

/// Which way an error along the planned normal goes, in the words of the bone.
std::string error_direction_text(double error_mm, const Vec3& to_waste) {
  return scenarios::direction_text(error_mm * to_waste);
}

Moment cutting_moment(const RebuiltBone& rebuilt, std::int32_t kerf) {
  const RebuiltKerf& made = rebuilt.kerfs[static_cast<std::size_t>(kerf)];
  return {made.first_cutting_tick, made.last_cutting_tick};
}

void add_harm(std::vector<Measurement>& measurements, const PlannedCut& planned, const Harm& harm,
              const RebuiltBone& rebuilt, std::int32_t kerf) {
  const auto moment_of = [&](std::int32_t worst) {
    return cutting_moment(rebuilt, worst < 0 ? kerf : worst);
  };
  measurements.push_back(measurement(planned, Metric::PastLandmarkMm, harm.past_landmark_mm,
                                     moment_of(harm.past_kerf), planned.depth_point_in_bone_mm));
  measurements.push_back(measurement(planned, Metric::NotchMm, harm.notch_mm,
                                     moment_of(harm.notch_kerf), planned.exit_point_in_bone_mm));
}

void add_flatness(std::vector<Measurement>& measurements, const PlannedCut& planned,
                  const std::optional<Flatness>& flatness) {
  if (!flatness) {
    measurements.push_back(absent_of(planned, Metric::FlatnessMm, Absence::NotMade));
    return;
  }
  measurements.push_back(measurement(planned, Metric::FlatnessMm, flatness->flatness_mm,
                                     {flatness->tick, flatness->tick}, flatness->point_in_bone_mm));
  measurements.back().bound += flatness->bound_mm;
}

/// How far the face lies beyond the plan where it is deepest, and where it is shallowest, and which
/// way on the bone.
Detail edges_of(const CutFace& face, const FacePlane& planned) {
  const Vec3 deepest = deepest_direction(face.plane, planned);
  const auto [shallow, deep] = std::minmax_element(
      face.samples_in_bone_mm.begin(), face.samples_in_bone_mm.end(),
      [&](const Vec3& a, const Vec3& b) { return glm::dot(a, deepest) < glm::dot(b, deepest); });
  Detail edges{DetailKind::EdgesOff, {}, {}};
  for (const Vec3& edge_mm : {*deep, *shallow}) {
    const double off_mm = signed_distance_mm(planned, edge_mm);
    edges.values.push_back(rounded_to_micro(std::abs(off_mm)));
    edges.words.push_back(error_direction_text(off_mm, planned.normal));
  }
  return edges;
}

/// Turned in one plane of the bone, with the edge that lies further distal.
Measurement tilt(const PlannedCut& planned, Metric metric, double tilt_deg, const Moment& moment,
                 const char* positive_edge, const char* negative_edge) {
  Measurement made = measurement(planned, metric, tilt_deg, moment, planned.entry_point_in_bone_mm);
  made.direction = tilt_deg >= 0.0 ? positive_edge : negative_edge;
  return made;
}

/// Where a face begins or ends: along the bone's x where it lies across the bone, else towards the
/// waste.
Measurement offset(const PlannedCut& planned, Metric metric, double offset_mm, const Vec3& towards,
                   const Moment& moment, const Vec3& place_in_bone_mm) {
  Measurement made = measurement(planned, metric, offset_mm, moment, place_in_bone_mm);
  made.direction = error_direction_text(offset_mm, towards);
  return made;
}

/// angle_deg, the tilts, location_mm, mean_mm, rms_mm, entry_mm and exit_mm.
void add_face(std::vector<Measurement>& made, const PlannedCut& planned, const CutFace& face,
              const RebuiltBone& rebuilt) {
  const FacePlane plan{planned.face.normal, planned.face.offset_mm};
  const Vec3 towards = planned.is_along_bone ? plan.normal : Vec3{1.0, 0.0, 0.0};
  const FaceMetrics metrics =
      measure_face(face.samples_in_bone_mm, face.plane, plan,
                   {planned.entry_point_in_bone_mm, planned.exit_point_in_bone_mm, towards});
  const std::int64_t frozen_tick = rebuilt.kerfs[static_cast<std::size_t>(face.kerf)].frozen_tick;
  const Moment frozen{frozen_tick, frozen_tick};
  const Moment cutting = cutting_moment(rebuilt, face.kerf);
  made.push_back(measurement(planned, Metric::AngleDeg, metrics.angle_deg, frozen,
                             metrics.worst_point_in_bone_mm));
  made.back().direction = scenarios::direction_text(deepest_direction(face.plane, plan));
  if (!planned.is_along_bone) {
    made.back().detail = edges_of(face, plan);
    made.push_back(tilt(planned, Metric::TransverseTiltDeg, metrics.transverse_deg, frozen,
                        "medial", "lateral"));
    made.push_back(
        tilt(planned, Metric::SagittalTiltDeg, metrics.sagittal_deg, frozen, "plantar", "dorsal"));
  }
  made.push_back(measurement(planned, Metric::LocationMm, metrics.location_mm, cutting,
                             metrics.worst_point_in_bone_mm));
  made.back().direction = error_direction_text(metrics.worst_mm, plan.normal);
  for (const auto& [metric, value] :
       {std::pair{Metric::MeanMm, metrics.mean_mm}, std::pair{Metric::RmsMm, metrics.rms_mm}})
    made.push_back(measurement(planned, metric, value, cutting, metrics.worst_point_in_bone_mm));
  made.push_back(offset(planned, Metric::EntryMm, metrics.entry_mm, towards, frozen,
                        planned.entry_point_in_bone_mm));
  // A face across the bone without a hinge runs out all around it.
  if (!planned.is_along_bone && planned.hinge.empty()) {
    made.push_back(absent_of(planned, Metric::ExitMm, Absence::Undefined));
    return;
  }
  made.push_back(offset(planned, Metric::ExitMm, metrics.exit_mm, towards, cutting,
                        planned.exit_point_in_bone_mm));
}

/// The other kerfs whose wall stands on bone more than this from the face that counts.
constexpr double ledge_mm = 0.5;

/// ledges_count.
void add_ledges(std::vector<Measurement>& made, const PlannedCut& planned,
                const std::vector<CutFace>& faces, const RebuiltBone& rebuilt) {
  const CutFace& main = faces.front();
  Measurement ledges =
      measurement(planned, Metric::LedgesCount, 0.0, cutting_moment(rebuilt, main.kerf),
                  planned.depth_point_in_bone_mm);
  for (const CutFace& other : faces) {
    if (other.kerf == main.kerf || !other.is_wall || other.samples_in_bone_mm.empty()) continue;
    double sum_mm = 0.0;
    for (const Vec3& sample : other.samples_in_bone_mm)
      sum_mm += std::abs(signed_distance_mm(main.plane, sample));
    if (sum_mm <= ledge_mm * static_cast<double>(other.samples_in_bone_mm.size())) continue;
    ledges.value += 1.0;
    ledges.place_in_bone_mm = other.samples_in_bone_mm.front();
  }
  made.push_back(std::move(ledges));
}

/// The angle between two planes, of the two that they make the one nearer to the planned one.
double included_deg(const Vec3& one, const Vec3& other, double planned_deg) {
  const double sharp_deg =
      degree_from_radian(std::acos(std::min(1.0, std::abs(glm::dot(one, other)))));
  const double blunt_deg = 180.0 - sharp_deg;
  const bool is_sharp = std::abs(sharp_deg - planned_deg) <= std::abs(blunt_deg - planned_deg);
  return is_sharp ? sharp_deg : blunt_deg;
}

/// common_axis_deg, and included_angle_deg where another cut shares the axis and was made.
void add_axis(std::vector<Measurement>& made, const PlannedCut& planned, const CutFace& face,
              const Evidence& evidence) {
  const Moment cutting = cutting_moment(evidence.rebuilt, face.kerf);
  const double leaves_rad =
      std::asin(std::min(1.0, std::abs(glm::dot(face.plane.normal, planned.contained_in_bone))));
  made.push_back(measurement(planned, Metric::CommonAxisDeg, degree_from_radian(leaves_rad),
                             cutting, planned.exit_point_in_bone_mm));
  const PlannedCut* const partner = partner_of(planned, evidence.plan);
  const CutFace* const other =
      partner == nullptr ? nullptr : counting_face(evidence, partner->name);
  if (other == nullptr) {
    made.push_back(absent_of(planned, Metric::IncludedAngleDeg,
                             partner == nullptr ? Absence::Undefined : Absence::NotMade));
    return;
  }
  const double planned_deg = included_deg(planned.face.normal, partner->face.normal, 0.0);
  made.push_back(measurement(planned, Metric::IncludedAngleDeg,
                             included_deg(face.plane.normal, other->plane.normal, planned_deg),
                             cutting, planned.entry_point_in_bone_mm));
}

/// over_cut_mm of a cut that stops at no hinge.
void add_over_cut(std::vector<Measurement>& made, const PlannedCut& planned, const CutFace& face,
                  std::span<const std::int32_t> kerfs, const Evidence& evidence) {
  if (!planned.hinge.empty()) return;
  const OverCut over =
      measure_over_cut(evidence.recording, evidence.rebuilt, evidence.bones, kerfs, planned);
  const bool is_over = over.over_mm > 0.0;
  made.push_back(measurement(planned, Metric::OverCutMm, over.over_mm,
                             is_over ? Moment{over.first_tick, over.deepest_tick}
                                     : cutting_moment(evidence.rebuilt, face.kerf),
                             is_over ? over.place_in_bone_mm : planned.exit_point_in_bone_mm));
  made.back().bound += over.bound_mm;
}

void add_right_tool(std::vector<Measurement>& made, const PlannedCut& planned, const CutFace& face,
                    std::span<const std::int32_t> kerfs, const Evidence& evidence) {
  Moment moment = cutting_moment(evidence.rebuilt, face.kerf);
  bool is_right = true;
  if (planned.blade) {
    const auto tick = first_cut_with_another(evidence.recording, kerfs,
                                             static_cast<std::int32_t>(*planned.blade));
    is_right = !tick.has_value();
    if (tick) moment = {*tick, *tick};
  }
  made.push_back(measurement(planned, Metric::RightTool, is_right ? 1.0 : 0.0, moment,
                             planned.entry_point_in_bone_mm));
}

/// plunge_mm, breakthrough_newton and breakthrough_mm_s, of all the cut's kerfs.
void add_break_throughs(std::vector<Measurement>& made, const PlannedCut& planned,
                        const std::vector<CutFace>& faces, std::span<const std::int32_t> kerfs,
                        const RebuiltBone& rebuilt, const BreakThroughWorld& world) {
  const BreakThroughs worst = measure_break_throughs(world, kerfs);
  const Moment plunge = worst.plunge_mm.value > 0.0
                            ? Moment{worst.plunge_mm.first_tick, worst.plunge_mm.last_tick}
                            : cutting_moment(rebuilt, faces.front().kerf);
  const Vec3 place_mm =
      worst.plunge_mm.value > 0.0 ? worst.plunge_in_bone_mm : planned.exit_point_in_bone_mm;
  made.push_back(measurement(planned, Metric::PlungeMm, worst.plunge_mm.value, plunge, place_mm));
  made.back().bound += worst.plunge_mm.bound;
  const auto add = [&](Metric metric, const std::optional<Finding>& finding) {
    if (!finding) {
      made.push_back(absent_of(planned, metric, Absence::Undefined));
      return;
    }
    made.push_back(measurement(planned, metric, finding->value,
                               {finding->first_tick, finding->last_tick}, place_mm));
    made.back().bound += finding->bound;
  };
  add(Metric::BreakthroughNewton, worst.force_newton);
  add(Metric::BreakthroughMmS, worst.speed_mm_s);
}

/// overhang_mm.
void add_overhang(std::vector<Measurement>& made, const PlannedCut& planned, const CutFace& face,
                  const RebuiltBone& rebuilt) {
  const Overhang overhang = measure_overhang(rebuilt, planned);
  made.push_back(measurement(
      planned, Metric::OverhangMm, overhang.over_mm, cutting_moment(rebuilt, face.kerf),
      overhang.over_mm > 0.0 ? overhang.place_in_bone_mm : planned.depth_point_in_bone_mm));
}

/// depth_mm and step_mm.
void add_resection(std::vector<Measurement>& made, const PlannedCut& planned,
                   const ResectionPlan& plan, const CutFace& face, const RebuiltBone& rebuilt) {
  const ResectionMetrics resection = measure_resection(face.plane, plan);
  const Moment cutting = cutting_moment(rebuilt, face.kerf);
  made.push_back(measurement(planned, Metric::DepthMm, std::abs(resection.depth_error_mm), cutting,
                             plan.depth_point_in_bone_mm));
  made.back().direction = error_direction_text(resection.depth_error_mm, plan.face.normal);
  made.push_back(measurement(planned, Metric::StepMm, std::abs(resection.step_error_mm), cutting,
                             plan.exit_point_in_bone_mm));
  made.back().direction = error_direction_text(resection.step_error_mm, plan.face.normal);
}

}  // namespace

std::vector<Measurement> measure_cut(std::size_t cut, const Evidence& evidence) {
  const PlannedCut& planned = evidence.plan.cuts[cut];
  const std::vector<CutFace>& faces = evidence.faces[cut];
  const RebuiltBone& rebuilt = evidence.rebuilt;
  if (faces.empty() || faces.front().samples_in_bone_mm.empty()) return nothing_measured(planned);
  const CutFace& face = faces.front();
  const ResectionPlan plan{{planned.face.normal, planned.face.offset_mm},
                           planned.depth_point_in_bone_mm,
                           planned.exit_point_in_bone_mm};
  std::vector<std::int32_t> kerfs;
  kerfs.reserve(faces.size());
  for (const CutFace& each : faces) kerfs.push_back(each.kerf);
  std::vector<Measurement> made;
  add_face(made, planned, face, rebuilt);
  add_axis(made, planned, face, evidence);
  if (planned.is_along_bone) add_resection(made, planned, plan, face, rebuilt);
  add_flatness(made, planned,
               measure_flatness(
                   cutting_tooth_points(evidence.recording, rebuilt, evidence.bones, face.kerf)));
  add_ledges(made, planned, faces, rebuilt);
  if (planned.is_along_bone) {
    add_harm(made, planned, worst_harm(faces, rebuilt, plan), rebuilt, face.kerf);
    add_overhang(made, planned, face, rebuilt);
  }
  add_over_cut(made, planned, face, kerfs, evidence);
  add_right_tool(made, planned, face, kerfs, evidence);
  add_break_throughs(made, planned, faces, kerfs, rebuilt,
                     {evidence.recording, blade_of_kerf(evidence.recording, rebuilt, face.kerf),
                      inverse(evidence.bones[planned.bone].world_from_bone)});
  for (Measurement& each : made) each.done_fraction = face.done_fraction;
  return made;
}

}  // namespace hallux::assessment

/// The first of the cut's faces is the one that is judged; all of them can have done harm at the
/// two landmarks. Each metric is a value, a moment and a place, so that the replay can be led
/// there. A cut that was never made has all its metrics, none of them measured: the rubric then
/// knows what was lost.
#include "assessment/measure_cut.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "assessment/blade_track.h"
#include "assessment/metrics/blade_flatness.h"
#include "assessment/metrics/face_metrics.h"
#include "assessment/metrics/resection.h"
#include "assessment/number_text.h"
#include "scenarios/metric_names.h"
#include "scenarios/site/bone_words.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::PlannedCut;
using simulator::Recording;

/// A cut along the bone is planned from landmarks of depth and exit; one across it is not.
bool is_metric_of(const scenarios::MetricName& metric, const PlannedCut& planned) noexcept {
  using scenarios::MetricSubject;
  if (metric.subject == MetricSubject::CutAlong)
    return planned.kind == scenarios::FaceKind::AlongAxis;
  return metric.subject == MetricSubject::Cut || metric.subject == MetricSubject::CutOrHinge;
}

/// A span of ticks, both ends included.
struct Moment {
  std::int64_t first_tick = 0, last_tick = 0;
};

Measurement measurement(const PlannedCut& planned, Metric metric, double value,
                        const Moment& moment, const Vec3& place_in_bone_mm) {
  Measurement made;
  made.metric = name_of(metric);
  made.cut = planned.name;
  made.value = rounded_to_micro(value);
  made.start_us = time_us_from_tick(moment.first_tick);
  made.end_us = time_us_from_tick(moment.last_tick + 1);
  made.place_in_bone_mm = place_in_bone_mm;
  return made;
}

std::vector<Measurement> nothing_measured(const PlannedCut& planned) {
  std::vector<Measurement> measurements;
  for (const scenarios::MetricName& metric : scenarios::known_metrics()) {
    if (!is_metric_of(metric, planned)) continue;
    Measurement absent;
    absent.metric = metric.name;
    absent.cut = planned.name;
    absent.is_measured = false;
    absent.place_in_bone_mm = planned.depth_point_in_bone_mm;
    measurements.push_back(absent);
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
  const Flatness known = flatness.value_or(Flatness{});
  measurements.push_back(measurement(planned, Metric::FlatnessMm, known.flatness_mm,
                                     {known.tick, known.tick}, known.point_in_bone_mm));
  measurements.back().is_measured = flatness.has_value();
}

/// How far the face lies beyond the plan where it is deepest, and where it is shallowest, in the
/// words of the bone.
std::string edge_text(const CutFace& face, const FacePlane& planned) {
  const Vec3 deepest = deepest_direction(face.plane, planned);
  const auto [shallow, deep] = std::minmax_element(
      face.samples_in_bone_mm.begin(), face.samples_in_bone_mm.end(),
      [&](const Vec3& a, const Vec3& b) { return glm::dot(a, deepest) < glm::dot(b, deepest); });
  const auto said = [&](const Vec3& sample) {
    const double off_mm = signed_distance_mm(planned, sample);
    return value_text(std::abs(off_mm), "mm") + " too far " +
           error_direction_text(off_mm, planned.normal);
  };
  return "there " + said(*deep) + ", opposite " + said(*shallow);
}

/// angle_deg and location_mm.
void add_face(std::vector<Measurement>& made, const PlannedCut& planned, const CutFace& face,
              const RebuiltBone& rebuilt) {
  const FacePlane plan{planned.face.normal, planned.face.offset_mm};
  const FaceMetrics metrics =
      measure_face(face.samples_in_bone_mm, face.plane, plan,
                   {planned.depth_point_in_bone_mm, planned.exit_point_in_bone_mm, plan.normal});
  const std::int64_t frozen_tick = rebuilt.kerfs[static_cast<std::size_t>(face.kerf)].frozen_tick;
  made.push_back(measurement(planned, Metric::AngleDeg, metrics.angle_deg,
                             {frozen_tick, frozen_tick}, metrics.worst_point_in_bone_mm));
  made.back().direction = scenarios::direction_text(deepest_direction(face.plane, plan));
  if (planned.kind != scenarios::FaceKind::AlongAxis) made.back().detail = edge_text(face, plan);
  made.push_back(measurement(planned, Metric::LocationMm, metrics.location_mm,
                             cutting_moment(rebuilt, face.kerf), metrics.worst_point_in_bone_mm));
  made.back().direction = error_direction_text(metrics.worst_mm, plan.normal);
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

std::vector<Measurement> measure_cut(const PlannedCut& planned, const std::vector<CutFace>& faces,
                                     const RebuiltBone& rebuilt, const simulator::Bone& bone,
                                     const Recording& recording) {
  if (faces.empty() || faces.front().samples_in_bone_mm.empty()) return nothing_measured(planned);
  const CutFace& face = faces.front();
  const bool is_along = planned.kind == scenarios::FaceKind::AlongAxis;
  const ResectionPlan plan{{planned.face.normal, planned.face.offset_mm},
                           planned.depth_point_in_bone_mm,
                           planned.exit_point_in_bone_mm};
  std::vector<Measurement> made;
  add_face(made, planned, face, rebuilt);
  if (is_along) add_resection(made, planned, plan, face, rebuilt);
  add_flatness(made, planned,
               measure_flatness(cutting_tooth_points(recording, rebuilt, bone, face.kerf)));
  if (is_along) add_harm(made, planned, worst_harm(faces, rebuilt, plan), rebuilt, face.kerf);
  for (Measurement& each : made) each.done_fraction = face.done_fraction;
  return made;
}

}  // namespace hallux::assessment

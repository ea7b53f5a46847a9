#include "assessment/measure_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "assessment/metrics/blade_flatness.h"
#include "assessment/metrics/face_metrics.h"
#include "assessment/metrics/resection.h"
#include "assessment/number_text.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using scenarios::PlannedCut;
using simulator::Recording;
using simulator::ToolSample;
using simulator::ToolStatus;

constexpr std::array metric_names{"angle_deg",   "location_mm",      "depth_mm", "step_mm",
                                  "flatness_mm", "past_landmark_mm", "notch_mm"};

/// A span of ticks, both ends included.
struct Moment {
  std::int64_t first_tick = 0, last_tick = 0;
};

Measurement measurement(const PlannedCut& planned, const char* metric, double value,
                        const Moment& moment, const Vec3& place_in_bone_mm) {
  Measurement made;
  made.metric = metric;
  made.cut = planned.name;
  made.value = rounded_to_micro(value);
  made.start_us = time_us_from_tick(moment.first_tick);
  made.end_us = time_us_from_tick(moment.last_tick + 1);
  made.place_in_bone_mm = place_in_bone_mm;
  return made;
}

std::vector<Measurement> nothing_measured(const PlannedCut& planned) {
  std::vector<Measurement> measurements;
  for (const char* metric : metric_names) {
    Measurement absent;
    absent.metric = metric;
    absent.cut = planned.name;
    absent.is_measured = false;
    absent.place_in_bone_mm = planned.depth_point_in_bone_mm;
    measurements.push_back(absent);
  }
  return measurements;
}

/// Ends and middle of the tooth line at each tick in which the blade cut in this kerf.
std::vector<ToothPoint> tooth_points(const Recording& recording, const RebuiltBone& rebuilt,
                                     const simulator::Bone& bone, std::int32_t kerf) {
  const RigidTransform bone_from_world = inverse(bone.world_from_bone);
  const double half_width_mm = 0.5 * rebuilt.fields.blade().width_mm;
  std::vector<ToothPoint> points;
  for (const ToolSample& sample : recording.samples) {
    if (sample.kerf != kerf || !has(sample.status, ToolStatus::Cutting)) continue;
    const RigidTransform bone_from_tool = bone_from_world * transform_from(sample.world_from_tool);
    for (const double y_mm : {-half_width_mm, 0.0, half_width_mm}) {
      points.push_back({transform_point(bone_from_tool, Vec3{0.0, y_mm, 0.0}), sample.tick});
    }
  }
  return points;
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
std::string words_of(double error_mm, const Vec3& to_waste) {
  return direction_words(error_mm * to_waste);
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
  measurements.push_back(measurement(planned, "past_landmark_mm", harm.past_landmark_mm,
                                     moment_of(harm.past_kerf), planned.depth_point_in_bone_mm));
  measurements.push_back(measurement(planned, "notch_mm", harm.notch_mm, moment_of(harm.notch_kerf),
                                     planned.exit_point_in_bone_mm));
}

void add_flatness(std::vector<Measurement>& measurements, const PlannedCut& planned,
                  const std::optional<Flatness>& flatness) {
  const Flatness known = flatness.value_or(Flatness{});
  measurements.push_back(measurement(planned, "flatness_mm", known.flatness_mm,
                                     {known.tick, known.tick}, known.point_in_bone_mm));
  measurements.back().is_measured = flatness.has_value();
}

}  // namespace

std::vector<Measurement> measure_cut(const PlannedCut& planned, const std::vector<CutFace>& faces,
                                     const RebuiltBone& rebuilt, const simulator::Bone& bone,
                                     const Recording& recording) {
  if (faces.empty() || faces.front().samples_in_bone_mm.empty()) return nothing_measured(planned);
  const CutFace& face = faces.front();
  const Vec3& to_waste = planned.face.normal;
  const ResectionPlan plan{{to_waste, planned.face.offset_mm},
                           planned.depth_point_in_bone_mm,
                           planned.exit_point_in_bone_mm};
  const FaceMetrics metrics =
      measure_face(face.samples_in_bone_mm, face.plane, plan.face,
                   {plan.depth_point_in_bone_mm, plan.exit_point_in_bone_mm, to_waste});
  const ResectionMetrics resection = measure_resection(face.plane, plan);
  const std::int64_t frozen_tick = rebuilt.kerfs[static_cast<std::size_t>(face.kerf)].frozen_tick;
  const Moment cutting = cutting_moment(rebuilt, face.kerf);
  std::vector<Measurement> made;
  made.push_back(measurement(planned, "angle_deg", metrics.angle_deg, {frozen_tick, frozen_tick},
                             metrics.worst_point_in_bone_mm));
  made.back().direction = direction_words(deepest_direction(face.plane, plan.face));
  made.push_back(measurement(planned, "location_mm", metrics.location_mm, cutting,
                             metrics.worst_point_in_bone_mm));
  made.back().direction = words_of(metrics.worst_mm, to_waste);
  made.push_back(measurement(planned, "depth_mm", std::abs(resection.depth_error_mm), cutting,
                             plan.depth_point_in_bone_mm));
  made.back().direction = words_of(resection.depth_error_mm, to_waste);
  made.push_back(measurement(planned, "step_mm", std::abs(resection.step_error_mm), cutting,
                             plan.exit_point_in_bone_mm));
  made.back().direction = words_of(resection.step_error_mm, to_waste);
  add_flatness(made, planned, measure_flatness(tooth_points(recording, rebuilt, bone, face.kerf)));
  add_harm(made, planned, worst_harm(faces, rebuilt, plan), rebuilt, face.kerf);
  for (Measurement& each : made) each.done_fraction = face.done_fraction;
  return made;
}

}  // namespace hallux::assessment

#include "assessment/measure_closing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "assessment/make_measurement.h"
#include "assessment/metrics/face_metrics.h"
#include "assessment/process/sample_spans.h"
#include "assessment/rebuild/bound.h"
#include "assessment/rebuild/geometry_bounds.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::PlannedHinge;
using simulator::CutEvent;

/// Faces that are no further apart touch.
constexpr double touching_mm = 0.2;

/// By how much the bone beyond was turned, seen from dorsal; positive as planned.
double correction_deg(const RigidTransform& bone_from_moved, const PlannedHinge& hinge,
                      const scenarios::Plan& plan) {
  const auto tilt_rad = [&](const std::string& cut) {
    const Vec3& normal = find_cut(plan, cut)->face.normal;
    return transverse_tilt_rad(normal.x >= 0.0 ? normal : -normal);
  };
  const double planned_rad = tilt_rad(hinge.first_cut) - tilt_rad(hinge.second_cut);
  const double turned_deg = degree_from_radian(transverse_tilt_rad(axis_x(bone_from_moved)));
  return planned_rad < 0.0 ? -turned_deg : turned_deg;
}

/// By how much the bone's distal end came nearer to its base, both on its axis.
double shortening_mm(const RigidTransform& bone_from_moved, const simulator::Bone& bone) {
  double length_mm = 0.0;
  for (const Vec3& point_mm : bone.outer.points_mm) length_mm = std::max(length_mm, point_mm.x);
  return length_mm - length_of(transform_point(bone_from_moved, Vec3{length_mm, 0.0, 0.0}));
}

/// How the first face lies against the second one after it was turned with its half.
struct Contact {
  double gap_mm = 0.0, share = 0.0;
  double gap_bound_mm = 0.0, share_bound = 0.0;
  Vec3 widest_in_bone_mm{0.0, 0.0, 0.0};
};

Contact contact_of(const CutFace& first, const CutFace& second,
                   const RigidTransform& bone_from_moved) {
  const Vec3 normal = transform_direction(bone_from_moved, second.plane.normal);
  const Vec3 on_plane_mm =
      transform_point(bone_from_moved, second.plane.offset_mm * second.plane.normal);
  const FacePlane turned{normal, glm::dot(normal, on_plane_mm)};
  Contact contact;
  const double slope = length_of(glm::cross(normal, first.plane.normal));
  // A sample stands for half a step to all sides of it.
  const double unsure_mm = 0.5 * diagonal * slope * first.step_mm + 2.0 * plane_bound_mm;
  std::size_t touching = 0, unsure = 0;
  for (const Vec3& sample_mm : first.samples_in_bone_mm) {
    // The waste of the second face lies towards its normal: on that side the faces stand apart.
    const double apart_mm = signed_distance_mm(turned, sample_mm);
    if (apart_mm <= touching_mm) ++touching;
    if (std::abs(apart_mm - touching_mm) <= unsure_mm) ++unsure;
    if (apart_mm <= contact.gap_mm) continue;
    contact.gap_mm = apart_mm;
    contact.widest_in_bone_mm = sample_mm;
  }
  const auto count = static_cast<double>(first.samples_in_bone_mm.size());
  contact.share = static_cast<double>(touching) / count;
  contact.share_bound = std::min(1.0, static_cast<double>(unsure) / count + area_bound(first));
  contact.gap_bound_mm = reach_bound_mm(first, slope) + plane_bound_mm;
  return contact;
}

std::array<Measurement, 4> measure_closing(const Evidence& evidence, const PlannedHinge& hinge) {
  const Vec3& place_mm = hinge.bridge.line.point_in_bone_mm;
  std::array<Measurement, 4> made{absent(Metric::CorrectionDeg, Absence::NotDone, place_mm),
                                  absent(Metric::ShorteningMm, Absence::NotDone, place_mm),
                                  absent(Metric::GapMm, Absence::NotDone, place_mm),
                                  absent(Metric::ContactShare, Absence::NotDone, place_mm)};
  const CutEvent* closing =
      closing_of(evidence.recording, index_of_hinge(evidence.plan, hinge.name));
  const CutFace* first = counting_face(evidence, hinge.first_cut);
  const CutFace* second = counting_face(evidence, hinge.second_cut);
  if (closing == nullptr || first == nullptr || second == nullptr) return made;
  const RigidTransform bone_from_moved = transform_from(closing->pose);
  const Moment moment{closing->tick, closing->tick};
  const Contact contact = contact_of(*first, *second, bone_from_moved);
  made = {measured(Metric::CorrectionDeg, correction_deg(bone_from_moved, hinge, evidence.plan),
                   moment, place_mm),
          measured(Metric::ShorteningMm, shortening_mm(bone_from_moved, evidence.bones[hinge.bone]),
                   moment, place_mm),
          measured(Metric::GapMm, contact.gap_mm, moment, contact.widest_in_bone_mm),
          measured(Metric::ContactShare, contact.share, moment, contact.widest_in_bone_mm)};
  made[2].bound += contact.gap_bound_mm;
  made[3].bound += contact.share_bound;
  return made;
}

}  // namespace

std::vector<Measurement> measure_closings(const Evidence& evidence) {
  std::vector<Measurement> made;
  for (const scenarios::OperationStep& step : evidence.scenario.steps) {
    if (step.kind != scenarios::StepKind::Close) continue;
    for (Measurement& each : measure_closing(evidence, *find_hinge(evidence.plan, step.hinge))) {
      each.hinge = step.hinge;
      made.push_back(std::move(each));
    }
  }
  return made;
}

}  // namespace hallux::assessment

// Walls are planes, so that a fitted one is exact but for rounding. What is left is where the face
// ends: the greatest of a linear function over it lies at its border, between two samples, and a
// mean over it is as sure as its area.
#include "assessment/rebuild/geometry_bounds.h"

#include <algorithm>
#include <cmath>

#include "assessment/rebuild/bound.h"
#include "scenarios/metric_names.h"
#include "simulator/cutting/hinge/hinge_gap.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::PlannedCut;
using scenarios::PlannedHinge;

constexpr double normal_bound_deg = degree_from_radian(normal_bound_rad);
/// The tilt of a normal within 60 degrees of the bone's axis turns by no more than twice as much.
constexpr double tilt_bound_deg = 2.0 * normal_bound_deg;

/// The tip, by the field; it and the far cortex each within a row that rises no steeper than 45
/// degrees.
constexpr double bridge_bound_mm = field_bound_mm + 2.0 * simulator::hinge_row_step_mm;

double sine_between(const Vec3& a, const Vec3& b) noexcept { return length_of(glm::cross(a, b)); }

/// The distances of samples from a plane, without sign.
struct Spread {
  double least_mm = INFINITY, greatest_mm = 0.0, mean_mm = 0.0, square_mm2 = 0.0;
};

Spread spread_of(const CutFace& face, const FacePlane& plane) {
  Spread spread;
  for (const Vec3& sample_mm : face.samples_in_bone_mm) {
    const double off_mm = std::abs(signed_distance_mm(plane, sample_mm));
    spread.least_mm = std::min(spread.least_mm, off_mm);
    spread.greatest_mm = std::max(spread.greatest_mm, off_mm);
    spread.mean_mm += off_mm;
    spread.square_mm2 += off_mm * off_mm;
  }
  const auto count = static_cast<double>(face.samples_in_bone_mm.size());
  spread.mean_mm /= count;
  spread.square_mm2 /= count;
  return spread;
}

/// Misjudged border times how far a distance there may be from the mean; it turns once, where the
/// planes cross.
double mean_bound_mm(const CutFace& face, const FacePlane& plan, double slope) {
  const Spread spread = spread_of(face, plan);
  const double aside_mm =
      std::max(spread.greatest_mm - spread.mean_mm, spread.mean_mm - spread.least_mm);
  return area_bound(face) * (aside_mm + slope * face.step_mm);
}

/// The same of squares, which over a step's square lie slope^2 step^2 / 12 above their middle's.
double rms_bound_mm(const CutFace& face, const FacePlane& plan, double slope) {
  const Spread spread = spread_of(face, plan);
  const double low_mm = spread.least_mm, high_mm = spread.greatest_mm;
  const double rise_mm = slope * face.step_mm, square_mm2 = spread.square_mm2;
  const double aside_mm2 = std::max(high_mm * high_mm - square_mm2, square_mm2 - low_mm * low_mm);
  const double bound_mm2 =
      area_bound(face) * (aside_mm2 + 2.0 * rise_mm * high_mm) + rise_mm * rise_mm / 12.0;
  return std::sqrt(square_mm2) - std::sqrt(std::max(0.0, square_mm2 - bound_mm2));
}

/// Beside its rounding; nothing where a face has no say in it.
std::optional<double> bound_by_face(Metric metric, const CutFace& face, const PlannedCut& cut) {
  const FacePlane plan{cut.face.normal, cut.face.offset_mm};
  const double slope = sine_between(face.plane.normal, plan.normal);
  const bool is_along = cut.is_along_bone;
  const Vec3 towards = is_along ? plan.normal : Vec3{1.0, 0.0, 0.0};
  switch (metric) {
    case Metric::AngleDeg:
    case Metric::CommonAxisDeg:
      return normal_bound_deg;
    case Metric::IncludedAngleDeg:
      return 2.0 * normal_bound_deg;
    case Metric::OverhangMm:
      return field_bound_mm;
    case Metric::TransverseTiltDeg:
    case Metric::SagittalTiltDeg:
      return tilt_bound_deg;
    case Metric::LocationMm:
      return reach_bound_mm(face, slope);
    case Metric::MeanMm:
      return mean_bound_mm(face, plan, slope) + plane_bound_mm;
    case Metric::RmsMm:
      return rms_bound_mm(face, plan, slope) + plane_bound_mm;
    case Metric::EntryMm:
    case Metric::ExitMm:
    case Metric::DepthMm:
    case Metric::StepMm:
    case Metric::PastLandmarkMm:
    case Metric::NotchMm:
      return plane_bound_mm / std::abs(glm::dot(face.plane.normal, towards));
    default:
      return std::nullopt;
  }
}

/// Where two planes meet is known the worse the nearer they are to parallel.
std::optional<double> bound_by_wedge(Metric metric, const CutFace& first, const CutFace& second) {
  const double sine = sine_between(first.plane.normal, second.plane.normal);
  switch (metric) {
    case Metric::WedgeErrorDeg:
    case Metric::WedgeSagittalDeg:
      return 2.0 * tilt_bound_deg;
    case Metric::BaseMm:
      return plane_bound_mm / std::abs(first.plane.normal.x) +
             plane_bound_mm / std::abs(second.plane.normal.x);
    case Metric::ApexOffsetMm:
      return 2.0 * plane_bound_mm / sine;
    case Metric::ApexAngleDeg:
      return 2.0 * normal_bound_deg / sine;
    default:
      return std::nullopt;
  }
}

}  // namespace

double reach_bound_mm(const CutFace& face, double slope) noexcept {
  const double border_mm = face.is_finished ? 0.0 : field_bound_mm;
  return slope * (reach_steps * face.step_mm + border_mm) + plane_bound_mm;
}

double area_bound(const CutFace& face) noexcept {
  const double border_steps = face.is_finished ? 0.5 : 0.5 + field_bound_mm / face.step_mm;
  return std::min(1.0, face.border_share * border_steps);
}

std::optional<double> bound_of_cut(Metric metric, const std::string& cut,
                                   const Evidence& evidence) {
  const CutFace* face = counting_face(evidence, cut);
  if (face == nullptr) return std::nullopt;
  return bound_by_face(metric, *face, *find_cut(evidence.plan, cut));
}

std::optional<double> bound_of_hinge(Metric metric, const std::string& hinge,
                                     const Evidence& evidence) {
  if (metric == Metric::HingeMm || metric == Metric::OverCutMm) return bridge_bound_mm;
  const PlannedHinge& planned = *find_hinge(evidence.plan, hinge);
  const CutFace* first = counting_face(evidence, planned.first_cut);
  const CutFace* second = counting_face(evidence, planned.second_cut);
  if (first == nullptr || second == nullptr) return std::nullopt;
  return bound_by_wedge(metric, *first, *second);
}

}  // namespace hallux::assessment

/// The bridge is as thin as the kerf that left least of it, and cut through as far as the one that
/// went furthest; both are measured on the bone as it was: what an earlier kerf took must not move
/// the far surface of a later one. The wedge is measured between the two faces and held against the
/// planned one. A metric whose faces are missing is there, and not measured.
#include "assessment/measure_hinge.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "assessment/blade_track.h"
#include "assessment/ledger.h"
#include "assessment/make_measurement.h"
#include "assessment/metrics/akin.h"
#include "assessment/number_text.h"
#include "simulator/base/units.h"
#include "simulator/cutting/hinge/hinge_gap.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::PlannedCut;
using scenarios::PlannedHinge;
using simulator::HingeGap;

/// Not measured yet.
Measurement named(const PlannedHinge& hinge, Metric metric) {
  Measurement made = absent(metric, Absence::NotMade, hinge.bridge.line.point_in_bone_mm);
  made.hinge = hinge.name;
  return made;
}

void set_value(Measurement& made, double value) {
  made.value = rounded_to_micro(value);
  made.absence = Absence::None;
}

void set_moment(Measurement& made, std::int64_t first_tick, std::int64_t last_tick) {
  made.start_us = time_us_from_tick(first_tick);
  made.end_us = time_us_from_tick(last_tick + 1);
}

/// The faces of one of the hinge's cuts.
struct CutEvidence {
  const PlannedCut& planned;
  const std::vector<CutFace>& faces;

  bool has_face() const noexcept {
    return !faces.empty() && !faces.front().samples_in_bone_mm.empty();
  }
  double done_fraction() const noexcept { return has_face() ? faces.front().done_fraction : 0.0; }
};

CutEvidence evidence_of(const Evidence& evidence, const std::string& cut) {
  const PlannedCut& planned = *find_cut(evidence.plan, cut);
  const auto index = static_cast<std::size_t>(&planned - evidence.plan.cuts.data());
  return {planned, evidence.faces[index]};
}

/// The same plane with its normal to the distal side.
FacePlane looking_distal(const FacePlane& plane) noexcept {
  if (plane.normal.x >= 0.0) return plane;
  return {-plane.normal, -plane.offset_mm};
}

FacePlane planned_face(const PlannedCut& cut) noexcept {
  return looking_distal({cut.face.normal, cut.face.offset_mm});
}

struct Wedge {
  AkinMetrics made, planned;
};

Wedge measure_wedge(const CutEvidence& first, const CutEvidence& second,
                    const PlannedHinge& hinge) {
  const FacePlane planned1 = planned_face(first.planned), planned2 = planned_face(second.planned);
  const AkinPlan plan{planned1,
                      planned2,
                      {first.planned.entry_point_in_bone_mm, hinge.bridge.line.point_in_bone_mm,
                       Vec3{1.0, 0.0, 0.0}}};
  const CutFace &face1 = first.faces.front(), &face2 = second.faces.front();
  const AkinFace made1{looking_distal(face1.plane), face1.samples_in_bone_mm};
  const AkinFace made2{looking_distal(face2.plane), face2.samples_in_bone_mm};
  return {measure_akin({made1, made2, 0.0, 0.0}, plan),
          measure_akin({{planned1, {}}, {planned2, {}}, 0.0, 0.0}, plan)};
}

/// Which wedge was taken and which was asked for, in numbers that a ruler can check.
Detail taken_and_planned(const Wedge& wedge) {
  Detail both{DetailKind::WedgeTaken, {}, {}};
  for (const double value :
       {wedge.made.wedge_deg, wedge.planned.wedge_deg, wedge.made.base_mm, wedge.planned.base_mm})
    both.values.push_back(rounded_to_micro(std::abs(value)));
  return both;
}

/// The line in which the two faces meet, against the planned one.
struct Apex {
  double offset_mm = 0.0, angle_deg = 0.0;
};

/// Nothing where the faces do not meet.
std::optional<Apex> measure_apex(const FacePlane& first, const FacePlane& second,
                                 const simulator::HingeLine& planned) {
  const Vec3 across = glm::cross(first.normal, second.normal);
  const double size = length_of(across);
  constexpr double almost_parallel = 1.0e-6;
  if (size < almost_parallel) return std::nullopt;
  const Vec3 axis = across / size;
  // From the planned point along the first plane to the second one, square to the line.
  const double to_first_mm = signed_distance_mm(first, planned.point_in_bone_mm);
  const Vec3 on_first_mm = planned.point_in_bone_mm - to_first_mm * first.normal;
  const Vec3 along = glm::cross(axis, first.normal);
  const Vec3 foot_mm = on_first_mm - signed_distance_mm(second, on_first_mm) /
                                         glm::dot(second.normal, along) * along;
  const double angle_rad = angle_between_rad(axis, planned.axis);
  return Apex{length_of(foot_mm - planned.point_in_bone_mm),
              degree_from_radian(std::min(angle_rad, pi - angle_rad))};
}

/// wedge_error_deg, wedge_sagittal_deg, wedge_reversed, base_mm, apex_offset_mm, apex_angle_deg.
void add_wedge(std::vector<Measurement>& made, const CutEvidence& first, const CutEvidence& second,
               const PlannedHinge& hinge, const RebuiltBone& rebuilt) {
  const std::size_t begin = made.size();
  for (const Metric metric :
       {Metric::WedgeErrorDeg, Metric::WedgeSagittalDeg, Metric::WedgeReversed, Metric::BaseMm,
        Metric::ApexOffsetMm, Metric::ApexAngleDeg})
    made.push_back(named(hinge, metric));
  if (!first.has_face() || !second.has_face()) return;
  const Wedge wedge = measure_wedge(first, second, hinge);
  const bool is_larger = std::abs(wedge.made.wedge_deg) > std::abs(wedge.planned.wedge_deg);
  Measurement& error = made[begin];
  set_value(error, std::abs(wedge.made.wedge_error_deg));
  error.direction = is_larger ? "large" : "small";
  error.detail = taken_and_planned(wedge);
  const double lean_deg = wedge.made.wedge_sagittal_deg - wedge.planned.wedge_sagittal_deg;
  Measurement& sagittal = made[begin + 1];
  set_value(sagittal, std::abs(lean_deg));
  sagittal.direction = lean_deg > 0.0 ? "plantar" : "dorsal";
  sagittal.detail.kind = DetailKind::TipsToe;
  set_value(made[begin + 2], wedge.made.wedge_deg * wedge.planned.wedge_deg < 0.0 ? 1.0 : 0.0);
  set_value(made[begin + 3], std::copysign(1.0, wedge.planned.base_mm) * wedge.made.base_mm);
  const auto apex =
      measure_apex(first.faces.front().plane, second.faces.front().plane, hinge.bridge.line);
  for (std::size_t index = begin + 4; index < made.size(); ++index)
    made[index].absence = Absence::Undefined;
  if (apex) {
    set_value(made[begin + 4], apex->offset_mm);
    set_value(made[begin + 5], apex->angle_deg);
  }
  const auto later =
      static_cast<std::size_t>(std::max(first.faces.front().kerf, second.faces.front().kerf));
  for (std::size_t index = begin; index < made.size(); ++index) {
    set_moment(made[index], rebuilt.kerfs[later].frozen_tick,
               rebuilt.kerfs[later].last_cutting_tick);
    if (index < begin + 4) made[index].place_in_bone_mm = second.planned.entry_point_in_bone_mm;
  }
}

/// A kerf of the hinge and what it left of the bridge.
struct KerfGap {
  std::int32_t kerf = -1;
  HingeGap gap;
};

std::vector<KerfGap> gaps_of(const Evidence& evidence, const PlannedHinge& hinge,
                             const std::vector<std::int32_t>& kerfs) {
  std::vector<KerfGap> gaps;
  if (kerfs.empty()) return gaps;
  // The bone as it was: what an earlier kerf took must not move the far surface of a later one.
  const simulator::CutSolid solid = simulator::uncut_solid(solid_of(evidence.bones[hinge.bone]));
  const simulator::Bvh bvh(solid.mesh);
  for (const std::int32_t kerf : kerfs) {
    const std::optional<HingeGap> gap = measure_hinge_gap(
        slice_section(solid, bvh, evidence.rebuilt.fields.plane(kerf)),
        evidence.rebuilt.kerfs[static_cast<std::size_t>(kerf)].outline, hinge.bridge.line);
    if (gap) gaps.push_back({kerf, *gap});
  }
  return gaps;
}

std::vector<std::int32_t> kerfs_of(const CutEvidence& first, const CutEvidence& second) {
  std::vector<std::int32_t> kerfs;
  for (const CutEvidence* cut : {&first, &second}) {
    for (const CutFace& face : cut->faces) kerfs.push_back(face.kerf);
  }
  std::sort(kerfs.begin(), kerfs.end());
  return kerfs;
}

/// Without those that opened nothing there.
std::vector<KerfGap> opened_gaps(const Evidence& evidence, const PlannedHinge& hinge,
                                 const CutEvidence& first, const CutEvidence& second) {
  std::vector<KerfGap> gaps = gaps_of(evidence, hinge, kerfs_of(first, second));
  std::erase_if(gaps, [](const KerfGap& gap) { return !gap.gap.is_opened; });
  return gaps;
}

std::optional<Reach> reach_of(const Evidence& evidence, const PlannedHinge& hinge,
                              const KerfGap& gap) {
  const Vec3& outward = hinge.bridge.line.outward;
  const ReachLimit limit{outward, glm::dot(outward, gap.gap.far_in_bone_mm)};
  return measure_reach(evidence.recording, evidence.rebuilt, evidence.bones, gap.kerf, limit);
}

/// hinge_mm of the kerf that left least.
Measurement bridge_measurement(const Evidence& evidence, const PlannedHinge& hinge,
                               const std::vector<KerfGap>& gaps) {
  Measurement bridge = named(hinge, Metric::HingeMm);
  if (gaps.empty()) return bridge;
  const KerfGap& thinnest = *std::min_element(
      gaps.begin(), gaps.end(),
      [](const KerfGap& a, const KerfGap& b) { return a.gap.thickness_mm < b.gap.thickness_mm; });
  set_value(bridge, thinnest.gap.thickness_mm);
  bridge.place_in_bone_mm = thinnest.gap.tip_in_bone_mm;
  if (const std::optional<Reach> reach = reach_of(evidence, hinge, thinnest)) {
    set_moment(bridge, reach->deepest_tick, reach->deepest_tick);
  }
  return bridge;
}

/// over_cut_mm of the kerf that went furthest: from the first tick beyond the cortex to the
/// deepest.
Measurement over_cut_measurement(const Evidence& evidence, const PlannedHinge& hinge,
                                 const std::vector<KerfGap>& gaps) {
  Measurement over_cut = named(hinge, Metric::OverCutMm);
  if (gaps.empty()) return over_cut;
  const KerfGap& furthest = *std::max_element(
      gaps.begin(), gaps.end(),
      [](const KerfGap& a, const KerfGap& b) { return a.gap.over_cut_mm < b.gap.over_cut_mm; });
  set_value(over_cut, furthest.gap.over_cut_mm);
  over_cut.place_in_bone_mm = furthest.gap.tip_in_bone_mm;
  const std::optional<Reach> reach = reach_of(evidence, hinge, furthest);
  if (!reach) return over_cut;
  const bool has_passed = furthest.gap.over_cut_mm > 0.0 && reach->passed_tick.has_value();
  const std::int64_t first_tick = has_passed ? *reach->passed_tick : reach->deepest_tick;
  set_moment(over_cut, first_tick, std::max(first_tick, reach->deepest_tick));
  if (has_passed) {
    over_cut.detail = {
        DetailKind::FeltThrough, {rounded_to_micro(reach->passing_force_newton)}, {}};
  }
  return over_cut;
}

/// The worse of the two cuts.
Measurement flatness_measurement(const PlannedHinge& hinge, std::span<const Measurement> measured) {
  const Measurement* worse = nullptr;
  const std::string flatness_name(name_of(Metric::FlatnessMm));
  for (const std::string& cut : {hinge.first_cut, hinge.second_cut}) {
    const Measurement* flatness = find_measurement(measured, flatness_name, cut);
    if (flatness == nullptr || !flatness->is_measured()) return named(hinge, Metric::FlatnessMm);
    if (worse == nullptr || flatness->value > worse->value) worse = flatness;
  }
  Measurement made = *worse;
  made.cut.clear();
  made.hinge = hinge.name;
  return made;
}

}  // namespace

std::vector<Measurement> measure_hinge(const PlannedHinge& hinge, const Evidence& evidence,
                                       std::span<const Measurement> measured) {
  const CutEvidence first = evidence_of(evidence, hinge.first_cut);
  const CutEvidence second = evidence_of(evidence, hinge.second_cut);
  const std::vector<KerfGap> gaps = opened_gaps(evidence, hinge, first, second);
  std::vector<Measurement> made;
  add_wedge(made, first, second, hinge, evidence.rebuilt);
  Measurement bridge = bridge_measurement(evidence, hinge, gaps);
  Measurement lost = bridge;
  lost.metric = name_of(Metric::HingeLost);
  lost.value = lost.is_measured() && lost.value == 0.0 ? 1.0 : 0.0;
  if (!first.has_face() || !second.has_face()) bridge.absence = Absence::NotMade;
  made.push_back(std::move(bridge));
  made.push_back(flatness_measurement(hinge, measured));
  made.push_back(over_cut_measurement(evidence, hinge, gaps));
  made.push_back(std::move(lost));
  const double done = std::min(first.done_fraction(), second.done_fraction());
  for (Measurement& each : made) each.done_fraction = done;
  return made;
}

std::vector<KerfBridge> bridges_left(const PlannedHinge& hinge, const Evidence& evidence) {
  std::vector<KerfBridge> bridges;
  for (const KerfGap& each : opened_gaps(evidence, hinge, evidence_of(evidence, hinge.first_cut),
                                         evidence_of(evidence, hinge.second_cut))) {
    const bool is_beyond = each.gap.over_cut_mm > 0.0;
    bridges.push_back({each.kerf, is_beyond ? -each.gap.over_cut_mm : each.gap.thickness_mm});
  }
  return bridges;
}

}  // namespace hallux::assessment

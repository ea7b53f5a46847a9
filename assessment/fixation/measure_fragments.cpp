#include "assessment/fixation/measure_fragments.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/make_measurement.h"
#include "assessment/process/sample_spans.h"
#include "scenarios/metric_names.h"
#include "scenarios/site/bone_words.h"
#include "simulator/jobs/lying_bones.h"
#include "simulator/record/fragment_poses.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::PlannedFragment;

constexpr std::array of_fragments{Metric::ShiftMm,     Metric::ShiftErrorMm, Metric::TurnErrorDeg,
                                  Metric::ElevationMm, Metric::ContactShare, Metric::GapMm,
                                  Metric::Fixed};
/// Of the planned way and along it, for one that was shifted.
constexpr double least_way = 0.5;

/// A planned fragment that was parted, and how it lies.
struct LeftFragment {
  const PlannedFragment& planned;
  const Body& body;
  const BodyPlacement& placement;
  bool is_held = false;
  Moment last_laid;
};

/// When it was laid down last, or turned as a hinge closed; the end where it never was.
Moment last_laid(const Body& body, const Evidence& evidence) {
  std::int64_t tick = last_tick_of(evidence.recording);
  simulator::FragmentPoses fragments = poses_of(evidence.bones);
  bool was_moved = false;
  for (const simulator::CutEvent& event : evidence.recording.events) {
    fragments.apply(event);
    const bool is_moved = body.fragment < fragments.count() && fragments[body.fragment].is_moved;
    const bool is_laid =
        event.kind == simulator::CutEventKind::Released && event.subject == body.fragment;
    if (is_laid || (is_moved && !was_moved)) tick = event.tick;
    was_moved = is_moved;
  }
  return {tick, tick};
}

class FragmentMetrics {
 public:
  explicit FragmentMetrics(const LeftFragment& fragment) : fragment_(fragment) {
    const Body& body = fragment.body;
    reached_mm_ = transform_point(body.bone_from_piece, body.centroid_in_bone_mm);
    off_mm_ =
        reached_mm_ - transform_point(fragment.planned.bone_from_rest, body.centroid_in_bone_mm);
  }

  std::vector<Measurement> all() const {
    const BodyPlacement& placement = fragment_.placement;
    const double raised_mm = glm::dot(off_mm_, fragment_.planned.foot_dorsal_in_bone);
    std::vector<Measurement> made{of(Metric::ShiftMm, placement.moved_mm),
                                  of(Metric::ShiftErrorMm, length_of(off_mm_)),
                                  of(Metric::TurnErrorDeg, placement.error_deg.value_or(0.0)),
                                  of(Metric::ElevationMm, raised_mm),
                                  of_sawn(Metric::ContactShare, placement.contact_share),
                                  of_sawn(Metric::GapMm, placement.gap_max_mm),
                                  of(Metric::Shifted, is_shifted() ? 1.0 : 0.0),
                                  of(Metric::Fixed, fragment_.is_held ? 1.0 : 0.0)};
    made[1].direction = scenarios::direction_text(off_mm_);
    made[3].direction = raised_mm >= 0.0 ? "dorsal" : "plantar";
    // A sample of the sawn faces stands for what lies nearer to it than to the next one.
    made[4].bound += placement.contact_bound;
    made[5].bound += sample_reach_mm;
    return made;
  }

 private:
  bool is_shifted() const {
    const Vec3& centroid_mm = fragment_.body.centroid_in_bone_mm;
    const Vec3 way_mm =
        transform_point(fragment_.planned.bone_from_rest, centroid_mm) - centroid_mm;
    return glm::dot(reached_mm_ - centroid_mm, way_mm) >= least_way * glm::dot(way_mm, way_mm);
  }
  Measurement of(Metric metric, double value) const {
    return measured(metric, value, fragment_.last_laid, reached_mm_);
  }
  Measurement of_sawn(Metric metric, const std::optional<double>& value) const {
    return value ? of(metric, *value) : absent(metric, Absence::Undefined, reached_mm_);
  }

  LeftFragment fragment_;
  /// Where its centroid lies, and that from where the plan brings it.
  Vec3 reached_mm_, off_mm_;
};

/// Of one that was never parted, or was taken out: that it was not shifted is known.
std::vector<Measurement> not_done(const PlannedFragment& planned, const Evidence& evidence) {
  std::vector<Measurement> made;
  made.reserve(of_fragments.size() + 1);
  for (const Metric metric : of_fragments)
    made.push_back(absent(metric, Absence::NotDone, planned.holds_in_bone_mm));
  const std::int64_t tick = last_tick_of(evidence.recording);
  made.push_back(measured(Metric::Shifted, 0.0, {tick, tick}, planned.holds_in_bone_mm));
  return made;
}

}  // namespace

std::vector<Measurement> measure_fragments(const WhatIsLeft& left, const Evidence& evidence) {
  std::vector<Measurement> all;
  for (const PlannedFragment& planned : evidence.plan.fixation.fragments) {
    const auto found = std::ranges::find_if(left.bodies, [&](const Body& body) {
      return body.name == planned.name && body.fragment >= 0;
    });
    std::vector<Measurement> made = not_done(planned, evidence);
    if (found != left.bodies.end()) {
      const auto index = static_cast<std::size_t>(found - left.bodies.begin());
      made = FragmentMetrics({planned, *found, left.placements[index], left.is_held[index],
                              last_laid(*found, evidence)})
                 .all();
    }
    for (Measurement& each : made) {
      each.fragment = planned.name;
      all.push_back(std::move(each));
    }
  }
  return all;
}

}  // namespace hallux::assessment

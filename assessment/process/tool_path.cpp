#include "assessment/process/tool_path.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "assessment/process/place_track.h"
#include "assessment/process/sample_spans.h"
#include "assessment/process/tool_place.h"
#include "scenarios/hands/planned_strokes.h"

namespace hallux::assessment {

namespace {

using simulator::TapeLine;
using simulator::ToolSample;

/// From place to place where a tool goes into bone; at each to the end and back.
class ShortestWay {
 public:
  explicit ShortestWay(const Vec3& from_in_bone_mm) : place_mm_(from_in_bone_mm) {}

  void go_in(const Vec3& begin_mm, double depth_mm) {
    length_mm_ += length_of(begin_mm - place_mm_) + 2.0 * depth_mm;
    place_mm_ = begin_mm;
  }
  double length_mm() const noexcept { return length_mm_; }

 private:
  Vec3 place_mm_;
  double length_mm_ = 0.0;
};

/// A wire is driven; for a screw is drilled before.
int passes_of(const scenarios::PlannedImplant& implant) noexcept {
  return implant.kind == scenarios::ImplantKind::Screw ? 2 : 1;
}

/// What a step sets counts where the step was done: whoever leaves it out has no shorter way for
/// it.
double shortest_mm(const Evidence& evidence, const Vec3& from_in_bone_mm) {
  const auto strokes = planned_strokes(evidence.scenario, evidence.bones, evidence.plan);
  auto stroke = strokes.begin();
  ShortestWay way(from_in_bone_mm);
  const auto in_first = [&](std::size_t bone, const Vec3& point_mm) {
    return transform_point(first_from(evidence.bones, bone), point_mm);
  };
  for (std::size_t index = 0; index < evidence.scenario.steps.size(); ++index) {
    const scenarios::OperationStep& step = evidence.scenario.steps[index];
    if (is_sawn(step)) {
      const std::size_t cut = index_of_cut(evidence.plan, step.cut);
      for (; stroke != strokes.end() && stroke->cut == cut; ++stroke)
        way.go_in(in_first(evidence.plan.cuts[cut].bone,
                           stroke->bone_from_tool(stroke->first_mm).translation_mm),
                  stroke->last_mm - stroke->first_mm);
    }
    if (!last_tick_of(evidence.recording, simulator::CutEventKind::StepDone, index)) continue;
    for (const std::string& name : step.implants) {
      const scenarios::PlannedImplant& implant = *find_implant(evidence.plan.fixation, name);
      for (int pass = 0; pass < passes_of(implant); ++pass)
        way.go_in(in_first(implant.bone, implant.entry_in_bone_mm), implant.length_mm);
    }
  }
  return way.length_mm();
}

double length_mm(const PlaceStretch& stretch) {
  double way_mm = 0.0;
  for (std::size_t index = 1; index < stretch.count(); ++index)
    way_mm += length_of(stretch.at_mm(index) - stretch.at_mm(index - 1));
  return way_mm;
}

double length_mm(const std::vector<PlaceStretch>& stretches) {
  double way_mm = 0.0;
  for (const PlaceStretch& stretch : stretches) way_mm += length_mm(stretch);
  return way_mm;
}

/// Both ends of a stretch lie within the ticks of a line.
double ends_bound_mm(const std::vector<PlaceStretch>& stretches) {
  double bound_mm = 0.0;
  for (const PlaceStretch& stretch : stretches) {
    if (stretch.count() < 2) continue;
    const std::size_t last = stretch.count() - 1;
    bound_mm += length_of(stretch.at_mm(1) - stretch.at_mm(0)) +
                length_of(stretch.at_mm(last) - stretch.at_mm(last - 1));
  }
  return bound_mm;
}

/// What stretches tell, without their places.
struct Way {
  Vec3 from_in_bone_mm{0.0, 0.0, 0.0};
  double length_mm = 0.0, ends_bound_mm = 0.0;
  std::int64_t first_tick = 0, last_tick = 0;
};

std::optional<Way> way_along(const std::vector<PlaceStretch>& stretches) {
  if (stretches.empty()) return std::nullopt;
  const PlaceStretch& first = stretches.front();
  const PlaceStretch& last = stretches.back();
  return Way{first.at_mm(0), length_mm(stretches), ends_bound_mm(stretches), first.first_tick,
             last.first_tick + static_cast<std::int64_t>(last.count()) - 1};
}

}  // namespace

std::optional<Finding> measure_path_ratio(const Evidence& evidence, const simulator::Bvh& surface) {
  const RigidTransform bone_from_world = inverse(evidence.bones.first().world_from_bone);
  NearBone near(surface);
  const auto tip_near_bone = [&](const TapeLine&, const ToolSample& sample) -> std::optional<Vec3> {
    const Vec3 tip_mm = tip_in_bone_mm(sample, bone_from_world);
    if (!near.holds(tip_mm)) return std::nullopt;
    return tip_mm;
  };
  const std::optional<Way> way = way_along(followed_places(evidence.recorded(), tip_near_bone));
  if (!way) return std::nullopt;
  const double plan_mm = shortest_mm(evidence, way->from_in_bone_mm);
  if (!(plan_mm > 0.0)) return std::nullopt;
  const double coarse_mm = length_mm(followed_places(evidence.recorded(), tip_near_bone, 2));
  const double bound_mm = std::abs(way->length_mm - coarse_mm) + way->ends_bound_mm;
  return Finding{way->length_mm / plan_mm, way->first_tick, way->last_tick, bound_mm / plan_mm};
}

}  // namespace hallux::assessment

#include "assessment/process/over_cut.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenarios/faces/windowed_region.h"
#include "simulator/jobs/lying_bones.h"

namespace hallux::assessment {

namespace {

using scenarios::PlannedCut;
using simulator::SectionRegion;
using simulator::ToolSample;

/// Of the regions that the blade touched, as far as the cut's window reaches: the most outward.
/// Infinite where there is nothing of them.
double far_surface_mm(const RebuiltKerf& kerf, const PlannedCut& cut, const Vec3& outward) {
  const simulator::KerfPlane& plane = kerf.section.plane;
  double furthest_mm = -INFINITY;
  for (std::size_t i = 0; i < kerf.section.regions.size(); ++i) {
    if (kerf.is_touched[i] == 0) continue;
    const SectionRegion& whole = kerf.section.regions[i];
    const SectionRegion region = cut.window ? within_window(whole, plane, *cut.window) : whole;
    for (const simulator::Contour& contour : region.contours) {
      for (const Vec2& point_mm : contour) {
        const Vec3 in_bone_mm = transform_point(plane.bone_from_kerf, Vec3{point_mm, 0.0});
        furthest_mm = std::max(furthest_mm, glm::dot(outward, in_bone_mm));
      }
    }
  }
  return std::isfinite(furthest_mm) ? furthest_mm : INFINITY;
}

/// How far the teeth stand beyond the limit, below 0 within it, and the furthest of them.
struct Beyond {
  double over_mm = -INFINITY;
  Vec3 tooth_mm{0.0, 0.0, 0.0};
};

Beyond beyond(const RigidTransform& fragment_from_tool, double width_mm, const Vec3& outward,
              double limit_mm) {
  Beyond most;
  for (const double aside_mm : {-0.5 * width_mm, 0.0, 0.5 * width_mm}) {
    const Vec3 tooth_mm = transform_point(fragment_from_tool, Vec3{0.0, aside_mm, 0.0});
    const double over_mm = glm::dot(outward, tooth_mm) - limit_mm;
    if (over_mm > most.over_mm) most = {over_mm, tooth_mm};
  }
  return most;
}

}  // namespace

OverCut measure_over_cut(const simulator::Recording& recording, const RebuiltBone& rebuilt,
                         const simulator::Bones& bones, std::span<const std::int32_t> kerfs,
                         const PlannedCut& cut) {
  const Vec3 outward = -cut.approach_in_bone;
  std::vector<double> limits_mm(rebuilt.kerfs.size(), INFINITY);
  for (const std::int32_t kerf : kerfs) {
    const auto index = static_cast<std::size_t>(kerf);
    limits_mm[index] = far_surface_mm(rebuilt.kerfs[index], cut, outward);
  }
  simulator::FragmentPoses fragments = poses_of(bones);
  const simulator::Tray& tray = rebuilt.fields.tray();
  std::int32_t in_hand = 0;
  OverCut over;
  // Of the sample before; infinite where that was in none of these kerfs.
  double before_mm = INFINITY;
  auto event = recording.events.begin();
  for (const ToolSample& sample : recording.samples) {
    for (; event != recording.events.end() && event->tick <= sample.tick; ++event) {
      fragments.apply(*event);
      if (event->kind == simulator::CutEventKind::ToolChosen) in_hand = event->subject;
    }
    const bool is_of_cut = sample.kerf >= 0 && sample.kerf < std::ssize(limits_mm) &&
                           std::isfinite(limits_mm[static_cast<std::size_t>(sample.kerf)]);
    const simulator::Saw* const saw = tray.saw(in_hand);
    const bool is_running = saw != nullptr && has(sample.status, simulator::ToolStatus::SawOn);
    if (!is_of_cut || !is_running) {
      before_mm = INFINITY;
      continue;
    }
    const RigidTransform& fragment_from_world =
        fragments[rebuilt.fields.fragment_of(sample.kerf)].fragment_from_world;
    const Beyond stands =
        beyond(fragment_from_world * transform_from(sample.world_from_tool), saw->blade.width_mm,
               outward, limits_mm[static_cast<std::size_t>(sample.kerf)]);
    if (std::isfinite(before_mm))
      over.bound_mm = std::max(over.bound_mm, std::abs(stands.over_mm - before_mm));
    before_mm = stands.over_mm;
    if (stands.over_mm <= over.over_mm) continue;
    if (over.over_mm == 0.0) over.first_tick = sample.tick;
    over = {stands.over_mm, over.bound_mm, over.first_tick, sample.tick, stands.tooth_mm};
  }
  return over;
}

}  // namespace hallux::assessment

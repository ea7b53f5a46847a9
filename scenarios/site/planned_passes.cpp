#include "scenarios/site/planned_passes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "scenarios/faces/windowed_region.h"
#include "scenarios/site/planned_window.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/cutting/slice/section.h"

namespace hallux::scenarios {

namespace {

using simulator::KerfPlane;
using simulator::Section;
using simulator::SectionRegion;

/// Square to the planned axis in the face, away from the side of the approach.
Vec3 feed_of(const PlannedCut& cut) {
  const Vec3 across = unit(glm::cross(cut.face.normal, cut.axis));
  return glm::dot(across, cut.approach_in_bone) > 0.0 ? -across : across;
}

/// The middle of the blade's way: half a kerf from the face, in the waste. Its origin is the entry.
KerfPlane plane_of(const PlannedCut& cut, const Vec3& feed, double kerf_mm) {
  const Vec3 normal = unit(cut.face.normal);
  const Vec3 origin_mm = cut.entry_point_in_bone_mm + 0.5 * kerf_mm * normal;
  return {{rotation_from_axes(feed, glm::cross(normal, feed)), origin_mm}, kerf_mm};
}

double distance_to(const SectionRegion& region) {
  const Vec2 nearest = glm::clamp(Vec2(0.0, 0.0), region.min_mm, region.max_mm);
  return length_of(nearest);
}

struct Extent {
  double low_mm = std::numeric_limits<double>::infinity(),
         high_mm = -std::numeric_limits<double>::infinity();

  void add(double at_mm) noexcept {
    low_mm = std::min(low_mm, at_mm);
    high_mm = std::max(high_mm, at_mm);
  }
};

/// Along the tooth line, of the region at the entry as far as it is to be sawn.
Extent extent_of(const Section& section, const std::optional<PlannedWindow>& window) {
  const auto region = std::min_element(
      section.regions.begin(), section.regions.end(),
      [](const auto& a, const auto& b) { return distance_to(a) < distance_to(b); });
  Extent extent;
  for (const simulator::Contour& contour : region->contours) {
    for (const Vec2& corner : contour) {
      const Vec3 corner_mm = transform_point(section.plane.bone_from_kerf, Vec3(corner, 0.0));
      const bool is_sawn = !window || glm::dot(window->outward, corner_mm) <= window->limit_mm;
      if (is_sawn) extent.add(corner.y);
    }
  }
  return extent;
}

std::vector<double> middles_of(const Extent& extent, double width_mm) {
  const double from_mm = extent.low_mm - pass_overlap_mm, to_mm = extent.high_mm + pass_overlap_mm;
  const double beyond_mm = to_mm - from_mm - width_mm;
  if (beyond_mm <= 0.0) return {0.5 * (from_mm + to_mm)};
  const int more = passes_needed(extent.high_mm - extent.low_mm, width_mm) - 1;
  std::vector<double> middles;
  for (int pass = 0; pass <= more; ++pass)
    middles.push_back(from_mm + 0.5 * width_mm + beyond_mm * pass / more);
  return middles;
}

}  // namespace

int passes_needed(double extent_mm, double width_mm) noexcept {
  const double step_mm = std::max(0.5 * width_mm, width_mm - pass_overlap_mm);
  const double beyond_mm = extent_mm + 2.0 * pass_overlap_mm - width_mm;
  return beyond_mm <= 0.0 ? 1 : 1 + static_cast<int>(std::ceil(beyond_mm / step_mm));
}

PlannedPasses planned_passes(const Scenario& scenario, const Plan& plan, std::size_t cut,
                             const simulator::CutSolid& whole, const simulator::Bvh& bvh) {
  const PlannedCut& planned = plan.cuts[cut];
  const simulator::Blade& blade = blade_of(scenario, planned);
  PlannedPasses passes;
  passes.feed_in_bone = feed_of(planned);
  const KerfPlane plane = plane_of(planned, passes.feed_in_bone, blade.kerf_mm);
  passes.along_in_bone = axis_y(plane.bone_from_kerf);
  std::optional<PlannedWindow> window;
  if (const PlannedHinge* hinge = find_hinge(plan, planned.hinge))
    window = window_before(*hinge, blade.kerf_mm);
  Section section = slice_section(whole, bvh, plane);
  if (planned.window) keep_within(section, plane, *planned.window);
  Extent extent;
  if (!section.regions.empty()) extent = extent_of(section, window);
  if (!(extent.low_mm <= extent.high_mm)) extent = {0.0, 0.0};
  passes.low_mm = extent.low_mm;
  passes.high_mm = extent.high_mm;
  passes.middles_mm = middles_of(extent, blade.width_mm);
  return passes;
}

}  // namespace hallux::scenarios

#include "scenarios/faces/windowed_region.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hallux::scenarios {

namespace {

using simulator::Contour;
using simulator::SectionRegion;

/// Points p of the plane with toward . p >= least.
struct HalfPlane {
  Vec2 toward{1.0, 0.0};
  double least_mm = 0.0;

  double above_mm(const Vec2& point_mm) const { return glm::dot(toward, point_mm) - least_mm; }
};

/// Of space, as the kerf's plane has it.
HalfPlane half_plane(const simulator::KerfPlane& plane, const Vec3& toward, const Vec3& from_mm) {
  const RigidTransform& pose = plane.bone_from_kerf;
  return {Vec2{glm::dot(toward, axis_x(pose)), glm::dot(toward, axis_y(pose))},
          glm::dot(toward, from_mm - pose.translation_mm)};
}

/// What of a contour lies in the half plane; where it is left several times, its parts hang
/// together along the border.
Contour clipped(const Contour& contour, const HalfPlane& half) {
  Contour kept;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Vec2 &from_mm = contour[i], &to_mm = contour[(i + 1) % contour.size()];
    const double from_above_mm = half.above_mm(from_mm), to_above_mm = half.above_mm(to_mm);
    if (from_above_mm >= 0.0) kept.push_back(from_mm);
    if ((from_above_mm >= 0.0) == (to_above_mm >= 0.0)) continue;
    kept.push_back(from_mm + from_above_mm / (from_above_mm - to_above_mm) * (to_mm - from_mm));
  }
  return kept.size() < 3 ? Contour{} : kept;
}

double area_of(const Contour& contour) {
  double twice_mm2 = 0.0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Vec2 &a = contour[i], &b = contour[(i + 1) % contour.size()];
    twice_mm2 += a.x * b.y - b.x * a.y;
  }
  return 0.5 * twice_mm2;
}

void measure(SectionRegion& region) {
  region.min_mm = Vec2{INFINITY, INFINITY};
  region.max_mm = -region.min_mm;
  region.area_mm2 = 0.0;
  for (const Contour& contour : region.contours) {
    region.area_mm2 += area_of(contour);
    for (const Vec2& point_mm : contour) {
      region.min_mm = glm::min(region.min_mm, point_mm);
      region.max_mm = glm::max(region.max_mm, point_mm);
    }
  }
}

}  // namespace

SectionRegion within_window(const SectionRegion& region, const simulator::KerfPlane& plane,
                            const FaceWindow& window) {
  std::vector<HalfPlane> halves{half_plane(plane, window.along, window.from_in_bone_mm)};
  if (std::isfinite(window.low_mm))
    halves.push_back(
        half_plane(plane, window.across, window.from_in_bone_mm + window.low_mm * window.across));
  if (std::isfinite(window.high_mm))
    halves.push_back(
        half_plane(plane, -window.across, window.from_in_bone_mm + window.high_mm * window.across));
  SectionRegion kept = region;
  for (const HalfPlane& half : halves) {
    for (Contour& contour : kept.contours) contour = clipped(contour, half);
  }
  std::erase_if(kept.contours, [](const Contour& contour) { return contour.empty(); });
  if (kept.contours.empty()) return {};
  measure(kept);
  return kept;
}

void keep_within(simulator::Section& section, const simulator::KerfPlane& plane,
                 const FaceWindow& window) {
  for (SectionRegion& region : section.regions) region = within_window(region, plane, window);
  std::erase_if(section.regions,
                [](const SectionRegion& region) { return region.contours.empty(); });
}

}  // namespace hallux::scenarios

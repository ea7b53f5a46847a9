/// A kerf's plane on the page: x to the right, y up, and what lies in it as paths.
#pragma once

#include <string>
#include <vector>

#include "simulator/cutting/field/region_outline.h"
#include "simulator/cutting/slice/slab_slice.h"
#include "tests/screenshots/svg_page.h"

namespace hallux::tests {

struct PlaneView {
  Vec2 middle_mm{0.0, 0.0}, middle_px{0.0, 0.0};
  double px_per_mm = 10.0;

  Vec2 page(const Vec2& place_mm) const noexcept {
    const Vec2 from_middle_mm = place_mm - middle_mm;
    return middle_px + px_per_mm * Vec2(from_middle_mm.x, -from_middle_mm.y);
  }
  std::vector<Vec2> pages(const std::vector<Vec2>& places_mm) const;
};

/// The loops of an outline as a path's `d`.
std::string region_path(const PlaneView& view, const simulator::RegionOutline& region);
/// The section's contours on the upper (+1) or lower (-1) plane, edge by edge; closed loops where
/// `kerf` is left out, else only the edges on walls of that kerf.
std::string contour_path(const PlaneView& view, const simulator::SlabSlice& contact, int level,
                         std::int32_t kerf);
/// All contours of a plane as areas, holes taken out by the even-odd rule.
std::string section_path(const PlaneView& view, const simulator::SlabSlice& contact, int level);

/// A blade's rectangle at a pose, counter-clockwise.
std::vector<Vec2> blade_corners_mm(const simulator::Blade& blade,
                                   const simulator::PlanarPose& pose);
/// The convex hull, counter-clockwise.
std::vector<Vec2> hull_of(std::vector<Vec2> places_mm);

}  // namespace hallux::tests

/// Regions made by hand, as loops in a kerf's plane.
#pragma once

#include <vector>

#include "simulator/cutting/field/region_outline.h"

namespace hallux::tests {

using LoopCorners = std::vector<Vec2>;

/// Loops in the order given, as they are.
simulator::RegionOutline outline_from(const std::vector<LoopCorners>& loops_mm);
/// Counter-clockwise.
LoopCorners rectangle_loop(const Vec2& min_mm, const Vec2& max_mm);
/// Counter-clockwise, its corners `reach_mm` from the middle along both axes.
LoopCorners diamond_loop(const Vec2& middle_mm, double reach_mm);
/// The same loop in the other direction: a hole.
LoopCorners turned_back(LoopCorners loop_mm);
/// A region of one rectangle.
simulator::RegionOutline rectangle_outline(const Vec2& min_mm, const Vec2& max_mm);
/// Everything within the reach of the test's fields.
simulator::RegionOutline whole_plane();

/// Whether the point lies in the region and at least `margin_mm` from its outline.
bool is_well_inside(const simulator::RegionOutline& region, const Vec2& point_mm, double margin_mm);

}  // namespace hallux::tests

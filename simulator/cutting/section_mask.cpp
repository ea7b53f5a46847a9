/// Which nodes must be open before a region is covered.
///
/// A cell that no skin of the slab projects onto is wholly bone or wholly outside, at all heights of the slab alike: the
/// section at the middle plane decides. A cell that skin projects onto counts as bone. The corners of all cells that
/// count belong to the region.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "simulator/cutting/plane_slice.h"
#include "simulator/cutting/section.h"

namespace hallux::simulator {

namespace {

constexpr std::size_t most_regions = 32767;

/// The cells of a region's extent, in cells of the grid; cell (i, j) has node (i, j) at its lower corner.
struct CellPatch {
  std::int32_t u_first = 0, v_first = 0, u_count = 0, v_count = 0;
  std::vector<std::uint8_t> is_bone;

  std::uint8_t& at(std::int32_t u, std::int32_t v) noexcept {
    return is_bone[static_cast<std::size_t>(v - v_first) * static_cast<std::size_t>(u_count) +
                   static_cast<std::size_t>(u - u_first)];
  }
};

struct CellRange {
  std::int32_t first = 0, last = 0;
};

Vec2 cells_from(const FieldGrid& grid, const Vec2& place_in_kerf_mm) noexcept {
  return (place_in_kerf_mm - grid.origin_mm) / grid.spacing_mm;
}

/// Cells that [low, high] meets, a hair wider than rounding could make them.
CellRange cells_between(double low, double high) noexcept {
  constexpr double hair = 1.0e-7;
  return {static_cast<std::int32_t>(std::floor(low - hair)),
          static_cast<std::int32_t>(std::floor(high + hair)) + 1};
}

bool fits(const FieldGrid& grid, const SectionRegion& region) noexcept {
  const Vec2 min = cells_from(grid, region.min_mm), max = cells_from(grid, region.max_mm);
  return min.x >= 1.0 && min.y >= 1.0 && max.x <= static_cast<double>(grid.u_count - 2) &&
         max.y <= static_cast<double>(grid.v_count - 2);
}

CellPatch patch_for(const FieldGrid& grid, const SectionRegion& region) {
  const Vec2 min = cells_from(grid, region.min_mm), max = cells_from(grid, region.max_mm);
  const CellRange u = cells_between(min.x, max.x), v = cells_between(min.y, max.y);
  CellPatch patch{u.first, v.first, u.last - u.first, v.last - v.first, {}};
  patch.is_bone.assign(
      static_cast<std::size_t>(patch.u_count) * static_cast<std::size_t>(patch.v_count), 0);
  return patch;
}

/// Marks every cell that a convex polygon meets: per row of cells the polygon's extent within the row.
void mark_polygon(CellPatch& patch, const FieldGrid& grid, const StripPolygon& polygon) {
  std::array<Vec2, 5> corners;
  double v_min = std::numeric_limits<double>::infinity(), v_max = -v_min;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec3& corner_mm = polygon.corners_in_kerf_mm[i];
    corners[i] = cells_from(grid, Vec2(corner_mm.x, corner_mm.y));
    v_min = std::min(v_min, corners[i].y);
    v_max = std::max(v_max, corners[i].y);
  }
  if (polygon.count == 0) return;
  const CellRange rows = cells_between(v_min, v_max);
  for (std::int32_t row = rows.first; row < rows.last; ++row) {
    double u_min = std::numeric_limits<double>::infinity(), u_max = -u_min;
    const auto widen = [&](double u) {
      u_min = std::min(u_min, u);
      u_max = std::max(u_max, u);
    };
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const Vec2 a = corners[i], b = corners[(i + 1) % polygon.count];
      const CellRange own = cells_between(a.y, a.y);
      if (own.first <= row && row < own.last) widen(a.x);
      for (const double border : {static_cast<double>(row), static_cast<double>(row) + 1.0}) {
        if ((a.y < border) == (b.y < border)) continue;
        widen(a.x + (border - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    }
    if (u_min > u_max) continue;
    const CellRange columns = cells_between(u_min, u_max);
    for (std::int32_t u = columns.first; u < columns.last; ++u) patch.at(u, row) = 1;
  }
}

/// Where the contours cross the line through the middles of a row of cells, from left to right.
std::vector<std::vector<double>> crossings_by_row(const CellPatch& patch, const FieldGrid& grid,
                                                  const SectionRegion& region) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(patch.v_count));
  for (const Contour& contour : region.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Vec2 a = cells_from(grid, contour[i]);
      const Vec2 b = cells_from(grid, contour[(i + 1) % contour.size()]);
      const auto first = static_cast<std::int32_t>(std::ceil(std::min(a.y, b.y) - 0.5));
      const auto last = static_cast<std::int32_t>(std::ceil(std::max(a.y, b.y) - 0.5));
      for (std::int32_t row = std::max(first, patch.v_first);
           row < std::min(last, patch.v_first + patch.v_count); ++row) {
        const double middle = static_cast<double>(row) + 0.5;
        crossings[static_cast<std::size_t>(row - patch.v_first)].push_back(
            a.x + (middle - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    }
  }
  for (std::vector<double>& row : crossings) std::sort(row.begin(), row.end());
  return crossings;
}

void mark_inside(CellPatch& patch, const FieldGrid& grid, const SectionRegion& region) {
  const std::vector<std::vector<double>> crossings = crossings_by_row(patch, grid, region);
  for (std::int32_t row = 0; row < patch.v_count; ++row) {
    const std::vector<double>& at = crossings[static_cast<std::size_t>(row)];
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      const auto first = static_cast<std::int32_t>(std::ceil(at[i] - 0.5));
      const auto last = static_cast<std::int32_t>(std::ceil(at[i + 1] - 0.5));
      for (std::int32_t u = std::max(first, patch.u_first);
           u < std::min(last, patch.u_first + patch.u_count); ++u) {
        patch.at(u, patch.v_first + row) = 1;
      }
    }
  }
}

/// Gives the nodes around bone cells to the region; those that another region holds are noted as shared.
void claim_nodes(SectionMask& mask, CellPatch& patch, std::int16_t region) {
  const auto is_bone = [&](std::int32_t u, std::int32_t v) {
    return u >= patch.u_first && v >= patch.v_first && u < patch.u_first + patch.u_count &&
           v < patch.v_first + patch.v_count && patch.at(u, v) != 0;
  };
  for (std::int32_t v = patch.v_first; v <= patch.v_first + patch.v_count; ++v) {
    for (std::int32_t u = patch.u_first; u <= patch.u_first + patch.u_count; ++u) {
      if (!is_bone(u, v) && !is_bone(u - 1, v) && !is_bone(u, v - 1) && !is_bone(u - 1, v - 1)) {
        continue;
      }
      const std::int32_t node = v * mask.grid.u_count + u;
      std::int16_t& holder = mask.region_of_node[static_cast<std::size_t>(node)];
      if (holder >= 0) {
        mask.shared_nodes.push_back({node, region});
        continue;
      }
      holder = region;
      ++mask.node_count[static_cast<std::size_t>(region)];
    }
  }
}

}  // namespace

SectionMask mask_section(const Section& section, const CutSolid& solid, const Bvh&,
                         const FieldGrid& grid) {
  SectionMask mask;
  mask.grid = grid;
  mask.region_of_node.assign(
      static_cast<std::size_t>(grid.u_count) * static_cast<std::size_t>(grid.v_count), -1);
  mask.node_count.assign(section.regions.size(), 0);
  mask.fits_grid.assign(section.regions.size(), 0);
  const KerfAxes axes = axes_of(section.plane);
  const double half_mm = 0.5 * section.plane.thickness_mm;
  const std::size_t count = std::min(section.regions.size(), most_regions);
  for (std::size_t i = 0; i < count; ++i) {
    const SectionRegion& region = section.regions[i];
    if (!fits(grid, region)) continue;
    mask.fits_grid[i] = 1;
    CellPatch patch = patch_for(grid, region);
    for (const std::uint32_t triangle : region.triangles) {
      mark_polygon(patch, grid, strip_polygon(solid.mesh, axes, triangle, half_mm));
    }
    mark_inside(patch, grid, region);
    claim_nodes(mask, patch, static_cast<std::int16_t>(i));
  }
  return mask;
}

}  // namespace hallux::simulator

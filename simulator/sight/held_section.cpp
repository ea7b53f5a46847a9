// The section is filled line by line: along a line of the grid the contours are crossed at places
// that, sorted, lie in pairs around bone. Distances to air and kerf come from two passes over the
// grid with the neighbours' distances (chamfer 1, sqrt 2): a tenth off at most, which no marker
// shows.
#include "simulator/sight/held_section.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace hallux::simulator {

namespace {

/// No section is longer.
constexpr double longest_mm = 120.0;
/// Of a rim that is asked about: so far inside the bone, and so many places for one of the grid.
constexpr double rim_inset_mm = 0.003, rim_steps = 5.0;
/// What stands there is of no more than this.
constexpr double sliver_share = 1.0e-4;

/// Nodes of a kerf's plane, line by line along u.
struct Grid {
  double spacing_mm = held_spacing_mm;
  Vec2 origin_mm{0.0, 0.0};
  std::int32_t u_count = 0, v_count = 0;
};

/// Regions of a section in a grid around them.
struct Filled {
  Grid grid;
  /// Per node the number of its region, from 1; 0 outside the bone.
  std::vector<std::uint8_t> region;
};

std::size_t node_of(const Grid& grid, std::int32_t u, std::int32_t v) {
  return static_cast<std::size_t>(u) * static_cast<std::size_t>(grid.v_count) +
         static_cast<std::size_t>(v);
}

Vec2 place_of(const Grid& grid, std::int32_t u, std::int32_t v) {
  return grid.origin_mm + grid.spacing_mm * Vec2(u, v);
}

Grid grid_around(const Section& section, double spacing_mm) {
  Vec2 low = section.regions.front().min_mm, high = section.regions.front().max_mm;
  for (const SectionRegion& region : section.regions) {
    low = glm::min(low, region.min_mm);
    high = glm::max(high, region.max_mm);
  }
  Grid grid;
  grid.spacing_mm = spacing_mm;
  // Middles of cells: no node lies on an edge.
  grid.origin_mm = low + Vec2(0.5 * spacing_mm, 0.5 * spacing_mm);
  const auto count = [&](double length_mm) {
    return static_cast<std::int32_t>(std::min(length_mm, longest_mm) / spacing_mm) + 1;
  };
  grid.u_count = count(high.x - low.x);
  grid.v_count = count(high.y - low.y);
  return grid;
}

/// Where the line x = x_mm crosses the contours, ascending.
void crossings_at(double x_mm, const SectionRegion& region, std::vector<double>& crossings) {
  crossings.clear();
  for (const Contour& contour : region.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Vec2 &a = contour[i], &b = contour[(i + 1) % contour.size()];
      if ((a.x <= x_mm) == (b.x <= x_mm)) continue;
      crossings.push_back(a.y + (x_mm - a.x) / (b.x - a.x) * (b.y - a.y));
    }
  }
  std::sort(crossings.begin(), crossings.end());
}

void fill_region(Filled& filled, const SectionRegion& region, std::uint8_t number) {
  std::vector<double> crossings;
  const Grid& grid = filled.grid;
  for (std::int32_t u = 0; u < grid.u_count; ++u) {
    crossings_at(place_of(grid, u, 0).x, region, crossings);
    for (std::size_t pair = 0; pair + 1 < crossings.size(); pair += 2) {
      const double first = (crossings[pair] - grid.origin_mm.y) / grid.spacing_mm;
      const double last = (crossings[pair + 1] - grid.origin_mm.y) / grid.spacing_mm;
      const auto from = std::max<std::int32_t>(0, static_cast<std::int32_t>(std::ceil(first)));
      for (std::int32_t v = from; v < grid.v_count && v <= last; ++v)
        filled.region[node_of(grid, u, v)] = number;
    }
  }
}

Filled fill(const Section& section, double spacing_mm) {
  Filled filled{grid_around(section, spacing_mm), {}};
  const auto nodes =
      static_cast<std::size_t>(filled.grid.u_count) * static_cast<std::size_t>(filled.grid.v_count);
  filled.region.assign(nodes, 0);
  constexpr std::size_t regions_at_most = 255;
  const std::size_t count = std::min(section.regions.size(), regions_at_most);
  for (std::size_t i = 0; i < count; ++i)
    fill_region(filled, section.regions[i], static_cast<std::uint8_t>(i + 1));
  return filled;
}

/// Asks for each node of bone whether some kerf has opened it.
class OpenedNodes {
 public:
  OpenedNodes(const FragmentKerfs& kerfs, std::int32_t kerf)
      : kerfs_(kerfs), kerf_(kerf), bone_from_kerf_(kerfs.plane(kerf).bone_from_kerf) {}

  bool is_open(const Vec2& place_mm) const noexcept {
    if (kerfs_.field(kerf_).is_open(place_mm)) return true;
    return kerfs_.numbers().count() > 1 &&
           kerfs_.is_open(transform_point(bone_from_kerf_, Vec3(place_mm, 0.0)));
  }

 private:
  FragmentKerfs kerfs_;
  std::int32_t kerf_;
  RigidTransform bone_from_kerf_;
};

/// Sums over nodes.
struct Sum {
  double count = 0.0;
  Vec2 places_mm{0.0, 0.0};

  void add(const Vec2& place_mm) noexcept {
    count += 1.0;
    places_mm += place_mm;
  }
  Vec2 middle_mm() const noexcept { return count > 0.0 ? places_mm / count : places_mm; }
};

/// Visits the nodes of bone that are asked about.
template <typename Visit>
void visit_asked(const Filled& filled, const std::vector<bool>& is_asked,
                 const std::optional<PlaneLimit>& limit, Visit&& visit) {
  for (std::int32_t u = 0; u < filled.grid.u_count; ++u) {
    for (std::int32_t v = 0; v < filled.grid.v_count; ++v) {
      const std::size_t node = node_of(filled.grid, u, v);
      const std::uint8_t region = filled.region[node];
      if (region == 0 || !is_asked[region]) continue;
      const Vec2 place_mm = place_of(filled.grid, u, v);
      if (limit && glm::dot(limit->outward, place_mm) > limit->limit_mm) continue;
      visit(node, place_mm, region);
    }
  }
}

/// The regions that the blade has touched, by number; the largest where it touched none.
std::vector<bool> touched_regions(const Filled& filled, std::size_t count, const KerfField& field) {
  std::vector<bool> is_touched(count + 1, false);
  visit_asked(filled, std::vector<bool>(count + 1, true), {},
              [&](std::size_t, const Vec2& place_mm, std::uint8_t region) {
                if (!is_touched[region] && field.is_open(place_mm)) is_touched[region] = true;
              });
  if (std::find(is_touched.begin(), is_touched.end(), true) == is_touched.end())
    is_touched[1] = true;
  return is_touched;
}

/// The distance of each node to the nearest that does not stand, in nodes.
std::vector<float> depths(const Grid& grid, const std::vector<std::uint8_t>& stands) {
  constexpr float far_away = 1.0e6F, straight = 1.0F, aslant = 1.4142135F;
  std::vector<float> depth(stands.size());
  const auto at = [&](std::int32_t u, std::int32_t v) {
    const bool is_inside = u >= 0 && v >= 0 && u < grid.u_count && v < grid.v_count;
    return is_inside ? depth[node_of(grid, u, v)] : 0.0F;
  };
  for (std::size_t node = 0; node < depth.size(); ++node)
    depth[node] = stands[node] != 0 ? far_away : 0.0F;
  const auto relax = [&](std::int32_t u, std::int32_t v, std::int32_t step) {
    float& here = depth[node_of(grid, u, v)];
    here = std::min({here, at(u - step, v) + straight, at(u, v - step) + straight,
                     at(u - step, v - step) + aslant, at(u - step, v + step) + aslant});
  };
  for (std::int32_t u = 0; u < grid.u_count; ++u)
    for (std::int32_t v = 0; v < grid.v_count; ++v) relax(u, v, 1);
  for (std::int32_t u = grid.u_count - 1; u >= 0; --u)
    for (std::int32_t v = grid.v_count - 1; v >= 0; --v) relax(u, v, -1);
  return depth;
}

void find_deepest(HeldSection& held, const Grid& grid, const std::vector<std::uint8_t>& stands) {
  const std::vector<float> depth = depths(grid, stands);
  const auto deepest = std::max_element(depth.begin(), depth.end());
  if (deepest == depth.end() || *deepest == 0.0F) return;
  const auto node = static_cast<std::int32_t>(deepest - depth.begin());
  held.deepest_mm = place_of(grid, node / grid.v_count, node % grid.v_count);
  held.depth_mm = grid.spacing_mm * static_cast<double>(*deepest);
}

/// A sliver along the rim lies between the nodes: the first place just inside a contour of these
/// regions that stands.
template <typename IsOpen>
std::optional<Vec2> standing_on_rim(const Section& section, const std::vector<bool>& is_asked,
                                    const std::optional<PlaneLimit>& limit, double step_mm,
                                    const IsOpen& is_open) {
  for (std::size_t region = 0; region < section.regions.size(); ++region) {
    if (!is_asked[region + 1]) continue;
    for (const Contour& contour : section.regions[region].contours) {
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const Vec2 from_mm = contour[i], way_mm = contour[(i + 1) % contour.size()] - from_mm;
        const double length_mm = glm::length(way_mm);
        if (!(length_mm > 0.0)) continue;
        const Vec2 inward = Vec2(-way_mm.y, way_mm.x) / length_mm;
        for (double along_mm = 0.0; along_mm < length_mm; along_mm += step_mm) {
          const Vec2 place_mm = from_mm + along_mm / length_mm * way_mm + rim_inset_mm * inward;
          if (limit && glm::dot(limit->outward, place_mm) > limit->limit_mm) continue;
          if (!is_open(place_mm)) return place_mm;
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace

HeldSection held_section(const Section& section, const FragmentKerfs& kerfs, std::int32_t kerf,
                         const std::optional<PlaneLimit>& limit, double spacing_mm) {
  HeldSection held;
  if (section.regions.empty()) return held;
  const Filled filled = fill(section, spacing_mm);
  const std::vector<bool> is_asked =
      touched_regions(filled, section.regions.size(), kerfs.field(kerf));
  const OpenedNodes opened(kerfs, kerf);
  std::vector<std::uint8_t> stands(filled.region.size(), 0);
  Sum asked, standing;
  visit_asked(filled, is_asked, limit,
              [&](std::size_t node, const Vec2& place_mm, std::uint8_t /*region*/) {
                asked.add(place_mm);
                if (opened.is_open(place_mm)) return;
                stands[node] = 1;
                standing.add(place_mm);
              });
  held.share = asked.count > 0.0 ? standing.count / asked.count : 0.0;
  held.section_middle_mm = asked.middle_mm();
  held.middle_mm = standing.middle_mm();
  for (std::size_t region = 0; region < section.regions.size(); ++region)
    if (is_asked[region + 1]) held.regions.push_back(region);
  find_deepest(held, filled.grid, stands);
  if (standing.count > 0.0 || asked.count == 0.0) return held;
  const auto sliver_mm =
      standing_on_rim(section, is_asked, limit, spacing_mm / rim_steps,
                      [&](const Vec2& place_mm) { return opened.is_open(place_mm); });
  if (sliver_mm) {
    held.share = sliver_share;
    held.middle_mm = held.deepest_mm = *sliver_mm;
  }
  return held;
}

}  // namespace hallux::simulator

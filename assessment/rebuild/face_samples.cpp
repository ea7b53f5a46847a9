/// A face is sampled on one grid in the plane of its kerf, heights above it read off the triangles:
/// each point stands for the same area, however the mesh is divided. Where few points fall on it
/// the step is halved.
///
///     row of a region   |....bone....|  gap  |..bone..|      counted outward from the entry, bone
///                       ooooooooooo                          only, until another kerf is met
#include "assessment/rebuild/face_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace hallux::assessment {

namespace {

using simulator::Contour;
using simulator::CutSolid;
using simulator::KerfPlane;
using simulator::SectionRegion;

constexpr double finest_step_mm = 0.05;
/// Points on an edge belong to both triangles; the grid keeps one of them.
constexpr double edge_tolerance = 1.0e-9;

struct GridWindow {
  std::int64_t u_first, u_last, v_first, v_last;  ///< both ends included
};

GridWindow window_of(const Vec2& min_mm, const Vec2& max_mm, double step_mm) noexcept {
  return {static_cast<std::int64_t>(std::ceil(min_mm.x / step_mm)),
          static_cast<std::int64_t>(std::floor(max_mm.x / step_mm)),
          static_cast<std::int64_t>(std::ceil(min_mm.y / step_mm)),
          static_cast<std::int64_t>(std::floor(max_mm.y / step_mm))};
}

using Heights = std::map<std::pair<std::int64_t, std::int64_t>, double>;
using LocalTriangle = std::array<Vec3, 3>;

/// The heights of a triangle over the grid points that it covers, by barycentric coordinates.
void add_heights(Heights& heights, const LocalTriangle& corners, double step_mm) {
  const auto [a, b, c] = corners;
  const double twice_area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (twice_area == 0.0) return;
  const Vec2 min_mm{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
  const Vec2 max_mm{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
  const GridWindow window = window_of(min_mm, max_mm, step_mm);
  for (std::int64_t u = window.u_first; u <= window.u_last; ++u) {
    for (std::int64_t v = window.v_first; v <= window.v_last; ++v) {
      const double x = static_cast<double>(u) * step_mm, y = static_cast<double>(v) * step_mm;
      const double of_b = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / twice_area;
      const double of_c = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / twice_area;
      const double of_a = 1.0 - of_b - of_c;
      if (std::min({of_a, of_b, of_c}) < -edge_tolerance) continue;
      heights.try_emplace({u, v}, of_a * a.z + of_b * b.z + of_c * c.z);
    }
  }
}

bool is_inside(const Heights& heights, const std::pair<std::int64_t, std::int64_t>& node) {
  for (const std::int64_t u : {-1, 0, 1}) {
    for (const std::int64_t v : {-1, 0, 1}) {
      if (!heights.contains({node.first + u, node.second + v})) return false;
    }
  }
  return true;
}

double border_share(const Heights& heights) {
  if (heights.empty()) return 0.0;
  const auto border = std::count_if(heights.begin(), heights.end(), [&](const auto& each) {
    return !is_inside(heights, each.first);
  });
  return static_cast<double>(border) / static_cast<double>(heights.size());
}

FaceSamples samples_from(const Heights& heights, const KerfPlane& plane, double step_mm) {
  FaceSamples samples;
  samples.step_mm = step_mm;
  samples.border_share = border_share(heights);
  for (const auto& [node, height_mm] : heights) {
    const Vec3 local{static_cast<double>(node.first) * step_mm,
                     static_cast<double>(node.second) * step_mm, height_mm};
    samples.points_in_bone_mm.push_back(transform_point(plane.bone_from_kerf, local));
  }
  samples.area_mm2 = static_cast<double>(heights.size()) * step_mm * step_mm;
  return samples;
}

/// Halves the step until there are enough samples.
FaceSamples sample_finely(const KerfPlane& plane, double step_mm,
                          const std::function<Heights(double step_mm)>& heights_at) {
  Heights heights = heights_at(step_mm);
  while (!heights.empty() && heights.size() < samples_wanted && 0.5 * step_mm >= finest_step_mm) {
    step_mm *= 0.5;
    heights = heights_at(step_mm);
  }
  return samples_from(heights, plane, step_mm);
}

/// By the parity of crossings over all contours: holes lie in outer ones.
bool contains(const SectionRegion& region, const Vec2& point_mm) noexcept {
  bool is_inside = false;
  for (const Contour& contour : region.contours) {
    for (std::size_t index = 0; index < contour.size(); ++index) {
      const Vec2& a = contour[index];
      const Vec2& b = contour[(index + 1) % contour.size()];
      if ((a.y > point_mm.y) == (b.y > point_mm.y)) continue;
      const double x = a.x + (point_mm.y - a.y) / (b.y - a.y) * (b.x - a.x);
      if (point_mm.x < x) is_inside = !is_inside;
    }
  }
  return is_inside;
}

void add_opened(Heights& heights, const SectionRegion& region, const simulator::KerfField& field,
                double height_mm, double step_mm) {
  const GridWindow window = window_of(region.min_mm, region.max_mm, step_mm);
  for (std::int64_t u = window.u_first; u <= window.u_last; ++u) {
    for (std::int64_t v = window.v_first; v <= window.v_last; ++v) {
      const Vec2 point_mm{static_cast<double>(u) * step_mm, static_cast<double>(v) * step_mm};
      if (field.is_open(point_mm) && contains(region, point_mm)) heights[{u, v}] = height_mm;
    }
  }
}

/// Finer than the samples of a face: a strip that is left must show.
constexpr double window_step_mm = 0.1;

struct WindowCount {
  std::int64_t wanted = 0, open = 0;
};

/// Where contours cross the row at v, ascending: bone lies between the first and the second, and so
/// on.
std::vector<double> bone_borders_mm(const SectionRegion& region, double v_mm) {
  std::vector<double> borders_mm;
  for (const Contour& contour : region.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Vec2 &a = contour[i], &b = contour[(i + 1) % contour.size()];
      if ((a.y > v_mm) == (b.y > v_mm)) continue;
      borders_mm.push_back(a.x + (v_mm - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  }
  std::sort(borders_mm.begin(), borders_mm.end());
  return borders_mm;
}

/// Calls visit(borders, v) for each row of a grid over the regions that the blade touched.
template <typename Visit>
void for_each_row(const RebuiltKerf& kerf, double step_mm, Visit&& visit) {
  for (std::size_t index = 0; index < kerf.section.regions.size(); ++index) {
    if (kerf.is_touched[index] == 0) continue;
    const SectionRegion& region = kerf.section.regions[index];
    const GridWindow grid = window_of(region.min_mm, region.max_mm, step_mm);
    for (std::int64_t v = grid.v_first; v <= grid.v_last; ++v) {
      const double v_mm = static_cast<double>(v) * step_mm;
      visit(bone_borders_mm(region, v_mm), v_mm);
    }
  }
}

/// The grid points of one row from border to border of the region, in the order in which they lie
/// outward.
std::vector<Vec2> outward_row(const std::vector<double>& borders_mm, double v_mm,
                              bool is_reversed) {
  std::vector<Vec2> row;
  if (borders_mm.empty()) return row;
  const GridWindow grid =
      window_of(Vec2{borders_mm.front(), v_mm}, Vec2{borders_mm.back(), v_mm}, window_step_mm);
  for (std::int64_t u = grid.u_first; u <= grid.u_last; ++u) {
    row.emplace_back(static_cast<double>(u) * window_step_mm, v_mm);
  }
  if (is_reversed) std::reverse(row.begin(), row.end());
  return row;
}

/// Walks one row of a region outward, until it meets another kerf.
template <typename IsWanted>
void count_row(WindowCount& count, const RebuiltBone& rebuilt, std::int32_t index,
               const std::vector<double>& borders_mm, const std::vector<Vec2>& row,
               const IsWanted& is_wanted) {
  const KerfPlane& plane = rebuilt.fields.plane(index);
  const std::size_t bone = bone_of(rebuilt, index);
  for (const Vec2& place_mm : row) {
    const Vec3 point_mm = transform_point(plane.bone_from_kerf, Vec3{place_mm.x, place_mm.y, 0.0});
    if (kerf_open_at(rebuilt, bone, point_mm, index) >= 0) return;
    if (!is_wanted(point_mm)) continue;
    const auto above = std::upper_bound(borders_mm.begin(), borders_mm.end(), place_mm.x);
    const bool is_bone = (above - borders_mm.begin()) % 2 != 0;
    if (!is_bone) continue;
    ++count.wanted;
    if (rebuilt.fields.field(index).is_open(place_mm)) ++count.open;
  }
}

/// The open points of one row from border to border, on both walls of the kerf.
void add_opened_row(std::vector<Vec3>& points_mm, const KerfPlane& plane,
                    const simulator::KerfField& field, const Vec2& borders_mm, double v_mm,
                    double step_mm) {
  const double half_mm = 0.5 * plane.thickness_mm;
  const GridWindow grid = window_of(Vec2{borders_mm.x, v_mm}, Vec2{borders_mm.y, v_mm}, step_mm);
  for (std::int64_t u = grid.u_first; u <= grid.u_last; ++u) {
    const Vec2 place_mm{static_cast<double>(u) * step_mm, v_mm};
    if (!field.is_open(place_mm)) continue;
    for (const double height_mm : {-half_mm, half_mm})
      points_mm.push_back(transform_point(plane.bone_from_kerf, Vec3{place_mm, height_mm}));
  }
}

/// is_reversed  rows are walked against the kerf's x
template <typename IsWanted>
double opened_share_of(const RebuiltBone& rebuilt, std::int32_t index, bool is_reversed,
                       const IsWanted& is_wanted) {
  const RebuiltKerf& kerf = rebuilt.kerfs[static_cast<std::size_t>(index)];
  WindowCount count;
  for_each_row(kerf, window_step_mm, [&](const std::vector<double>& borders_mm, double v_mm) {
    count_row(count, rebuilt, index, borders_mm, outward_row(borders_mm, v_mm, is_reversed),
              is_wanted);
  });
  if (count.wanted == 0) return 0.0;
  return static_cast<double>(count.open) / static_cast<double>(count.wanted);
}

}  // namespace

std::int32_t kerf_open_at(const RebuiltBone& rebuilt, std::size_t bone, const Vec3& point_mm,
                          std::int32_t but_for) {
  for (std::int32_t kerf = 0; kerf < rebuilt.fields.count(); ++kerf) {
    if (kerf == but_for || bone_of(rebuilt, kerf) != bone) continue;
    const Vec3 local = transform_point(rebuilt.fields.kerf_from_bone(kerf), point_mm);
    const double half_mm = 0.5 * rebuilt.fields.plane(kerf).thickness_mm;
    if (std::abs(local.z) > half_mm) continue;
    if (rebuilt.fields.field(kerf).is_open(Vec2{local.x, local.y})) return kerf;
  }
  return -1;
}

double opened_share(const RebuiltBone& rebuilt, std::int32_t index,
                    const scenarios::PlannedWindow& window) {
  const Vec3 feed =
      transform_direction(rebuilt.fields.plane(index).bone_from_kerf, {1.0, 0.0, 0.0});
  return opened_share_of(
      rebuilt, index, glm::dot(feed, window.outward) < 0.0,
      [&](const Vec3& point_mm) { return glm::dot(window.outward, point_mm) <= window.limit_mm; });
}

double opened_share(const RebuiltBone& rebuilt, std::int32_t index,
                    const scenarios::FaceWindow& window) {
  return opened_share_of(rebuilt, index, false, [&](const Vec3& point_mm) {
    return scenarios::lies_within(window, point_mm);
  });
}

FaceSamples sample_wall(const CutSolid& piece, const simulator::FaceSource& wall,
                        const KerfPlane& plane, double step_mm) {
  const RigidTransform kerf_from_bone = inverse(plane.bone_from_kerf);
  std::vector<LocalTriangle> triangles;
  for (std::size_t index = 0; index < piece.sources.size(); ++index) {
    if (!(piece.sources[index] == wall)) continue;
    LocalTriangle corners{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3& point = piece.mesh.points_mm[piece.mesh.triangles[index][corner]];
      corners[corner] = transform_point(kerf_from_bone, point);
    }
    triangles.push_back(corners);
  }
  return sample_finely(plane, step_mm, [&](double finer_mm) {
    Heights heights;
    for (const LocalTriangle& corners : triangles) add_heights(heights, corners, finer_mm);
    return heights;
  });
}

FaceSamples sample_opened(const RebuiltKerf& kerf, const simulator::KerfField& field,
                          std::int32_t side) {
  const double height_mm = 0.5 * kerf.section.plane.thickness_mm * side;
  return sample_finely(kerf.section.plane, sample_step_mm, [&](double step_mm) {
    Heights heights;
    for (std::size_t region = 0; region < kerf.section.regions.size(); ++region) {
      if (kerf.is_touched[region] == 0) continue;
      add_opened(heights, kerf.section.regions[region], field, height_mm, step_mm);
    }
    return heights;
  });
}

std::vector<Vec3> points_opened(const RebuiltKerf& kerf, const simulator::KerfField& field,
                                double step_mm) {
  const KerfPlane& plane = kerf.section.plane;
  std::vector<Vec3> points_mm;
  for_each_row(kerf, step_mm, [&](const std::vector<double>& borders_mm, double v_mm) {
    for (std::size_t border = 0; border + 1 < borders_mm.size(); border += 2) {
      add_opened_row(points_mm, plane, field, {borders_mm[border], borders_mm[border + 1]}, v_mm,
                     step_mm);
    }
  });
  return points_mm;
}

}  // namespace hallux::assessment

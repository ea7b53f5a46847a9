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

FaceSamples samples_from(const Heights& heights, const KerfPlane& plane, double step_mm) {
  FaceSamples samples;
  for (const auto& [node, height_mm] : heights) {
    const Vec3 local{static_cast<double>(node.first) * step_mm,
                     static_cast<double>(node.second) * step_mm, height_mm};
    samples.points_in_bone_mm.push_back(transform_point(plane.bone_from_kerf, local));
  }
  samples.area_mm2 = static_cast<double>(heights.size()) * step_mm * step_mm;
  return samples;
}

/// Halves the step until there are enough samples.
FaceSamples sample_finely(const KerfPlane& plane,
                          const std::function<Heights(double step_mm)>& heights_at) {
  double step_mm = sample_step_mm;
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

}  // namespace

FaceSamples sample_wall(const CutSolid& piece, const simulator::FaceOrigin& wall,
                        const KerfPlane& plane) {
  const RigidTransform kerf_from_bone = inverse(plane.bone_from_kerf);
  std::vector<LocalTriangle> triangles;
  for (std::size_t index = 0; index < piece.origins.size(); ++index) {
    if (!(piece.origins[index] == wall)) continue;
    LocalTriangle corners{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3& point = piece.mesh.points_mm[piece.mesh.triangles[index][corner]];
      corners[corner] = transform_point(kerf_from_bone, point);
    }
    triangles.push_back(corners);
  }
  return sample_finely(plane, [&](double step_mm) {
    Heights heights;
    for (const LocalTriangle& corners : triangles) add_heights(heights, corners, step_mm);
    return heights;
  });
}

FaceSamples sample_opened(const RebuiltKerf& kerf, const simulator::KerfField& field,
                          std::int32_t side) {
  const KerfPlane& plane = kerf.section.plane;
  const double height_mm = 0.5 * plane.thickness_mm * side;
  return sample_finely(plane, [&](double step_mm) {
    Heights heights;
    for (std::size_t region = 0; region < kerf.section.regions.size(); ++region) {
      if (kerf.is_touched[region] == 0) continue;
      add_opened(heights, kerf.section.regions[region], field, height_mm, step_mm);
    }
    return heights;
  });
}

}  // namespace hallux::assessment

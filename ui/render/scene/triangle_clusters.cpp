#include "ui/render/scene/triangle_clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hallux::ui {

namespace {

constexpr double steps_along_axis = 1023.0;

/// Ten bits drawn out, so that two more numbers fit between them.
std::uint32_t spread(std::uint32_t bits) noexcept {
  bits = (bits | (bits << 16U)) & 0x030000ffU;
  bits = (bits | (bits << 8U)) & 0x0300f00fU;
  bits = (bits | (bits << 4U)) & 0x030c30c3U;
  return (bits | (bits << 2U)) & 0x09249249U;
}

std::uint32_t morton_code(const Vec3& steps) noexcept {
  return spread(static_cast<std::uint32_t>(steps.x)) |
         (spread(static_cast<std::uint32_t>(steps.y)) << 1U) |
         (spread(static_cast<std::uint32_t>(steps.z)) << 2U);
}

glm::dvec4 row(const DoubleMatrix4& matrix, int index) noexcept {
  return {matrix[0][index], matrix[1][index], matrix[2][index], matrix[3][index]};
}

}  // namespace

std::vector<std::uint32_t> order_by_place(std::span<const Vec3> places_mm) {
  Box box;
  for (const Vec3& place_mm : places_mm) box.add(place_mm);
  const Vec3 steps_per_mm = steps_along_axis / glm::max(box.high_mm - box.low_mm, Vec3(1e-9));
  std::vector<std::uint32_t> codes, order(places_mm.size());
  codes.reserve(places_mm.size());
  for (const Vec3& place_mm : places_mm) {
    codes.push_back(morton_code((place_mm - box.low_mm) * steps_per_mm));
  }
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return codes[a] < codes[b]; });
  return order;
}

Frustum frustum_through(const DoubleMatrix4& clip_from_frame, const Vec2& low,
                        const Vec2& high) noexcept {
  const glm::dvec4 x = row(clip_from_frame, 0), y = row(clip_from_frame, 1),
                   w = row(clip_from_frame, 3);
  return {{{x - (2.0 * low.x - 1.0) * w, (2.0 * high.x - 1.0) * w - x, y - (2.0 * low.y - 1.0) * w,
            (2.0 * high.y - 1.0) * w - y}},
          std::nullopt};
}

bool may_be_seen(const Frustum& frustum, const Box& box) noexcept {
  return std::all_of(frustum.planes.begin(), frustum.planes.end(), [&](const glm::dvec4& plane) {
    const Vec3 furthest(plane.x > 0.0 ? box.high_mm.x : box.low_mm.x,
                        plane.y > 0.0 ? box.high_mm.y : box.low_mm.y,
                        plane.z > 0.0 ? box.high_mm.z : box.low_mm.z);
    return glm::dot(Vec3(plane), furthest) + plane.w >= 0.0;
  });
}

NormalCone cone_around(std::span<const Vec3> normals) noexcept {
  Vec3 sum(0.0);
  for (const Vec3& normal : normals) sum += normal;
  const double length = glm::length(sum);
  if (length < 1e-9) return {};
  NormalCone cone{sum / length, 0.0};
  double least_cosine = 1.0;
  for (const Vec3& normal : normals) {
    if (normal != Vec3(0.0)) least_cosine = std::min(least_cosine, glm::dot(normal, cone.axis));
  }
  cone.sine = least_cosine <= 0.0 ? 1.0 : std::sqrt(1.0 - least_cosine * least_cosine);
  return cone;
}

bool faces_away(const TriangleCluster& cluster, const Vec3& eye_mm) noexcept {
  if (cluster.normals.sine >= 1.0) return false;
  const Vec3 middle_mm = 0.5 * (cluster.box.low_mm + cluster.box.high_mm);
  const double radius_mm = glm::distance(middle_mm, cluster.box.high_mm);
  const Vec3 sight_mm = middle_mm - eye_mm;
  return glm::dot(sight_mm, cluster.normals.axis) >
         cluster.normals.sine * glm::length(sight_mm) + radius_mm;
}

void find_seen(std::span<const TriangleCluster> clusters, const Frustum& frustum,
               std::vector<TriangleRun>& runs) {
  runs.clear();
  for (const TriangleCluster& cluster : clusters) {
    if (!may_be_seen(frustum, cluster.box)) continue;
    if (frustum.eye_mm && faces_away(cluster, *frustum.eye_mm)) continue;
    if (!runs.empty() && runs.back().first + runs.back().count == cluster.run.first) {
      runs.back().count += cluster.run.count;
    } else {
      runs.push_back(cluster.run);
    }
  }
}

}  // namespace hallux::ui

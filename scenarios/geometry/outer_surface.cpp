#include "scenarios/geometry/outer_surface.h"

#include <array>
#include <cmath>

namespace hallux::scenarios {
namespace {

/// Of a triangle's own size: an edge belongs to both of its triangles, so that no ray slips
/// between them.
constexpr double edge_share = 1.0e-9;

/// How far along the ray the triangle lies; nothing where it passes by (Moeller and Trumbore 1997).
std::optional<double> hit_mm(const std::array<Vec3, 3>& corner_mm, const Vec3& from_mm,
                             const Vec3& direction) {
  const Vec3 u = corner_mm[1] - corner_mm[0], v = corner_mm[2] - corner_mm[0];
  const Vec3 across = glm::cross(direction, v);
  const double size = glm::dot(u, across);
  if (size == 0.0) return std::nullopt;
  const Vec3 way = from_mm - corner_mm[0];
  const double share_u = glm::dot(way, across) / size;
  const Vec3 turned = glm::cross(way, u);
  const double share_v = glm::dot(direction, turned) / size;
  if (share_u < -edge_share || share_v < -edge_share || share_u + share_v > 1.0 + edge_share)
    return std::nullopt;
  const double along_mm = glm::dot(v, turned) / size;
  return along_mm >= 0.0 ? std::optional(along_mm) : std::nullopt;
}

}  // namespace

std::optional<Vec3> last_on_ray(const simulator::IndexedMesh& mesh, const Vec3& from_mm,
                                const Vec3& direction) {
  std::optional<double> last_mm;
  for (std::size_t index = 0; index < mesh.triangles.size(); ++index) {
    const std::optional<double> along_mm =
        hit_mm(simulator::corners_of(mesh, index), from_mm, direction);
    if (along_mm && (!last_mm || *along_mm > *last_mm)) last_mm = along_mm;
  }
  if (!last_mm) return std::nullopt;
  return from_mm + *last_mm * direction;
}

}  // namespace hallux::scenarios

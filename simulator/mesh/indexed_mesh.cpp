#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

double signed_volume_mm3(const IndexedMesh& mesh) noexcept {
  if (mesh.points_mm.empty()) return 0.0;
  // From a point of the mesh: far from the origin the tetrahedra would be large and cancel.
  const Vec3 apex_mm = mesh.points_mm.front();
  double six_volumes_mm3 = 0.0;
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const auto [a, b, c] = corners_of(mesh, triangle);
    six_volumes_mm3 += glm::dot(a - apex_mm, glm::cross(b - apex_mm, c - apex_mm));
  }
  return six_volumes_mm3 / 6.0;
}

Digest digest_of_mesh(const IndexedMesh& mesh) noexcept {
  Digester digester;
  digester.add_int(static_cast<std::int64_t>(mesh.points_mm.size()));
  for (const Vec3& point : mesh.points_mm) {
    digester.add_double(point.x);
    digester.add_double(point.y);
    digester.add_double(point.z);
  }
  digester.add_int(static_cast<std::int64_t>(mesh.triangles.size()));
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) digester.add_int(index);
  }
  return digester.finish();
}

void append_mesh(IndexedMesh& mesh, const IndexedMesh& added) {
  const auto shift = static_cast<std::uint32_t>(mesh.points_mm.size());
  mesh.points_mm.insert(mesh.points_mm.end(), added.points_mm.begin(), added.points_mm.end());
  mesh.triangles.reserve(mesh.triangles.size() + added.triangles.size());
  for (const Triangle& triangle : added.triangles) {
    mesh.triangles.push_back({triangle[0] + shift, triangle[1] + shift, triangle[2] + shift});
  }
}

}  // namespace hallux::simulator

#include "tests/ui/render/scene/tool_mesh_checks.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace hallux::tests {

namespace {

using namespace ui;

using Place = std::array<long, 3>;

/// Points nearer than a ten-thousandth of a millimetre are one.
Place place_of(const ToolVertex& vertex) {
  const auto cell = [](float at) { return std::lround(at * 1.0e4F); };
  return {cell(vertex.point_in_tool_mm.x), cell(vertex.point_in_tool_mm.y),
          cell(vertex.point_in_tool_mm.z)};
}

/// How often each edge is run in that direction.
std::map<std::pair<Place, Place>, int> edges_of(const ToolMesh& mesh) {
  std::map<std::pair<Place, Place>, int> edges;
  for (const simulator::Triangle& triangle : mesh.triangles) {
    std::array<Place, 3> places;
    for (std::size_t i = 0; i < 3; ++i) places[i] = place_of(mesh.vertices[triangle[i]]);
    if (places[0] == places[1] || places[1] == places[2] || places[2] == places[0]) continue;
    for (std::size_t i = 0; i < 3; ++i) ++edges[{places[i], places[(i + 1) % 3]}];
  }
  return edges;
}

std::string normals_flaw(const ToolMesh& mesh) {
  double volume_mm3 = 0.0;
  for (const simulator::Triangle& triangle : mesh.triangles) {
    std::array<Vec3, 3> points_mm;
    for (std::size_t i = 0; i < 3; ++i)
      points_mm[i] = Vec3(mesh.vertices[triangle[i]].point_in_tool_mm);
    const Vec3 normal = glm::cross(points_mm[1] - points_mm[0], points_mm[2] - points_mm[0]);
    volume_mm3 += glm::dot(points_mm[0], glm::cross(points_mm[1], points_mm[2])) / 6.0;
    for (const std::uint32_t corner : triangle) {
      const Vec3 said(mesh.vertices[corner].normal);
      if (std::abs(glm::length(said) - 1.0) > 1.0e-4) return "a normal is not of length 1";
      // Slivers have a direction by rounding only.
      if (glm::length(normal) > 1.0e-4 && glm::dot(said, normal) <= 0.0)
        return "a normal leans away from its triangle at x = " + std::to_string(points_mm[0].x);
    }
  }
  return volume_mm3 > 0.0 ? "" : "inside out";
}

}  // namespace

std::string flaw_of(const ToolMesh& mesh, std::size_t most) {
  if (mesh.triangles.empty()) return "empty";
  if (mesh.triangles.size() >= most) return std::to_string(mesh.triangles.size()) + " triangles";
  const auto edges = edges_of(mesh);
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (back == edges.end() || back->second != count)
      return "open at x = " + std::to_string(static_cast<double>(edge.first[0]) * 1.0e-4);
  }
  return normals_flaw(mesh);
}

}  // namespace hallux::tests

#include "scenarios/faces/face_section.h"

#include <array>
#include <utility>

namespace hallux::scenarios {
namespace {

/// Where the face crosses this edge; nothing where it does not.
std::optional<Vec3> crossing(const ReferenceFace& face, const Vec3& from, const Vec3& to) {
  const double from_mm = glm::dot(face.normal, from) - face.offset_mm;
  const double to_mm = glm::dot(face.normal, to) - face.offset_mm;
  if ((from_mm > 0.0) == (to_mm > 0.0)) return std::nullopt;
  return from + from_mm / (from_mm - to_mm) * (to - from);
}

void keep_further(std::optional<Vec3>& furthest, const Vec3& point, const Vec3& direction) {
  if (!furthest || glm::dot(direction, point) > glm::dot(direction, *furthest)) furthest = point;
}

/// A triangle's part of the section.
struct Line {
  Vec3 from, to;
};

std::optional<Line> line_in(const ReferenceFace& face, const std::array<Vec3, 3>& corner_mm) {
  std::optional<Vec3> first;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const auto point = crossing(face, corner_mm[corner], corner_mm[(corner + 1) % 3]);
    if (!point) continue;
    if (first) return Line{*first, *point};
    first = point;
  }
  return std::nullopt;
}

/// What of the line lies where inward . p >= limit.
std::optional<Line> clipped(const Line& line, const Vec3& inward, double limit_mm) {
  const double from_mm = glm::dot(inward, line.from) - limit_mm;
  const double to_mm = glm::dot(inward, line.to) - limit_mm;
  if (from_mm < 0.0 && to_mm < 0.0) return std::nullopt;
  if (from_mm >= 0.0 && to_mm >= 0.0) return line;
  const Vec3 border = line.from + from_mm / (from_mm - to_mm) * (line.to - line.from);
  return from_mm < 0.0 ? Line{border, line.to} : Line{line.from, border};
}

std::optional<Line> clipped(std::optional<Line> line, const FaceWindow& window) {
  const double from_along_mm = glm::dot(window.along, window.from_in_bone_mm);
  const double from_across_mm = glm::dot(window.across, window.from_in_bone_mm);
  if (line) line = clipped(*line, window.along, from_along_mm);
  if (line) line = clipped(*line, window.across, from_across_mm + window.low_mm);
  if (line) line = clipped(*line, -window.across, -(from_across_mm + window.high_mm));
  return line;
}

}  // namespace

bool lies_within(const FaceWindow& window, const Vec3& point_in_bone_mm) noexcept {
  const Vec3 way = point_in_bone_mm - window.from_in_bone_mm;
  const double across_mm = glm::dot(window.across, way);
  return glm::dot(window.along, way) >= 0.0 && window.low_mm <= across_mm &&
         across_mm <= window.high_mm;
}

std::optional<Vec3> furthest_in_face(const ReferenceFace& face, const simulator::IndexedMesh& mesh,
                                     const Vec3& direction) {
  std::optional<Vec3> furthest;
  for (const simulator::Triangle& triangle : mesh.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto point = crossing(face, mesh.points_mm[triangle[corner]],
                                  mesh.points_mm[triangle[(corner + 1) % 3]]);
      if (point) keep_further(furthest, *point, direction);
    }
  }
  return furthest;
}

std::optional<Vec3> furthest_in_window(const ReferenceFace& face, const FaceWindow& window,
                                       const simulator::IndexedMesh& mesh, const Vec3& direction) {
  std::optional<Vec3> furthest;
  for (std::size_t index = 0; index < mesh.triangles.size(); ++index) {
    const auto line = clipped(line_in(face, simulator::corners_of(mesh, index)), window);
    if (!line) continue;
    keep_further(furthest, line->from, direction);
    keep_further(furthest, line->to, direction);
  }
  return furthest;
}

}  // namespace hallux::scenarios

#include "scenarios/foot/landmarks.h"

#include <array>
#include <limits>

namespace hallux::scenarios {
namespace {

/// Each turn of a straight edge lays it on a steeper corner; more are never needed.
constexpr int most_turns = 100;

/// Calls `visit(from, to)` for each segment in which the plane across `axis` (0 is x) cuts a
/// triangle; the bone lies on the same side of all.
template <typename Visit>
void for_each_slice_segment(const simulator::IndexedMesh& mesh, glm::length_t axis, double at_mm,
                            const Visit& visit) {
  for (const simulator::Triangle& t : mesh.triangles) {
    std::array<Vec3, 2> ends{Vec3{0.0}, Vec3{0.0}};
    int found = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.points_mm[t[k]];
      const Vec3& q = mesh.points_mm[t[(k + 1) % 3]];
      if ((p[axis] < at_mm) == (q[axis] < at_mm)) continue;
      ends[p[axis] < at_mm ? 0 : 1] = p + (q - p) * ((at_mm - p[axis]) / (q[axis] - p[axis]));
      ++found;
    }
    if (found == 2) visit(ends[0], ends[1]);
  }
}

}  // namespace

Vec3 on_surface(const LandmarkSources& sources, const Vec3& point_in_table_mm) {
  return sources.field.onto_surface(sources.field.stretched(point_in_table_mm));
}

Vec3 cap_centre(const LandmarkSources& sources, const EndCap& cap) {
  return on_surface(sources, {cap.x_mm, cap.y_mm, cap.z_mm});
}

Vec3 slice_centroid(const simulator::IndexedMesh& mesh, double x_mm) {
  // Green's theorem over the segments.
  double area = 0.0;
  Vec2 moment{0.0, 0.0};
  for_each_slice_segment(mesh, 0, x_mm, [&](const Vec3& from, const Vec3& to) {
    const double twice = from.y * to.z - to.y * from.z;
    area += twice;
    moment += Vec2{from.y + to.y, from.z + to.z} * twice;
  });
  const Vec2 centre = moment / (3.0 * area);
  return {x_mm, centre.x, centre.y};
}

Vec3 slice_extreme(const simulator::IndexedMesh& mesh, glm::length_t axis, double at_mm,
                   const Vec3& along) {
  Vec3 best{0.0, 0.0, 0.0};
  bool is_found = false;
  for_each_slice_segment(mesh, axis, at_mm, [&](const Vec3& from, const Vec3&) {
    // The slice is closed: each corner begins one of its segments.
    if (is_found && glm::dot(along, from) <= glm::dot(along, best)) return;
    best = from;
    is_found = true;
  });
  return best;
}

Vec3 extreme_point(const simulator::IndexedMesh& mesh, const Vec3& along, double low_mm,
                   double high_mm) {
  Vec3 best{0.0, 0.0, 0.0};
  bool is_found = false;
  for (const Vec3& p : mesh.points_mm) {
    if (p.x < low_mm || p.x > high_mm) continue;
    if (is_found && glm::dot(along, p) <= glm::dot(along, best)) continue;
    best = p;
    is_found = true;
  }
  return best;
}

RestingPoints straight_edge(const simulator::IndexedMesh& mesh, double facing, double middle_z_mm) {
  RestingPoints rest;
  Vec3 outward{facing, 0.0, 0.0};
  for (int turn = 0; turn < most_turns; ++turn) {
    const RestingPoints before = rest;
    double medial = -std::numeric_limits<double>::infinity();
    double lateral = medial;
    for (const Vec3& p : mesh.points_mm) {
      double& furthest = p.z < middle_z_mm ? medial : lateral;
      if (glm::dot(outward, p) <= furthest) continue;
      furthest = glm::dot(outward, p);
      (p.z < middle_z_mm ? rest.medial : rest.lateral) = p;
    }
    if (rest.medial == before.medial && rest.lateral == before.lateral) break;
    const Vec3 along = rest.lateral - rest.medial;
    outward = facing * Vec3{along.z, 0.0, -along.x};
  }
  return rest;
}

}  // namespace hallux::scenarios

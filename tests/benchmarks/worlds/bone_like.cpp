#include "tests/benchmarks/worlds/bone_like.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "simulator/base/units.h"

namespace hallux::benchmarks {

namespace {

using simulator::IndexedMesh;

constexpr double half_length_mm = 31.0;
constexpr double canal_share = 0.35;

/// A shell of the same family: its own length, and a share of the outer radius.
struct Shell {
  double half_length_mm = 31.0;
  double radius_share = 1.0;
  std::size_t triangles = 50'000;
};

/// A place on the meridian of a shell, and how far it is along it.
struct Profile {
  double x_mm = 0.0, radius_mm = 0.0, arc_mm = 0.0;
};

Profile profile_at(const Shell& shell, double angle_rad) {
  const double along = -std::cos(angle_rad);
  const double round_end = std::pow(std::max(0.0, 1.0 - std::pow(along, 6.0)), 0.25);
  const double x_mm = shell.half_length_mm * along;
  const double shaft_mm = 5.9 + 1.6 * std::pow(x_mm / half_length_mm, 2.0);
  return {x_mm, shell.radius_share * shaft_mm * round_end, 0.0};
}

/// The meridian from pole to pole at `count` + 1 places of equal distance along it.
std::vector<Profile> even_meridian(const Shell& shell, std::size_t count) {
  constexpr std::size_t fine_count = 20'000;
  std::vector<Profile> fine(fine_count + 1);
  for (std::size_t i = 0; i <= fine_count; ++i) {
    fine[i] = profile_at(shell, pi * static_cast<double>(i) / static_cast<double>(fine_count));
    if (i == 0) continue;
    fine[i].arc_mm = fine[i - 1].arc_mm + std::hypot(fine[i].x_mm - fine[i - 1].x_mm,
                                                     fine[i].radius_mm - fine[i - 1].radius_mm);
  }
  std::vector<Profile> even;
  std::size_t next = 0;
  for (std::size_t i = 0; i <= count; ++i) {
    const double wanted_mm =
        fine.back().arc_mm * static_cast<double>(i) / static_cast<double>(count);
    while (next < fine_count && fine[next].arc_mm < wanted_mm) ++next;
    even.push_back(fine[next]);
  }
  return even;
}

/// Waves along and around keep sections from being circles, and triangles from being alike.
Vec3 on_surface(const Profile& profile, double angle_rad) {
  const double wave = 1.0 + 0.03 * std::sin(3.0 * angle_rad + 0.2 * profile.x_mm) +
                      0.02 * std::sin(0.8 * profile.x_mm);
  const double radius_mm = profile.radius_mm * wave;
  return {profile.x_mm, 1.06 * radius_mm * std::cos(angle_rad),
          0.94 * radius_mm * std::sin(angle_rad)};
}

IndexedMesh make_shell(const Shell& shell) {
  // A row of rings is about 1.6 times as long as a ring is round.
  const double per_ring = std::sqrt(static_cast<double>(shell.triangles) / (2.0 * 1.6));
  const auto segments = static_cast<std::size_t>(std::max(8.0, std::round(per_ring)));
  const std::size_t rings = std::max<std::size_t>(4, shell.triangles / (2 * segments) + 1);
  const std::vector<Profile> meridian = even_meridian(shell, rings);
  IndexedMesh mesh;
  mesh.points_mm.emplace_back(meridian.front().x_mm, 0.0, 0.0);
  mesh.points_mm.emplace_back(meridian.back().x_mm, 0.0, 0.0);
  for (std::size_t ring = 1; ring < rings; ++ring) {
    for (std::size_t i = 0; i < segments; ++i) {
      // Every other ring is turned by half a segment: nearly equilateral triangles.
      const double turn = static_cast<double>(i) + (ring % 2 == 0 ? 0.0 : 0.5);
      mesh.points_mm.push_back(
          on_surface(meridian[ring], 2.0 * pi * turn / static_cast<double>(segments)));
    }
  }
  const auto at = [segments](std::size_t ring, std::size_t i) {
    return static_cast<std::uint32_t>(2 + (ring - 1) * segments + i % segments);
  };
  for (std::size_t i = 0; i < segments; ++i) {
    mesh.triangles.push_back({0, at(1, i + 1), at(1, i)});
    mesh.triangles.push_back({1, at(rings - 1, i), at(rings - 1, i + 1)});
    for (std::size_t ring = 1; ring + 1 < rings; ++ring) {
      // The diagonal leads to the neighbour that the turn of the rings has brought nearer.
      const std::size_t nearer = ring % 2 == 0 ? i : i + 1;
      const std::size_t from = ring % 2 == 0 ? i + 1 : i;
      mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, nearer)});
      mesh.triangles.push_back({at(ring, from), at(ring + 1, i + 1), at(ring + 1, i)});
    }
  }
  return mesh;
}

IndexedMesh inside_out(IndexedMesh mesh) {
  for (simulator::Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

}  // namespace

IndexedMesh make_bone_like(const BoneLike& wanted) {
  const auto canal_triangles = static_cast<std::size_t>(
      wanted.is_hollow ? canal_share * static_cast<double>(wanted.triangles) : 0.0);
  IndexedMesh mesh = make_shell({half_length_mm, 1.0, wanted.triangles - canal_triangles});
  if (wanted.is_hollow) {
    append_mesh(mesh, inside_out(make_shell({0.75 * half_length_mm, 0.6, canal_triangles})));
  }
  return mesh;
}

IndexedMesh make_foot_like(std::size_t triangles) {
  constexpr std::size_t bone_count = 5;
  constexpr double spacing_mm = 18.0;
  const IndexedMesh bone = make_bone_like({triangles / bone_count, true});
  IndexedMesh foot;
  for (std::size_t i = 0; i < bone_count; ++i) {
    IndexedMesh ray = bone;
    for (Vec3& point_mm : ray.points_mm) point_mm.y += spacing_mm * (static_cast<double>(i) - 2.0);
    append_mesh(foot, ray);
  }
  return foot;
}

Vec3 middle_of(const simulator::IndexedMesh& mesh) {
  Vec3 least = mesh.points_mm.front(), most = least;
  for (const Vec3& point : mesh.points_mm) {
    least = glm::min(least, point);
    most = glm::max(most, point);
  }
  return 0.5 * (least + most);
}

simulator::KerfPlane oblique_kerf(double thickness_mm) {
  const Vec3 normal = glm::normalize(Vec3(1.0, 0.25, 0.15));
  const Vec3 along_z(0.0, 0.0, -1.0);
  const Vec3 feed = glm::normalize(along_z - glm::dot(along_z, normal) * normal);
  return {{rotation_from_axes(feed, glm::cross(normal, feed)), Vec3(2.0, 0.3, 0.2)}, thickness_mm};
}

}  // namespace hallux::benchmarks

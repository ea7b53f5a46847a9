// The saw from numbers: the plate is a polygon of the blade's width, thickness and depth with its
// teeth, everything else an outline turned about an axis. Normals are shared along an outline but
// at its edges, so that few triangles look round. Only the blade has its own measures; hub, neck
// and grip are of one size and stand where the blade's pivot is.
#include "ui/render/scene/tool_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "simulator/base/units.h"

namespace hallux::ui {

namespace {

using simulator::Blade;

/// A point of a turned part's outline: along the axis, away from it, and what the part up to the
/// next point is made of.
struct ProfilePoint {
  double along_mm = 0.0, radius_mm = 0.0;
  ToolMaterial material = ToolMaterial::Grip;
};

class ToolBuilder {
 public:
  void add_triangle(const std::array<Vec3, 3>& corners_mm, ToolMaterial material) {
    const Vec3 normal =
        glm::normalize(glm::cross(corners_mm[1] - corners_mm[0], corners_mm[2] - corners_mm[0]));
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (const Vec3& corner_mm : corners_mm) add_vertex(corner_mm, normal, material);
    mesh_.triangles.push_back({first, first + 1, first + 2});
  }
  void add_quad(const std::array<Vec3, 4>& corners_mm, ToolMaterial material) {
    add_triangle({corners_mm[0], corners_mm[1], corners_mm[2]}, material);
    add_triangle({corners_mm[0], corners_mm[2], corners_mm[3]}, material);
  }
  /// A part turned about an axis; `tool_from_turned` puts its z axis there. Outlines run so that
  /// outside is on their left when z points right.
  void add_turned(std::span<const ProfilePoint> profile, const RigidTransform& tool_from_turned);

  ToolMesh take() { return std::move(mesh_); }

 private:
  void add_vertex(const Vec3& point_mm, const Vec3& normal, ToolMaterial material) {
    mesh_.vertices.push_back({to_float(point_mm), to_float(normal), static_cast<float>(material)});
  }

  ToolMesh mesh_;
};

Vec2 outward(const ProfilePoint& from, const ProfilePoint& to) {
  return glm::normalize(Vec2(from.radius_mm - to.radius_mm, to.along_mm - from.along_mm));
}

/// The outline's normal at an end of piece `i`: shared with the neighbour unless there is an edge
/// between them.
Vec2 outline_normal(std::span<const ProfilePoint> profile, std::size_t i, bool at_end) {
  constexpr double smooth_below = 0.78;  // cosine: about 39 degrees
  const Vec2 own = outward(profile[i], profile[i + 1]);
  const std::size_t other = at_end ? i + 1 : i - 1;
  if ((!at_end && i == 0) || other + 1 >= profile.size()) return own;
  const Vec2 next = outward(profile[other], profile[other + 1]);
  return glm::dot(own, next) < smooth_below ? own : glm::normalize(own + next);
}

void ToolBuilder::add_turned(std::span<const ProfilePoint> profile,
                             const RigidTransform& tool_from_turned) {
  constexpr std::uint32_t segments = 40;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    const std::array<Vec2, 2> normals{outline_normal(profile, i, false),
                                      outline_normal(profile, i, true)};
    for (std::uint32_t s = 0; s <= segments; ++s) {
      const double angle = 2.0 * pi * s / segments;
      const Vec3 away(std::cos(angle), std::sin(angle), 0.0);
      for (std::size_t end = 0; end < 2; ++end) {
        const ProfilePoint& point = profile[i + end];
        const Vec3 place_mm = point.radius_mm * away + Vec3(0.0, 0.0, point.along_mm);
        const Vec3 normal = normals[end].y * away + Vec3(0.0, 0.0, normals[end].x);
        add_vertex(transform_point(tool_from_turned, place_mm),
                   transform_direction(tool_from_turned, normal), profile[i].material);
      }
    }
    for (std::uint32_t s = 0; s < segments; ++s) {
      const std::uint32_t a = first + 2 * s;
      mesh_.triangles.push_back({a, a + 2, a + 3});
      mesh_.triangles.push_back({a, a + 3, a + 1});
    }
  }
}

/// Half the plate's width at its stations from the gullets back to the hub.
std::array<Vec2, 4> plate_stations(const Blade& blade, double gullet_mm) {
  const double half = 0.5 * blade.width_mm, depth = blade.depth_mm;
  return {Vec2(-gullet_mm, half), Vec2(-0.70 * depth, half), Vec2(-0.88 * depth, 0.68 * half),
          Vec2(-depth - 3.0, 0.62 * half)};
}

}  // namespace

double pivot_x_mm(const Blade& blade) noexcept { return -blade.depth_mm - 4.0; }

ToolMesh blade_mesh(const Blade& blade) {
  ToolBuilder builder;
  const double gullet_mm = 0.9, half_mm = 0.5 * blade.thickness_mm;
  const auto steel = ToolMaterial::Blade;
  const auto at = [&](double x, double y, double side) { return Vec3(x, y, side * half_mm); };
  const auto stations = plate_stations(blade, gullet_mm);
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    const Vec2 a = stations[i], b = stations[i + 1];
    builder.add_quad({at(b.x, -b.y, 1), at(a.x, -a.y, 1), at(a.x, a.y, 1), at(b.x, b.y, 1)}, steel);
    builder.add_quad({at(b.x, b.y, -1), at(a.x, a.y, -1), at(a.x, -a.y, -1), at(b.x, -b.y, -1)},
                     steel);
    for (const double y : {1.0, -1.0}) {
      const Vec3 upper_a = at(a.x, y * a.y, y), upper_b = at(b.x, y * b.y, y);
      const Vec3 lower_a = at(a.x, y * a.y, -y), lower_b = at(b.x, y * b.y, -y);
      builder.add_quad({upper_a, lower_a, lower_b, upper_b}, steel);
    }
  }
  const int teeth = std::max(3, static_cast<int>(std::lround(blade.width_mm / 1.0)));
  for (int tooth = 0; tooth < teeth; ++tooth) {
    const double low = blade.width_mm * (static_cast<double>(tooth) / teeth - 0.5);
    const double high = blade.width_mm * (static_cast<double>(tooth + 1) / teeth - 0.5);
    const double tip = 0.5 * (low + high);
    builder.add_triangle({at(-gullet_mm, low, 1), at(0.0, tip, 1), at(-gullet_mm, high, 1)}, steel);
    builder.add_triangle({at(-gullet_mm, high, -1), at(0.0, tip, -1), at(-gullet_mm, low, -1)},
                         steel);
    builder.add_quad(
        {at(-gullet_mm, low, 1), at(-gullet_mm, low, -1), at(0.0, tip, -1), at(0.0, tip, 1)},
        steel);
    builder.add_quad(
        {at(0.0, tip, 1), at(0.0, tip, -1), at(-gullet_mm, high, -1), at(-gullet_mm, high, 1)},
        steel);
  }
  return builder.take();
}

ToolMesh handpiece_mesh(const Blade& blade) {
  constexpr auto steel = ToolMaterial::Steel;
  constexpr auto grip = ToolMaterial::Grip;
  constexpr auto band = ToolMaterial::Band;
  ToolBuilder builder;
  // The hub that clamps the blade, about the pivot.
  constexpr std::array<ProfilePoint, 9> hub{{{-3.6, 0.0, steel},
                                             {-3.6, 3.9, steel},
                                             {-3.0, 4.6, steel},
                                             {2.6, 4.6, steel},
                                             {3.2, 4.0, steel},
                                             {3.2, 2.6, steel},
                                             {3.4, 2.4, band},
                                             {3.9, 2.2, band},
                                             {3.9, 0.0, steel}}};
  builder.add_turned(hub, {Quat(1.0, 0.0, 0.0, 0.0), Vec3(pivot_x_mm(blade), 0.0, 0.0)});
  // Neck, grip and cable: along -x from the hub; `along` counts from the pivot.
  constexpr std::array<ProfilePoint, 26> body{
      {{2.0, 0.0, steel},         {2.0, 3.3, steel},        {7.0, 3.4, steel},  {10.0, 4.0, steel},
       {12.0, 5.6, steel},        {13.2, 6.2, steel},       {14.6, 6.2, band},  {15.0, 5.8, grip},
       {15.6, 5.8, grip},         {16.6, 6.9, grip},        {24.0, 7.9, grip},  {36.0, 8.2, grip},
       {50.0, 8.0, grip},         {60.0, 8.0, grip},        {60.6, 7.5, band},  {62.4, 7.5, band},
       {63.0, 8.1, grip},         {82.0, 8.8, grip},        {102.0, 9.0, grip}, {110.0, 8.2, grip},
       {113.0, 6.9, steel},       {117.0, 6.3, steel},      {118.0, 4.2, grip}, {124.0, 3.0, grip},
       {cable_end_mm, 3.0, grip}, {cable_end_mm, 0.0, grip}}};
  const Quat along_handle = rotation_from_axes(Vec3(0.0, 0.0, 1.0), Vec3(0.0, 1.0, 0.0));
  builder.add_turned(body, {along_handle, Vec3(pivot_x_mm(blade), 0.0, 0.0)});
  return builder.take();
}

}  // namespace hallux::ui

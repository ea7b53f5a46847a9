// The saw from numbers: the plate is a polygon of the blade's width, thickness and depth with its
// teeth, everything else an outline turned about an axis. Only the blade has its own measures; hub,
// neck and grip are of one size and stand where the blade's pivot is.
#include "ui/render/scene/tool_model.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hallux::ui {

namespace {

using simulator::Blade;

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

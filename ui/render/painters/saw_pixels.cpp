#include "ui/render/painters/saw_pixels.h"

#include "ui/render/scene/tool_model.h"

namespace hallux::ui {

namespace {

constexpr double handle_radius_mm = 9.5, part_mm = 6.0, half_thickness_mm = 0.5;
/// For what a line between two pixels changes on both sides.
constexpr int margin_pixels = 1;

}  // namespace

PixelTiles saw_pixels(const SawInScene& saw, const EyeView& view, PixelSize size) {
  PixelTiles tiles{size};
  const auto add = [&](double from_x_mm, const Vec2& half_mm) {
    Box box;
    box.add(Vec3(from_x_mm - part_mm, -half_mm.x, -half_mm.y));
    box.add(Vec3(from_x_mm, half_mm.x, half_mm.y));
    const PixelBox pixels = pixels_of(box, saw.world_from_tool, view, size);
    if (pixels != all_of(size)) tiles.add(widened(pixels, margin_pixels, size));
  };
  const double pivot_mm = pivot_x_mm(saw.blade);
  for (double x_mm = 1.0; x_mm > pivot_mm; x_mm -= part_mm) {
    const double swing_mm = swing_rad * (x_mm - pivot_mm);
    add(x_mm, Vec2(0.5 * saw.blade.width_mm + swing_mm, half_thickness_mm));
  }
  for (double x_mm = pivot_mm + handle_radius_mm; x_mm > pivot_mm - cable_end_mm; x_mm -= part_mm)
    add(x_mm, Vec2(handle_radius_mm, handle_radius_mm));
  return tiles;
}

}  // namespace hallux::ui

#include "ui/render/painters/tool_pixels.h"

#include "ui/render/painters/handle.h"
#include "ui/render/painters/hole_painter.h"
#include "ui/render/painters/implant_painter.h"
#include "ui/render/scene/driver_model.h"
#include "ui/render/scene/forceps_model.h"
#include "ui/render/scene/tool_model.h"

namespace hallux::ui {

namespace {

constexpr double handle_radius_mm = 9.5, part_mm = 6.0, half_thickness_mm = 0.5;
/// For what a line between two pixels changes on both sides.
constexpr int margin_pixels = 1;

/// A picture and what of it was asked for.
struct Asked {
  PixelTiles tiles;
  const EyeView& view;
  PixelSize size;

  void add(const PixelBox& pixels) {
    if (pixels != all_of(size)) tiles.add(widened(pixels, margin_pixels, size));
  }
  /// Around so much of a tool's axis.
  void add_part(const RigidTransform& world_from_tool, double from_x_mm, const Vec2& half_mm) {
    Box box;
    box.add(Vec3(from_x_mm - part_mm, -half_mm.x, -half_mm.y));
    box.add(Vec3(from_x_mm, half_mm.x, half_mm.y));
    add(pixels_of(box, world_from_tool, view, size));
  }
  void add_parts(const RigidTransform& world_from_tool, double from_x_mm, double to_x_mm,
                 const Vec2& half_mm) {
    for (double x_mm = from_x_mm; x_mm > to_x_mm; x_mm -= part_mm)
      add_part(world_from_tool, x_mm, half_mm);
  }
};

void add_saw(Asked& asked, const SawInScene& saw) {
  const double pivot_mm = pivot_x_mm(saw.blade);
  for (double x_mm = 1.0; x_mm > pivot_mm; x_mm -= part_mm) {
    const double swing_mm = swing_rad * (x_mm - pivot_mm);
    asked.add_part(saw.world_from_tool, x_mm,
                   Vec2(0.5 * saw.blade.width_mm + swing_mm, half_thickness_mm));
  }
  asked.add_parts(saw.world_from_tool, pivot_mm + handle_radius_mm, pivot_mm - cable_end_mm,
                  Vec2(handle_radius_mm, handle_radius_mm));
}

void add_driver(Asked& asked, const DriverInScene& driver) {
  const Handle handle = handle_of(driver);
  constexpr double jaws_mm = 2.5;
  asked.add_parts(driver.world_from_tool, 0.0, handle.front_x_mm,
                  Vec2(held_radius_mm(driver.tool)));
  asked.add_parts(driver.world_from_tool, handle.front_x_mm + jaws_mm, handle.back_x_mm,
                  handle.half_mm);
}

/// In the frame of each arm: between the arms there is much that neither covers.
void add_forceps(Asked& asked, const ForcepsInScene& forceps) {
  const RigidTransform first = tool_from_arm(forceps.opening_mm);
  for (const double side : {1.0, -1.0}) {
    const RigidTransform tool_from_arm{side > 0.0 ? first.rotation : glm::conjugate(first.rotation),
                                       first.translation_mm};
    const RigidTransform world_from_arm = forceps.world_from_tool * tool_from_arm;
    for (double x_mm = jaw_length_mm + 1.0; x_mm > -forceps_handle_mm; x_mm -= part_mm) {
      // The jaw lies on the arm's own side, the handle on the other.
      const double own_mm = x_mm > 0.0 ? jaw_half_mm : 5.0;
      const double other_mm = x_mm > 0.0 ? 5.0 : forceps_arm_half_mm;
      Box box;
      box.add(Vec3(x_mm - part_mm, side * own_mm, -forceps_half_thickness_mm));
      box.add(Vec3(x_mm, -side * other_mm, forceps_half_thickness_mm));
      asked.add(pixels_of(box, world_from_arm, asked.view, asked.size));
    }
  }
}

void add_implant(Asked& asked, const ImplantInScene& implant) {
  const Box box = box_of(implant.tool);
  asked.add_parts(implant.world_from_tool, box.high_mm.x, box.low_mm.x, Vec2(box.high_mm.y));
}

}  // namespace

PixelTiles tool_pixels(const Scene& scene, const EyeView& view, PixelSize size) {
  Asked asked{PixelTiles{size}, view, size};
  if (scene.saw) add_saw(asked, *scene.saw);
  if (scene.driver) add_driver(asked, *scene.driver);
  if (scene.forceps) add_forceps(asked, *scene.forceps);
  for (const ImplantInScene& implant : scene.implants) add_implant(asked, implant);
  for (const HoleInScene& hole : scene.holes) {
    if (hole.rim_mm.size() >= 3) asked.add(hole_pixels(shape_of(hole), view, size));
  }
  return asked.tiles;
}

}  // namespace hallux::ui

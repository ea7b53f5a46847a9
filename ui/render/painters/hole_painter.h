/// Draws holes on the skins of bones.
#pragma once

#include "ui/render/gl/gl_objects.h"
#include "ui/render/painters/frame.h"
#include "ui/render/painters/pixel_box.h"

namespace hallux::ui {

class HolePainter {
 public:
  HolePainter();

  /// Each as one sees into it: its wall, lit less and less from the mouth on, and a lighter rim
  /// around it.
  /// needs   the shapes of all the picture are drawn; a framebuffer with their stencil is bound
  void draw(const Frame& frame);

 private:
  ShaderProgram hole_;
  GlVertexArray no_attributes_;
};

/// A hole as it is drawn: its frame, z out of the bone and the origin in the middle of the rim, and
/// the rim there.
struct HoleShape {
  RigidTransform world_from_hole;
  /// At most rim_points_most.
  std::vector<Vec3> rim_mm;
  /// Mean of the rim's distance from z.
  double radius_mm = 0.0;
};
inline constexpr std::size_t rim_points_most = 64;
/// needs   a rim of three points or more
HoleShape shape_of(const HoleInScene& hole);

/// The pixels that it can change in a picture of this size.
PixelBox hole_pixels(const HoleShape& hole, const EyeView& view, PixelSize size) noexcept;

}  // namespace hallux::ui

/// Draws danger zones, and bone that still holds.
#pragma once

#include "ui/render/gl/display_buffer.h"
#include "ui/render/painters/frame.h"
#include "ui/render/scene/capsule.h"

namespace hallux::ui {

class SitePainter {
 public:
  SitePainter();

  /// Over the lit bones, before all that moves; takes the stencil of the bound framebuffer.
  void draw_held(const Frame& frame);
  /// After everything that is not translucent.
  void draw_zones(const Frame& frame);

 private:
  void draw_held(const Frame& frame, const HeldBone& held);
  void draw_zone(const Frame& frame, const ZoneInScene& zone);

  ShaderProgram held_, zone_;
  GlVertexArray plane_array_, capsule_array_;
  DisplayBuffer<Float2> plane_points_;
  DisplayBuffer<CapsuleVertex> capsule_points_;
  DisplayBuffer<simulator::Triangle> capsule_triangles_;
  unsigned pointed_at_ = 0;
};

}  // namespace hallux::ui

/// Draws the ground, and what lies over bones and tools: chips, planes, marks; inside this room
/// only.
#pragma once

#include "ui/render/gl/display_buffer.h"
#include "ui/render/painters/frame.h"

namespace hallux::ui {

class OverlayPainter {
 public:
  OverlayPainter();

  void draw_ground(const Frame& frame, std::span<const PixelBox> boxes);
  void draw_chips(const Frame& frame);
  /// After everything that is not translucent.
  void draw_planes(const Frame& frame);
  void draw_marks(const Frame& frame);

 private:
  struct PointVertex {
    Float3 place_mm{0.0F};
    Float2 size_and_wetness{0.0F};
  };

  void fill_points();

  ShaderProgram ground_, chip_, plane_, mark_;
  GlVertexArray no_attributes_, points_array_;
  DisplayBuffer<PointVertex> points_;
  unsigned pointed_at_ = 0;
};

}  // namespace hallux::ui

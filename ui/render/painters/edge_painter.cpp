#include "ui/render/painters/edge_painter.h"

#include <epoxy/gl.h>

namespace hallux::ui {

namespace {

void bind_picture(int unit, unsigned texture) {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

}  // namespace

EdgePainter::EdgePainter()
    : all_("part.vert", "edges.frag"), moving_("part.vert", "edges.frag", "#define MOVING\n") {}

void EdgePainter::draw(ShaderProgram& program, unsigned colours, const DrawTarget& into,
                       std::span<const PixelBox> boxes) {
  glBindFramebuffer(GL_FRAMEBUFFER, into.framebuffer);
  glViewport(into.left, into.bottom, into.size.width, into.size.height);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  bind_picture(place_unit, colours);
  program.set("picture_colours", place_unit);
  program.set("into_place", Float2(into.left, into.bottom));
  set_boxes(program, boxes, into.size);
  glBindVertexArray(no_attributes_.name());
  draw_boxes(boxes);
  glBindVertexArray(0);
  glUseProgram(0);
  glActiveTexture(GL_TEXTURE0);
}

void EdgePainter::smooth(unsigned colours, const DrawTarget& into,
                         std::span<const PixelBox> boxes) {
  all_.use();
  draw(all_, colours, into, boxes);
}

void EdgePainter::smooth_moving(unsigned colours, unsigned still, const DrawTarget& into,
                                std::span<const PixelBox> boxes) {
  moving_.use();
  bind_picture(normal_unit, still);
  moving_.set("still_colours", normal_unit);
  draw(moving_, colours, into, boxes);
}

std::vector<PixelBox> within_reach(std::span<const PixelBox> boxes, PixelSize size) {
  PixelTiles tiles{size};
  for (const PixelBox& box : boxes) tiles.add(widened(box, edge_reach_pixels, size));
  return tiles.boxes();
}

}  // namespace hallux::ui

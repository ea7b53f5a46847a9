// Three draws over the boxes: colours as they are, marks in the stencil where a pixel has a border,
// and the search along borders where there are marks. A processor would make the search at every
// pixel otherwise, whatever the shader asks first: it took 26 ms of a picture of 1280 x 720 and
// takes 2. A target without a stencil is smoothed as well, only slower.
#include "ui/render/painters/edge_painter.h"

#include <epoxy/gl.h>

namespace hallux::ui {

namespace {

void bind_picture(int unit, unsigned texture) {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

void let_colours_pass(bool do_they) {
  const GLboolean pass = do_they ? GL_TRUE : GL_FALSE;
  glColorMask(pass, pass, pass, pass);
}

}  // namespace

EdgePainter::EdgePainter()
    : copy_("part.vert", "copy.frag"),
      marks_all_("part.vert", "edges_found.frag"),
      marks_moving_("part.vert", "edges_found.frag", "#define MOVING\n"),
      lines_("part.vert", "edges.frag") {}

/// Colours as they are, and no marks.
void EdgePainter::begin(const Pass& pass) {
  glBindFramebuffer(GL_FRAMEBUFFER, pass.into.framebuffer);
  glViewport(pass.into.left, pass.into.bottom, pass.into.size.width, pass.into.size.height);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glEnable(GL_STENCIL_TEST);
  glStencilMask(0xff);
  glBindVertexArray(no_attributes_.name());
  bind_picture(place_unit, pass.colours);
  copy_.use();
  glStencilFunc(GL_ALWAYS, 0, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  draw(copy_, pass);
}

void EdgePainter::draw(ShaderProgram& program, const Pass& pass) {
  program.set("picture_colours", place_unit);
  program.set("into_place", Float2(pass.into.left, pass.into.bottom));
  set_boxes(program, pass.boxes, pass.into.size);
  draw_boxes(pass.boxes);
}

/// needs   `marks` is the current program
void EdgePainter::mark_and_smooth(ShaderProgram& marks, const Pass& pass) {
  let_colours_pass(false);
  glStencilFunc(GL_ALWAYS, 1, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  draw(marks, pass);
  let_colours_pass(true);
  lines_.use();
  glStencilFunc(GL_EQUAL, 1, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
  draw(lines_, pass);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glDisable(GL_STENCIL_TEST);
  glBindVertexArray(0);
  glUseProgram(0);
  glActiveTexture(GL_TEXTURE0);
}

void EdgePainter::smooth(unsigned colours, const DrawTarget& into,
                         std::span<const PixelBox> boxes) {
  const Pass pass{colours, into, boxes};
  begin(pass);
  marks_all_.use();
  mark_and_smooth(marks_all_, pass);
}

void EdgePainter::smooth_moving(unsigned colours, unsigned still, const DrawTarget& into,
                                std::span<const PixelBox> boxes) {
  const Pass pass{colours, into, boxes};
  begin(pass);
  marks_moving_.use();
  bind_picture(normal_unit, still);
  marks_moving_.set("still_colours", normal_unit);
  mark_and_smooth(marks_moving_, pass);
}

std::vector<PixelBox> within_reach(std::span<const PixelBox> boxes, PixelSize size) {
  PixelTiles tiles{size};
  for (const PixelBox& box : boxes) tiles.add(widened(box, edge_reach_pixels, size));
  return tiles.boxes();
}

}  // namespace hallux::ui

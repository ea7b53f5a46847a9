#include "tests/ui/render/graphics.h"

#include <epoxy/gl.h>

namespace hallux::tests {

ObjectCensus count_objects() {
  constexpr unsigned names = 4096;
  ObjectCensus census;
  for (unsigned name = 1; name < names; ++name) {
    census.buffers += glIsBuffer(name) != 0 ? 1U : 0U;
    census.vertex_arrays += glIsVertexArray(name) != 0 ? 1U : 0U;
    census.textures += glIsTexture(name) != 0 ? 1U : 0U;
    census.framebuffers += glIsFramebuffer(name) != 0 ? 1U : 0U;
    census.renderbuffers += glIsRenderbuffer(name) != 0 ? 1U : 0U;
    census.programs_and_shaders += glIsProgram(name) != 0 || glIsShader(name) != 0 ? 1U : 0U;
  }
  return census;
}

unsigned take_error() { return glGetError(); }

Colour pixel_at(const ui::Pixels& picture, int x, int y) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
           static_cast<std::size_t>(x));
  return {picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]};
}

Facts facts_of(const ui::Pixels& picture, const std::function<bool(const Colour&)>& is_picked) {
  Facts facts;
  for (int y = 0; y < picture.size.height; ++y) {
    for (int x = 0; x < picture.size.width; ++x) {
      const Colour colour = pixel_at(picture, x, y);
      if (!is_picked(colour)) continue;
      ++facts.count;
      facts.x += (x + 0.5) / picture.size.width;
      facts.y += (y + 0.5) / picture.size.height;
      facts.red += colour.red;
      facts.green += colour.green;
      facts.blue += colour.blue;
    }
  }
  const double count = facts.count > 0 ? static_cast<double>(facts.count) : 1.0;
  for (double* mean : {&facts.x, &facts.y, &facts.red, &facts.green, &facts.blue}) *mean /= count;
  facts.share = static_cast<double>(facts.count) /
                (static_cast<double>(picture.size.width) * picture.size.height);
  return facts;
}

bool is_bone_coloured(const Colour& colour) {
  return colour.red > 60 && colour.red > colour.blue + 12 && colour.green > colour.blue;
}

void whiten_column(const ui::DrawTarget& target, int column) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glEnable(GL_SCISSOR_TEST);
  glScissor(target.left + column, target.bottom, 1, target.size.height);
  glClearColor(1.0F, 1.0F, 1.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

ui::DrawTarget bound_target(ui::PixelSize size) {
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  return {static_cast<unsigned>(framebuffer), 0, 0, size};
}

}  // namespace hallux::tests

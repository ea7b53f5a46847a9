#include "ui/render/gl/render_target.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>

#include "ui/render/gl/graphics_error.h"

namespace hallux::ui {

PixelSize at_least_one(PixelSize size) noexcept {
  return {std::max(size.width, 1), std::max(size.height, 1)};
}

void check_framebuffer(PixelSize size) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (!forget_graphics_errors() && status == GL_FRAMEBUFFER_COMPLETE) return;
  throw GraphicsError("the graphics driver makes no picture of " + std::to_string(size.width) +
                      " x " + std::to_string(size.height) +
                      " pixels to draw into; choose a smaller window or picture");
}

bool forget_graphics_errors() noexcept {
  bool was_any = false;
  while (glGetError() != GL_NO_ERROR) was_any = true;
  return was_any;
}

BoundFramebuffer::BoundFramebuffer(unsigned framebuffer) {
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

BoundFramebuffer::~BoundFramebuffer() {
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<unsigned>(before_));
}

void copy_picture(const DrawTarget& from, const DrawTarget& to) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer);
  const GLenum filter = from.size == to.size ? GL_NEAREST : GL_LINEAR;
  glBlitFramebuffer(from.left, from.bottom, from.left + from.size.width,
                    from.bottom + from.size.height, to.left, to.bottom, to.left + to.size.width,
                    to.bottom + to.size.height, GL_COLOR_BUFFER_BIT, filter);
  glBindFramebuffer(GL_FRAMEBUFFER, to.framebuffer);
}

RenderTarget::RenderTarget(PixelSize size) : size_(at_least_one(size)) {
  forget_graphics_errors();
  glBindTexture(GL_TEXTURE_2D, colour_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size_.width, size_.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, size_.width, size_.height);
  const BoundFramebuffer bound(framebuffer_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(), 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                            depth_.name());
  check_framebuffer(size_);
}

Pixels RenderTarget::read() const { return read_pixels(target()); }

Pixels read_pixels(const DrawTarget& target) {
  Pixels pixels{target.size, {}};
  const std::size_t row = 4 * static_cast<std::size_t>(target.size.width);
  pixels.rgba.resize(row * static_cast<std::size_t>(target.size.height));
  const BoundFramebuffer bound(target.framebuffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(target.left, target.bottom, target.size.width, target.size.height, GL_RGBA,
               GL_UNSIGNED_BYTE, pixels.rgba.data());
  for (int low = 0, high = target.size.height - 1; low < high; ++low, --high) {
    const auto first = pixels.rgba.begin() + static_cast<std::ptrdiff_t>(row) * low;
    std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(row),
                     pixels.rgba.begin() + static_cast<std::ptrdiff_t>(row) * high);
  }
  return pixels;
}

}  // namespace hallux::ui

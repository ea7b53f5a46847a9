#include "ui/render/painters/picture_buffers.h"

#include <epoxy/gl.h>

#include <array>

namespace hallux::ui {

namespace {

void make_texture(const GlTexture& texture, PixelSize size, GLint format, GLenum kind) {
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, format, size.width, size.height, 0, GL_RGBA, kind, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void attach(GLenum point, const GlTexture& texture) {
  glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture.name(), 0);
}

void make_depth(const GlRenderbuffer& depth, PixelSize size) {
  glBindRenderbuffer(GL_RENDERBUFFER, depth.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, size.width, size.height);
}

void attach_depth(const GlRenderbuffer& depth) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                            depth.name());
}

void make_framebuffer(const GlFramebuffer& framebuffer, const GlTexture& colour,
                      const GlRenderbuffer& depth, PixelSize size) {
  const BoundFramebuffer bound(framebuffer.name());
  attach(GL_COLOR_ATTACHMENT0, colour);
  attach_depth(depth);
  check_framebuffer(size);
}

}  // namespace

PictureBuffers::PictureBuffers(PixelSize size, bool has_smooth) : size_(at_least_one(size)) {
  forget_graphics_errors();
  make_texture(still_colour_, size_, GL_RGBA8, GL_UNSIGNED_BYTE);
  make_texture(colour_, size_, GL_RGBA8, GL_UNSIGNED_BYTE);
  make_texture(place_, size_, GL_RGBA32F, GL_FLOAT);
  make_texture(normal_, size_, GL_RGBA16F, GL_HALF_FLOAT);
  make_depth(still_depth_, size_);
  make_depth(depth_, size_);
  {
    const BoundFramebuffer bound(shapes_.name());
    attach(GL_COLOR_ATTACHMENT0, place_);
    attach(GL_COLOR_ATTACHMENT1, normal_);
    attach_depth(still_depth_);
    constexpr std::array<GLenum, 2> both{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(static_cast<GLsizei>(both.size()), both.data());
    check_framebuffer(size_);
  }
  make_framebuffer(still_, still_colour_, still_depth_, size_);
  make_framebuffer(picture_, colour_, depth_, size_);
  if (!has_smooth) return;
  smooth_.emplace();
  make_texture(smooth_->colour, size_, GL_RGBA8, GL_UNSIGNED_BYTE);
  const BoundFramebuffer bound(smooth_->framebuffer.name());
  attach(GL_COLOR_ATTACHMENT0, smooth_->colour);
  attach_depth(depth_);
  check_framebuffer(size_);
}

void PictureBuffers::copy_still_to_picture() const { copy_to_picture(still_.name()); }

void PictureBuffers::copy_smooth_to_picture() const {
  copy_to_picture(smooth_->framebuffer.name());
}

void PictureBuffers::copy_to_picture(unsigned colours) const {
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture_.name());
  const auto copy = [&](unsigned from, GLbitfield parts) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height, parts,
                      GL_NEAREST);
  };
  copy(colours, GL_COLOR_BUFFER_BIT);
  copy(still_.name(), GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glBindFramebuffer(GL_FRAMEBUFFER, picture_.name());
}

}  // namespace hallux::ui

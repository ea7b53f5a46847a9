#include "ui/render/picture_buffers.h"

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

void attach_depth(const GlRenderbuffer& depth) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                            depth.name());
}

}  // namespace

PictureBuffers::PictureBuffers(PixelSize size) : size_(at_least_one(size)) {
  forget_graphics_errors();
  make_texture(colour_, size_, GL_RGBA8, GL_UNSIGNED_BYTE);
  make_texture(place_, size_, GL_RGBA32F, GL_FLOAT);
  make_texture(normal_, size_, GL_RGBA32F, GL_FLOAT);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, size_.width, size_.height);
  {
    const BoundFramebuffer bound(shapes_.name());
    attach(GL_COLOR_ATTACHMENT0, place_);
    attach(GL_COLOR_ATTACHMENT1, normal_);
    attach_depth(depth_);
    constexpr std::array<GLenum, 2> both{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(static_cast<GLsizei>(both.size()), both.data());
    check_framebuffer(size_);
  }
  const BoundFramebuffer bound(picture_.name());
  attach(GL_COLOR_ATTACHMENT0, colour_);
  attach_depth(depth_);
  check_framebuffer(size_);
}

}  // namespace hallux::ui

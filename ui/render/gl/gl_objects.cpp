#include "ui/render/gl/gl_objects.h"

#include <epoxy/gl.h>

namespace hallux::ui {

template <GlKind kind>
GlObject<kind>::GlObject() {
  if constexpr (kind == GlKind::Buffer) glGenBuffers(1, &name_);
  if constexpr (kind == GlKind::VertexArray) glGenVertexArrays(1, &name_);
  if constexpr (kind == GlKind::Texture) glGenTextures(1, &name_);
  if constexpr (kind == GlKind::Framebuffer) glGenFramebuffers(1, &name_);
  if constexpr (kind == GlKind::Renderbuffer) glGenRenderbuffers(1, &name_);
}

template <GlKind kind>
GlObject<kind>::~GlObject() {
  if (name_ == 0) return;
  if constexpr (kind == GlKind::Buffer) glDeleteBuffers(1, &name_);
  if constexpr (kind == GlKind::VertexArray) glDeleteVertexArrays(1, &name_);
  if constexpr (kind == GlKind::Texture) glDeleteTextures(1, &name_);
  if constexpr (kind == GlKind::Framebuffer) glDeleteFramebuffers(1, &name_);
  if constexpr (kind == GlKind::Renderbuffer) glDeleteRenderbuffers(1, &name_);
}

template class GlObject<GlKind::Buffer>;
template class GlObject<GlKind::VertexArray>;
template class GlObject<GlKind::Texture>;
template class GlObject<GlKind::Framebuffer>;
template class GlObject<GlKind::Renderbuffer>;

}  // namespace hallux::ui

/// OpenGL's objects with owners: made by the constructor, deleted by the destructor, moved but
/// never copied.
///
/// All need the context that was current when they were made; it must still be current when they
/// go.
#pragma once

#include <cstdint>

namespace hallux::ui {

enum class GlKind : std::uint8_t { Buffer, VertexArray, Texture, Framebuffer, Renderbuffer };

template <GlKind kind>
class GlObject {
 public:
  GlObject();
  ~GlObject();
  GlObject(GlObject&& other) noexcept : name_(other.name_) { other.name_ = 0; }
  GlObject& operator=(GlObject&& other) noexcept {
    const unsigned name = name_;
    name_ = other.name_;
    other.name_ = name;
    return *this;
  }

  /// What OpenGL's functions call it; 0 after it was moved from.
  unsigned name() const noexcept { return name_; }

 private:
  unsigned name_ = 0;
};

using GlBuffer = GlObject<GlKind::Buffer>;
using GlVertexArray = GlObject<GlKind::VertexArray>;
using GlTexture = GlObject<GlKind::Texture>;
using GlFramebuffer = GlObject<GlKind::Framebuffer>;
using GlRenderbuffer = GlObject<GlKind::Renderbuffer>;

}  // namespace hallux::ui

/// What one picture is made in; inside this room only.
///
///     shapes    which point of which bone, and its normal, once a pixel       place, normal, depth, stencil
///     picture   light on bones, ground, tools and all else                    colour, the same depth and stencil
#pragma once

#include "ui/render/gl_objects.h"
#include "ui/render/render_target.h"

namespace hallux::ui {

class PictureBuffers {
 public:
  /// errors  GraphicsError where the driver has no framebuffers of this kind or size
  explicit PictureBuffers(PixelSize size);

  PixelSize size() const noexcept { return size_; }
  unsigned shapes() const noexcept { return shapes_.name(); }
  DrawTarget picture() const noexcept { return {picture_.name(), 0, 0, size_}; }
  unsigned place_texture() const noexcept { return place_.name(); }
  unsigned normal_texture() const noexcept { return normal_.name(); }

 private:
  PixelSize size_;
  GlTexture colour_, place_, normal_;
  GlRenderbuffer depth_;
  GlFramebuffer shapes_, picture_;
};

}  // namespace hallux::ui

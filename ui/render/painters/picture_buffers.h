/// What one picture is made in. Inside this corner only.
///
///     shapes    place, normal, depth, stencil         which point of which bone, and its normal,
///                                                     once a pixel
///     still     colour, the same depth and stencil    ground and light on the bones
///     picture   colour, depth, stencil                begins as a copy of `still`; lines on
///                                                     bones, tools and all else
#pragma once

#include "ui/render/gl/gl_objects.h"
#include "ui/render/gl/render_target.h"

namespace hallux::ui {

class PictureBuffers {
 public:
  /// errors  GraphicsError where the driver has no framebuffers of this kind or size
  explicit PictureBuffers(PixelSize size);

  PixelSize size() const noexcept { return size_; }
  unsigned shapes() const noexcept { return shapes_.name(); }
  DrawTarget still() const noexcept { return {still_.name(), 0, 0, size_}; }
  DrawTarget picture() const noexcept { return {picture_.name(), 0, 0, size_}; }
  unsigned place_texture() const noexcept { return place_.name(); }
  unsigned normal_texture() const noexcept { return normal_.name(); }

  /// Begins the picture with what stands still, depth and stencil with it.
  /// ensures the picture's framebuffer is bound; the scissor is off
  void copy_still_to_picture() const;

 private:
  PixelSize size_;
  GlTexture place_, normal_, still_colour_, colour_;
  GlRenderbuffer still_depth_, depth_;
  GlFramebuffer shapes_, still_, picture_;
};

}  // namespace hallux::ui

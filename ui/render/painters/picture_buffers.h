/// What one picture is made in. Inside this corner only.
///
///     shapes    place, normal, depth, stencil         which point of which bone, and its normal,
///                                                     once a pixel
///     still     colour, the same depth and stencil    ground and light on the bones
///     smooth    colour; only where asked for          `still` with smooth edges; its marks lie in
///                                                     the picture's stencil
///     picture   colour, depth, stencil                begins as a copy of `smooth` or `still`;
///                                                     lines on bones, tools and all else
#pragma once

#include <optional>

#include "ui/render/gl/gl_objects.h"
#include "ui/render/gl/render_target.h"

namespace hallux::ui {

class PictureBuffers {
 public:
  /// errors  GraphicsError where the driver has no framebuffers of this kind or size
  explicit PictureBuffers(PixelSize size, bool has_smooth = false);

  PixelSize size() const noexcept { return size_; }
  unsigned shapes() const noexcept { return shapes_.name(); }
  DrawTarget still() const noexcept { return {still_.name(), 0, 0, size_}; }
  DrawTarget picture() const noexcept { return {picture_.name(), 0, 0, size_}; }
  bool has_smooth() const noexcept { return smooth_.has_value(); }
  /// needs   has_smooth
  DrawTarget smooth() const noexcept { return {smooth_->framebuffer.name(), 0, 0, size_}; }
  unsigned smooth_texture() const noexcept { return smooth_->colour.name(); }
  unsigned still_texture() const noexcept { return still_colour_.name(); }
  unsigned picture_texture() const noexcept { return colour_.name(); }
  unsigned place_texture() const noexcept { return place_.name(); }
  unsigned normal_texture() const noexcept { return normal_.name(); }

  /// Begins the picture with what stands still, depth and stencil with it.
  /// ensures the picture's framebuffer is bound; the scissor is off
  void copy_still_to_picture() const;
  /// The same with the colours of `smooth`.
  /// needs   has_smooth
  void copy_smooth_to_picture() const;

 private:
  struct Smooth {
    GlTexture colour;
    GlFramebuffer framebuffer;
  };

  void copy_to_picture(unsigned colours) const;

  PixelSize size_;
  GlTexture place_, normal_, still_colour_, colour_;
  GlRenderbuffer still_depth_, depth_;
  GlFramebuffer shapes_, still_, picture_;
  std::optional<Smooth> smooth_;
};

}  // namespace hallux::ui

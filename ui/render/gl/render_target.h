/// A picture to draw into: colour as a texture, with depth and stencil beside it.
#pragma once

#include <cstdint>
#include <vector>

#include "ui/render/gl/gl_objects.h"

namespace hallux::ui {

struct PixelSize {
  int width = 0, height = 0;

  friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// Where a picture goes: a framebuffer by OpenGL's name (0: the window's) and the pixels of it that
/// are drawn into.
struct DrawTarget {
  unsigned framebuffer = 0;
  int left = 0, bottom = 0;
  PixelSize size;
};

/// Pixels as they are on a screen: rows from the top, 8 bits each of red, green, blue and opacity,
/// sRGB.
struct Pixels {
  PixelSize size;
  std::vector<std::uint8_t> rgba;
};

class RenderTarget {
 public:
  /// shape   sides of at least one pixel are made of sizes below that
  /// errors  GraphicsError where the driver has no framebuffer of this kind or size
  explicit RenderTarget(PixelSize size);

  PixelSize size() const noexcept { return size_; }
  DrawTarget target() const noexcept { return {framebuffer_.name(), 0, 0, size_}; }
  /// The colour; its first row is the picture's lowest one (ImGui: uv from (0,1) to (1,0)).
  unsigned texture() const noexcept { return colour_.name(); }

  /// needs   drawing is done; waits for it
  Pixels read() const;

 private:
  PixelSize size_;
  GlTexture colour_;
  GlRenderbuffer depth_;
  GlFramebuffer framebuffer_;
};

/// What a target holds.
/// needs   drawing is done; waits for it
Pixels read_pixels(const DrawTarget& target);

/// Copies what is seen; into a target of another size it is scaled linearly.
/// ensures the target's framebuffer is bound afterwards
void copy_picture(const DrawTarget& from, const DrawTarget& to);

/// A size with sides of at least one pixel.
PixelSize at_least_one(PixelSize size) noexcept;
/// Takes the errors that OpenGL has noted; whether there were any.
bool forget_graphics_errors() noexcept;
/// errors  GraphicsError where the bound framebuffer cannot be drawn into, or an error was noted
///         since the last were taken
void check_framebuffer(PixelSize size);

/// Binds a framebuffer, and puts the one that was bound before back at its end, so that making a
/// target disturbs nobody.
class BoundFramebuffer {
 public:
  explicit BoundFramebuffer(unsigned framebuffer);
  ~BoundFramebuffer();
  BoundFramebuffer(const BoundFramebuffer&) = delete;
  BoundFramebuffer& operator=(const BoundFramebuffer&) = delete;

 private:
  int before_ = 0;
};

}  // namespace hallux::ui

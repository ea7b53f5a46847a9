/// A picture to draw into: colour as a texture, with depth beside it.
#pragma once

#include <cstdint>
#include <vector>

#include "ui/render/gl_objects.h"

namespace hallux::ui {

struct PixelSize {
  int width = 0, height = 0;

  friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// Where a picture goes: a framebuffer by OpenGL's name (0: the window's) and the pixels of it that are drawn into.
struct DrawTarget {
  unsigned framebuffer = 0;
  int left = 0, bottom = 0;
  PixelSize size;
};

/// Pixels as they are on a screen: rows from the top, 8 bits each of red, green, blue and opacity, sRGB.
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
  /// Into a target of another size the picture is scaled linearly.
  void copy_into(const DrawTarget& target) const;

 private:
  PixelSize size_;
  GlTexture colour_;
  GlRenderbuffer depth_;
  GlFramebuffer framebuffer_;
};

/// Several samples a pixel, for smooth edges; drawn into, then copied into another target.
class SampledTarget {
 public:
  /// errors  as RenderTarget
  SampledTarget(PixelSize size, int samples);

  PixelSize size() const noexcept { return size_; }
  int samples() const noexcept { return samples_; }
  DrawTarget target() const noexcept { return {framebuffer_.name(), 0, 0, size_}; }
  /// Writes the mean of the samples.
  /// needs   a target of the same size
  void copy_into(const DrawTarget& target) const;

 private:
  PixelSize size_;
  int samples_;
  GlRenderbuffer colour_, depth_;
  GlFramebuffer framebuffer_;
};

}  // namespace hallux::ui

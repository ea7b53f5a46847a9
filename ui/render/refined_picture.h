/// A picture at rest: the mean of samples that differ by less than a pixel, so that edges are as
/// smooth as their number. Inside this corner only.
#pragma once

#include <optional>

#include "ui/render/gl/shader_program.h"
#include "ui/render/renderer.h"
#include "ui/render/rest.h"

namespace hallux::ui {

/// Of each pixel, with those of one picture (RenderQuality::supersampling).
inline constexpr int samples_at_rest = 16;

/// Where a sample is taken, from the middle of a pixel drawn, in those pixels; the first is there.
/// After 4, 7, 10, 13 and 16 the mean of all is the middle again: the picture does not move.
/// needs   number < samples_at_rest
Vec2 sample_place(int number) noexcept;

/// How this machine refines what rests: on a processor one sample a frame once people are at rest,
/// on a graphics card at once.
/// needs   a current context
RestPlan live_rest(const RenderQuality& quality);

/// Lays samples over each other.
class SampleMixer {
 public:
  SampleMixer();

  /// Lays the texture's colours over all of the target, as that share of them.
  void mix(unsigned texture, const DrawTarget& target, double share);

 private:
  ShaderProgram copy_;
  GlVertexArray no_attributes_;
};

class RefinedPicture {
 public:
  /// The first sample begins the picture anew.
  /// errors  GraphicsError where there is no room for it: 8 bytes a pixel
  void begin(SampleMixer& mixer, const RenderTarget& sample);
  /// needs   begun, with a sample of the same size
  void add(SampleMixer& mixer, const RenderTarget& sample);
  /// Shows the mean of all samples.
  /// needs   begun
  /// ensures the target's framebuffer is bound afterwards
  void show(const DrawTarget& target) const;
  void let_go() noexcept { mean_.reset(); }

 private:
  struct Mean {
    explicit Mean(PixelSize of);

    PixelSize size;
    GlTexture colour;
    GlFramebuffer framebuffer;
    int samples = 0;

    DrawTarget target() const noexcept { return {framebuffer.name(), 0, 0, size}; }
  };

  std::optional<Mean> mean_;
};

}  // namespace hallux::ui

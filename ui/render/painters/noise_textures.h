/// The blocks of noise on the graphics card, made once for all painters. Inside this corner only.
#pragma once

#include "ui/render/gl/gl_objects.h"

namespace hallux::ui {

class NoiseTextures {
 public:
  NoiseTextures();

  /// Binds them to their units.
  void bind() const;
  /// See ReliefVolume.
  double slope_scale() const noexcept { return slope_scale_; }

 private:
  GlTexture noise_, relief_;
  double slope_scale_ = 1.0;
};

}  // namespace hallux::ui

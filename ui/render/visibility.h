/// How much is seen of what a surgeon watches: the teeth, and the mouth of the open kerf. Measured
/// on a picture of ids that nobody sees: bones, blade and handpiece as far as they hide what lies
/// behind them; the tips of other tools count as blades, their handles as handpieces.
///
/// A place is seen where nothing in the picture lies clearly before it. A handpiece that is seen
/// through hides nothing where less than half of it is left.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "ui/render/gl/render_target.h"
#include "ui/render/scene/camera.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// One thing at two places of the world, its two sides: it is seen where one of them is.
using SightPlace = std::array<Vec3, 2>;

struct SightSamples {
  /// Along the tooth line; of teeth in or beyond bone, which nobody can see, where their part of
  /// the blade goes in.
  std::vector<SightPlace> teeth_mm;
  /// Along the mouth of what is open, its two rims.
  std::vector<SightPlace> kerf_mm;
};

/// Shares that are seen, 0 to 1; of nothing all is seen.
struct Visibility {
  double tooth_line_share = 1.0, kerf_share = 1.0;
};

/// What hides the samples that are not seen: of each of them its nearest side.
struct Hiders {
  std::size_t bone = 0, blade = 0, handpiece = 0, outside_picture = 0;
};

class SightMeter {
 public:
  /// Counts by the id picture of this size; more pixels tell smaller things apart.
  /// errors  GraphicsError
  explicit SightMeter(PixelSize size = {960, 600});
  ~SightMeter();
  SightMeter(const SightMeter&) = delete;
  SightMeter& operator=(const SightMeter&) = delete;

  /// units   shares of the samples, each counted alike
  /// needs   a current context, also without a window; the view is of a picture of this shape
  /// errors  GraphicsError
  Visibility measure(const Scene& scene, const EyeView& view, const SightSamples& samples);
  /// Of the last measure.
  const Hiders& hiders() const noexcept;
  PixelSize size() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hallux::ui

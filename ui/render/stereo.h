/// Two eyes' pictures become one: each is drawn into a target of its own, then one pass composes
/// them. Panels are drawn into each eye's picture; in an anaglyph once, over both. What moves may
/// be drawn with fewer pixels, the panels never are. Inside this corner only.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ui/render/gl/shader_program.h"
#include "ui/render/refined_picture.h"
#include "ui/render/renderer.h"

namespace hallux::ui {

enum class StereoMode : std::uint8_t {
  Mono,
  /// Each eye in one half, squeezed to half its width.
  SideBySide,
  /// Red and cyan glasses.
  Anaglyph
};

struct StereoSetting {
  StereoMode mode = StereoMode::Mono;
  /// The left eye's picture goes to the right eye.
  bool is_swapped = false;
  Viewer viewer{};
  /// Columns of an anaglyph's eyes over those of the window: more is too much for a processor.
  double eye_columns = 1.0;

  friend bool operator==(const StereoSetting&, const StereoSetting&) = default;
};

/// What this machine draws fast enough: the columns of an anaglyph's eyes, and the detail of a view
/// that moves.
/// needs   a current context
double live_eye_columns();
double live_moving_detail(StereoMode mode);

/// How the colours of an anaglyph follow from those of its two pictures, in linear light.
/// source  Dubois 2001, A projection method to generate anaglyph stereo images; the values for LCDs
///         in common use
struct AnaglyphMatrices {
  Matrix4 shown_from_left{1.0F}, shown_from_right{1.0F};
};
AnaglyphMatrices anaglyph_matrices() noexcept;

class StereoStage {
 public:
  StereoStage();

  /// Prepares the eyes' pictures for a window of this size. In mono there is one eye, Left. With a
  /// detail below 1 they are coarse: they have that share of the window's rows and columns, and are
  /// scaled up when composed.
  /// errors  GraphicsError where there is no room for them
  void begin(const StereoSetting& setting, PixelSize window, double detail = 1.0);
  int eye_count() const noexcept { return setting_.mode == StereoMode::Mono ? 1 : 2; }
  /// The picture of one eye; side by side it has half the window's columns, so what is laid out for
  /// the window must be squeezed to it.
  const RenderTarget& eye(Eye eye) const;
  /// What stands still of that eye's picture.
  KeptPicture& kept(Eye eye) noexcept;
  /// That eye's picture at rest.
  RefinedPicture& refined(Eye eye) noexcept;
  double detail() const noexcept { return detail_; }
  bool is_coarse() const noexcept { return detail_ < 1.0; }
  /// Where panels are drawn, before all is composed: in mono the window itself, where the picture
  /// then is; else each eye's picture, in its whole size; in an anaglyph a transparent one, once
  /// for both eyes: panels lie in the plane of the screen, where both see the same.
  /// needs   the eyes' pictures are drawn
  std::vector<DrawTarget> pictures_for_panels(const DrawTarget& window) const;
  /// What that eye sees through the window.
  EyeView view(Eye eye, const Camera& camera) const noexcept;
  /// Composes the eyes' pictures into the window, or wherever else.
  /// needs   a target of the size that began, for which pictures_for_panels() was called
  void compose(const DrawTarget& window);

  /// All of it, for a scene without panels.
  void draw(Renderer& renderer, const Scene& scene, const Camera& camera,
            const StereoSetting& setting, const DrawTarget& window);

 private:
  struct EyePicture {
    std::optional<RenderTarget> whole, coarse;
    KeptPicture kept_whole, kept_coarse;
    RefinedPicture refined;
  };

  void resize(EyePicture& picture) const;
  const EyePicture& picture_of(Eye eye) const;
  const RenderTarget& whole(Eye eye) const;
  void copy_halves(const DrawTarget& window) const;
  void compose_anaglyph(const DrawTarget& window);

  ShaderProgram anaglyph_;
  GlVertexArray no_attributes_;
  EyePicture left_, right_;
  std::optional<RenderTarget> panels_;
  StereoSetting setting_;
  double detail_ = 1.0;
  PixelSize window_;
};

}  // namespace hallux::ui

/// Two eyes' pictures become one: each is drawn into a target of its own, then one pass composes them. Panels are drawn into
/// each eye's picture; in an anaglyph once, over both.
#pragma once

#include <cstdint>
#include <optional>

#include "ui/render/renderer.h"
#include "ui/render/shader_program.h"

namespace hallux::ui {

enum class StereoMode : std::uint8_t {
  Mono,
  SideBySide,  ///< each eye in one half, squeezed to half its width
  Anaglyph     ///< red and cyan glasses
};

struct StereoSetting {
  StereoMode mode = StereoMode::Mono;
  bool is_swapped = false;  ///< the left eye's picture goes to the right eye
  Viewer viewer{};
  /// Columns of an eye's picture over those of the window, in mono and in an anaglyph: more is too much for a processor.
  double eye_columns = 1.0;
};

/// What this machine draws fast enough of two pictures, or of one that is new all over.
/// needs   a current context
double live_eye_columns();

/// How the colours of an anaglyph follow from those of its two pictures, in linear light.
/// source  Dubois 2001, A projection method to generate anaglyph stereo images; the values for LCDs in common use
struct AnaglyphMatrices {
  Matrix4 shown_from_left{1.0F}, shown_from_right{1.0F};
};
AnaglyphMatrices anaglyph_matrices() noexcept;

class StereoStage {
 public:
  StereoStage();

  /// Prepares the eyes' pictures for a window of this size. In mono there is one eye, Left.
  /// errors  GraphicsError where there is no room for them
  void begin(const StereoSetting& setting, PixelSize window);
  int eye_count() const noexcept { return setting_.mode == StereoMode::Mono ? 1 : 2; }
  /// The picture of one eye; side by side it has half the window's columns, so what is laid out for the window must be
  /// squeezed to it.
  const RenderTarget& eye(Eye eye) const;
  /// What stands still of that eye's picture.
  KeptPicture& kept(Eye eye) noexcept { return eye == Eye::Right ? right_kept_ : left_kept_; }
  /// Whether panels belong into the window after all is composed: the one picture has fewer columns than they need.
  bool panels_come_last() const noexcept;
  /// Where panels are drawn once for both eyes, transparent until then; nullptr where they belong into each eye's picture or come
  /// last. They lie in the plane of the screen, where both eyes see the same.
  const RenderTarget* panels() const noexcept { return panels_ ? &*panels_ : nullptr; }
  /// What that eye sees through the window.
  EyeView view(Eye eye, const Camera& camera) const noexcept;
  /// Composes the eyes' pictures into the window, or wherever else.
  /// needs   a target of the size that began
  void compose(const DrawTarget& window);

  /// All of it, for a scene without panels.
  void draw(Renderer& renderer, const Scene& scene, const Camera& camera,
            const StereoSetting& setting, const DrawTarget& window);

 private:
  void copy_halves(const DrawTarget& window) const;
  void compose_anaglyph(const DrawTarget& window);

  ShaderProgram anaglyph_;
  GlVertexArray no_attributes_;
  std::optional<RenderTarget> left_, right_, panels_;
  KeptPicture left_kept_, right_kept_;
  StereoSetting setting_;
  PixelSize window_;
};

}  // namespace hallux::ui

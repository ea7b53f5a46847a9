/// The fonts of the product at one content scale, with advances of their own.
///
/// Dear ImGui's FreeType builder makes the glyph pictures; where a glyph stands is decided here:
///   - a font's size is its height from ascent to descent in whole device pixels, Inter's em is
///     that by 1.21;
///   - the builder rounds advances to whole pixels, which squeezes small text, so text is laid out
///     with the unrounded advances of FreeType and each glyph is then put on a whole pixel;
///   - Inter's digits differ in width, so all ten take the widest advance and stand in its middle
///     (tabular figures).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ui/widgets/look/icons.h"
#include "ui/widgets/look/type_scale.h"

struct ImFontAtlas;

namespace hallux::ui {

/// Distance of two lines of this type, in logical pixels.
float line_height(Type type) noexcept;

/// A glyph's picture: device pixels from the pen on the baseline, and where it lies in the atlas
/// (0-1).
struct Glyph {
  float left = 0.0F, top = 0.0F, right = 0.0F, bottom = 0.0F;
  float u0 = 0.0F, v0 = 0.0F, u1 = 0.0F, v1 = 0.0F;
  float advance = 0.0F;
  bool is_visible = false;
};

/// One font at one size.
class FontFace {
 public:
  /// The glyph of a code point, or of the question mark where the font has none.
  const Glyph& glyph(char32_t code_point) const noexcept;
  bool has(char32_t code_point) const noexcept;
  /// Device pixels.
  float cap_height() const noexcept { return cap_height_; }
  /// Device pixels, ascent to descent.
  float size() const noexcept { return size_; }
  /// Device pixels, baseline to top.
  float ascent() const noexcept { return ascent_; }

 private:
  friend class FontAtlas;
  std::vector<Glyph> glyphs_;
  /// Code point - first_ -> glyph + 1; 0: the font has none.
  std::vector<std::uint16_t> index_;
  char32_t first_ = 0;
  float cap_height_ = 0.0F, size_ = 0.0F, ascent_ = 0.0F;
};

/// Where the fonts were found; a family that is not installed is replaced by DejaVu Sans, and icons
/// by nothing.
struct FontFiles {
  std::filesystem::path regular, medium, strong, display, icons;
};
/// errors  std::runtime_error with the package to install, where not even DejaVu Sans is there
FontFiles find_fonts();

class FontAtlas {
 public:
  /// Builds every face at `scale` (1 = 100 %) into the atlas of the current ImGui context,
  /// replacing what it held.
  /// needs   an ImGui context; the picture must then be given to the painter again
  /// errors  std::runtime_error where a font file cannot be read
  FontAtlas(ImFontAtlas& atlas, const FontFiles& files, float scale);

  const FontFace& face(Type type) const noexcept { return faces_[static_cast<std::size_t>(type)]; }
  const FontFace& icon_face(IconSize size) const noexcept {
    return icon_faces_[static_cast<std::size_t>(size)];
  }
  float scale() const noexcept { return scale_; }

 private:
  float scale_;
  std::array<FontFace, type_count> faces_;
  std::array<FontFace, 4> icon_faces_;
};

}  // namespace hallux::ui

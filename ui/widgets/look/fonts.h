/// The fonts of the product at one content scale, with advances of their own.
///
/// Dear ImGui's FreeType builder makes the glyph pictures; where a glyph stands is decided here:
///   - a font's size is its height from ascent to descent in whole device pixels, Inter's em is
///     that by 1.21;
///   - the builder rounds advances to whole pixels, which squeezes small text, so text is laid out
///     with the unrounded advances of FreeType and each glyph is then put on a whole pixel;
///   - Inter's digits differ in width, so all ten take the widest advance and stand in its middle
///     (tabular figures).
///
/// The letters that the product itself writes are there from the start. Others are drawn when a
/// text asks for them, into a part of the atlas that is kept free, from Inter or the first other
/// font that has them; a letter that none has is a box with its code. Nothing is shaped: each code
/// point stands by itself, from left to right.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "ui/widgets/look/icons.h"
#include "ui/widgets/look/letter_source.h"
#include "ui/widgets/look/type_scale.h"

struct ImFont;
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
  /// No font has the letter: a box with its code stands for it (code_box.h).
  bool is_box = false;
};

/// One font at one size.
class FontFace {
 public:
  /// The glyph of a code point. One that was never asked for is an empty place until
  /// FontAtlas::load_wanted; one that no font has is a box.
  const Glyph& glyph(char32_t code_point) const noexcept;
  /// Whether it was there from the start.
  bool has(char32_t code_point) const noexcept;
  /// Device pixels.
  float cap_height() const noexcept { return cap_height_; }
  /// Device pixels, ascent to descent.
  float size() const noexcept { return size_; }
  /// Device pixels, baseline to top.
  float ascent() const noexcept { return ascent_; }

 private:
  friend class FontAtlas;
  struct LateGlyph {
    Glyph glyph;
    /// Since the last load_wanted.
    mutable bool is_used = true;
  };
  std::vector<Glyph> glyphs_;
  /// Code point - first_ -> glyph + 1; 0: the font has none.
  std::vector<std::uint16_t> index_;
  char32_t first_ = 0;
  /// What came when a text asked for it.
  std::unordered_map<char32_t, LateGlyph> late_;
  /// Asked for and not there; asking is no change of the face. Its room is taken at the start.
  mutable std::vector<char32_t> wanted_;
  Glyph awaited_;
  float cap_height_ = 0.0F, size_ = 0.0F, ascent_ = 0.0F;
};

/// Where the fonts were found; a family that is not installed is replaced by DejaVu Sans, and icons
/// by nothing.
struct FontFiles {
  std::filesystem::path regular, medium, strong, display, icons;
  /// For letters that those have not, in this order: Noto Sans of all scripts that are installed,
  /// and DejaVu Sans.
  std::vector<std::filesystem::path> others = {};
};
/// errors  std::runtime_error with the package to install, where not even DejaVu Sans is there
FontFiles find_fonts();

class LetterSource;
class LetterShelf;

class FontAtlas {
 public:
  /// Builds every face at `scale` (1 = 100 %) into the atlas of the current ImGui context,
  /// replacing what it held.
  /// needs   an ImGui context; the picture must then be given to the painter again
  /// errors  std::runtime_error where a font file cannot be read
  FontAtlas(ImFontAtlas& atlas, FontFiles files, float scale);
  FontAtlas(const FontAtlas&) = delete;
  FontAtlas& operator=(const FontAtlas&) = delete;
  ~FontAtlas();

  /// Whether texts asked for letters that are not there.
  bool wants_letters() const noexcept;
  /// Draws what texts asked for since the last time. Where there is no room, letters that no text
  /// used since then go; those that still find none are boxes. True where the atlas changed: its
  /// picture must then be given to the painter again.
  bool load_wanted();

  const FontFace& face(Type type) const noexcept { return faces_[static_cast<std::size_t>(type)]; }
  const FontFace& icon_face(IconSize size) const noexcept {
    return icon_faces_[static_cast<std::size_t>(size)];
  }
  float scale() const noexcept { return scale_; }

 private:
  struct Wanted {
    std::size_t type;
    char32_t letter;
  };

  void read_faces(const std::vector<ImFont*>& fonts);
  bool load(const std::vector<Wanted>& wanted, bool is_last_try);
  std::optional<Glyph> drawn(const Wanted& wanted);
  std::vector<Wanted> forget_unused();
  void put(const LetterPicture& picture, int x, int y);

  ImFontAtlas* atlas_;
  FontFiles files_;
  float scale_;
  std::array<FontFace, type_count> faces_;
  std::array<FontFace, 4> icon_faces_;
  std::unique_ptr<LetterSource> letters_;
  std::unique_ptr<LetterShelf> shelf_;
  /// Of the part that is kept free, in the atlas's picture.
  int free_x_ = 0, free_y_ = 0, free_width_ = 0, free_height_ = 0;
};

}  // namespace hallux::ui

// Fonts at one scale: ImGui's builder draws the glyphs, FreeType gives the advances that the
// builder rounds. Sizes are chosen so that capitals and lines fall on device pixels; all digits
// take the widest digit's place, so that numbers do not move while they change.
#include "ui/widgets/look/fonts.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include <imgui.h>
#include <imgui_freetype.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hallux::ui {
namespace {

enum class Cut { Regular, Medium, Strong, Display };

struct TypeSpec {
  Cut cut;
  float size;  ///< logical pixels, ascent to descent
  float line;
  bool is_figure;  ///< only basic Latin
};

constexpr std::array<TypeSpec, type_count> type_specs{{
    {Cut::Regular, 15, 18, false},
    {Cut::Medium, 15, 18, false},
    {Cut::Regular, 16, 20, false},
    {Cut::Medium, 16, 20, false},
    {Cut::Regular, 17, 24, false},
    {Cut::Medium, 17, 24, false},
    {Cut::Strong, 17, 24, false},
    {Cut::Strong, 19, 24, false},
    {Cut::Display, 24, 30, false},
    {Cut::Display, 32, 40, false},
    {Cut::Display, 36, 44, true},
    {Cut::Display, 58, 64, true},
}};
constexpr std::array<float, 4> icon_sizes{13, 16, 20, 30};

// Inter's size from ascent to descent is 1.21 em, its capitals are 0.727 em high.
constexpr float em_per_size = 1.0F / 1.21F, capital_per_em = 0.727F;

constexpr std::array<ImWchar, 23> text_ranges{
    0x20,   0x17F,  0x391,  0x3C9,  0x400,  0x45F,  0x2009, 0x2030, 0x2190, 0x2193, 0x2206,
    0x2206, 0x2212, 0x2212, 0x2248, 0x2248, 0x2264, 0x2265, 0x25CF, 0x25CF, 0};
constexpr std::array<ImWchar, 9> figure_ranges{0x20,   0x7E,   0xB0,   0xB1, 0x2009,
                                               0x2026, 0x2212, 0x2212, 0};

std::vector<ImWchar> icon_ranges() {
  std::vector<ImWchar> ranges;
  for (const Icon icon : all_icons) ranges.insert(ranges.end(), 2, static_cast<ImWchar>(icon));
  ranges.push_back(0);
  return ranges;
}

const std::filesystem::path& file_of(const FontFiles& files, Cut cut) {
  switch (cut) {
    case Cut::Medium:
      return files.medium;
    case Cut::Strong:
      return files.strong;
    case Cut::Display:
      return files.display;
    case Cut::Regular:
      break;
  }
  return files.regular;
}

// FreeType itself, for the advances that the builder rounds.
class Outline {
 public:
  Outline(const std::filesystem::path& file, float size) {
    if (FT_Init_FreeType(&library_) != 0) throw std::runtime_error("FreeType does not start");
    if (FT_New_Face(library_, file.c_str(), 0, &face_) != 0) {
      FT_Done_FreeType(library_);
      throw std::runtime_error(file.string() + ": is not a font; install fonts-inter again");
    }
    FT_Size_RequestRec request{};
    request.type = FT_SIZE_REQUEST_TYPE_REAL_DIM;
    request.height = static_cast<FT_Long>(size) * 64;
    FT_Request_Size(face_, &request);
  }
  Outline(const Outline&) = delete;
  Outline& operator=(const Outline&) = delete;
  ~Outline() {
    FT_Done_Face(face_);
    FT_Done_FreeType(library_);
  }

  /// The advance in device pixels, unrounded; `otherwise` where the font has no such glyph.
  float advance(char32_t code_point, float otherwise) const {
    if (FT_Load_Char(face_, code_point, FT_LOAD_NO_HINTING) != 0) return otherwise;
    return static_cast<float>(face_->glyph->linearHoriAdvance) / 65536.0F;
  }

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

Glyph glyph_of(const ImFontGlyph& drawn, float ascent) {
  Glyph glyph;
  glyph.left = drawn.X0, glyph.right = drawn.X1;
  glyph.top = drawn.Y0 - ascent, glyph.bottom = drawn.Y1 - ascent;
  glyph.u0 = drawn.U0, glyph.v0 = drawn.V0, glyph.u1 = drawn.U1, glyph.v1 = drawn.V1;
  glyph.advance = drawn.AdvanceX;
  glyph.is_visible = drawn.Visible != 0;
  return glyph;
}

std::filesystem::path first_existing(std::initializer_list<const char*> candidates) {
  for (const char* candidate : candidates)
    if (std::filesystem::exists(candidate)) return candidate;
  return {};
}

std::filesystem::path inter(const std::string& name, const char* fallback) {
  const std::filesystem::path file = "/usr/share/fonts/opentype/inter/" + name;
  return std::filesystem::exists(file) ? file : first_existing({fallback});
}

ImFont* add_font(ImFontAtlas& atlas, const std::filesystem::path& file, float size,
                 const ImWchar* ranges) {
  ImFontConfig config;
  config.OversampleH = 1;
  ImFont* font = atlas.AddFontFromFileTTF(file.c_str(), size, &config, ranges);
  if (font == nullptr)
    throw std::runtime_error(file.string() + ": cannot be read; install fonts-inter again");
  return font;
}

}  // namespace

float line_height(Type type) noexcept { return type_specs[static_cast<std::size_t>(type)].line; }

bool FontFace::has(char32_t code_point) const noexcept {
  return code_point >= first_ && code_point - first_ < index_.size() &&
         index_[code_point - first_] != 0;
}

const Glyph& FontFace::glyph(char32_t code_point) const noexcept {
  if (!has(code_point)) code_point = has(U'?') ? U'?' : first_;
  return glyphs_[index_[code_point - first_] - 1U];
}

FontFiles find_fonts() {
  constexpr const char* sans = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  constexpr const char* sans_bold = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";
  FontFiles files;
  files.regular = inter("Inter-Regular.otf", sans);
  files.medium = inter("Inter-Medium.otf", sans);
  files.strong = inter("Inter-SemiBold.otf", sans_bold);
  files.display = inter("InterDisplay-SemiBold.otf", sans_bold);
  files.icons = first_existing({"/usr/share/fonts/truetype/font-awesome/fontawesome-webfont.ttf",
                                "/usr/share/fonts-font-awesome/fonts/fontawesome-webfont.ttf"});
  if (files.regular.empty() || files.strong.empty())
    throw std::runtime_error(
        "No font was found. Install one: apt-get install fonts-inter fonts-dejavu-core");
  return files;
}

// The faces are read off the atlas after it was built: ImGui's own lookup keeps rounded advances.
class FaceReader {
 public:
  static void fill(std::vector<Glyph>& glyphs, std::vector<std::uint16_t>& index, char32_t& first,
                   const ImFont& font, const Outline* outline) {
    char32_t low = 0xFFFF, high = 0;
    for (const ImFontGlyph& drawn : font.Glyphs) {
      low = std::min<char32_t>(low, drawn.Codepoint);
      high = std::max<char32_t>(high, drawn.Codepoint);
    }
    first = low;
    index.assign(high >= low ? high - low + 1U : 0U, 0);
    for (const ImFontGlyph& drawn : font.Glyphs) {
      glyphs.push_back(glyph_of(drawn, font.Ascent));
      if (outline != nullptr)
        glyphs.back().advance = outline->advance(drawn.Codepoint, glyphs.back().advance);
      index[drawn.Codepoint - low] = static_cast<std::uint16_t>(glyphs.size());
    }
  }

  static void make_digits_tabular(std::vector<Glyph>& glyphs,
                                  const std::vector<std::uint16_t>& index, char32_t first) {
    const auto each_digit = [&](auto&& act) {
      for (char32_t digit = U'0'; digit <= U'9'; ++digit)
        if (digit >= first && digit - first < index.size() && index[digit - first] != 0)
          act(glyphs[index[digit - first] - 1U]);
    };
    float widest = 0.0F;
    each_digit([&](const Glyph& glyph) { widest = std::max(widest, glyph.advance); });
    widest = std::round(widest);
    each_digit([&](Glyph& glyph) {
      // A digit a little wider than its place must not lean over the space before it.
      const float shift = std::round((widest - glyph.advance) / 2.0F);
      glyph.left += shift;
      glyph.right += shift;
      glyph.advance = widest;
    });
  }
};

FontAtlas::FontAtlas(ImFontAtlas& atlas, const FontFiles& files, float scale) : scale_(scale) {
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.TexGlyphPadding = 1;
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  atlas.TexDesiredWidth = scale > 1.25F ? 4096 : 2048;
  std::vector<ImFont*> fonts;
  for (const TypeSpec& spec : type_specs)
    fonts.push_back(add_font(atlas, file_of(files, spec.cut), std::round(spec.size * scale),
                             spec.is_figure ? figure_ranges.data() : text_ranges.data()));
  const std::vector<ImWchar> icons = icon_ranges();
  for (const float size : icon_sizes)
    fonts.push_back(files.icons.empty()
                        ? fonts.front()
                        : add_font(atlas, files.icons, std::round(size * scale), icons.data()));
  if (!atlas.Build())
    throw std::runtime_error("The fonts could not be built at this content scale");
  for (std::size_t type = 0; type < faces_.size(); ++type) {
    FontFace& face = faces_[type];
    face.size_ = fonts[type]->FontSize;
    face.ascent_ = fonts[type]->Ascent;
    face.cap_height_ = face.size_ * em_per_size * capital_per_em;
    const Outline outline(file_of(files, type_specs[type].cut), face.size_);
    FaceReader::fill(face.glyphs_, face.index_, face.first_, *fonts[type], &outline);
    FaceReader::make_digits_tabular(face.glyphs_, face.index_, face.first_);
  }
  for (std::size_t size = 0; size < icon_faces_.size(); ++size) {
    FontFace& face = icon_faces_[size];
    const ImFont& font = *fonts[faces_.size() + size];
    face.size_ = font.FontSize;
    face.ascent_ = font.Ascent;
    FaceReader::fill(face.glyphs_, face.index_, face.first_, font, nullptr);
  }
}

}  // namespace hallux::ui

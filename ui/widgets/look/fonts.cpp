// Fonts at one scale: ImGui's builder draws the glyphs, FreeType gives the advances that the
// builder rounds. Sizes are chosen so that capitals and lines fall on device pixels; all digits
// take the widest digit's place, so that numbers do not move while they change. Letters that the
// product does not write itself come into a part of the atlas that the builder keeps free: drawing
// one takes well below a millisecond, building the atlas anew would take a hundred.
#include "ui/widgets/look/fonts.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include <imgui.h>
#include <imgui_freetype.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ui/widgets/look/code_box.h"
#include "ui/widgets/look/letter_shelf.h"

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

// Room for letters that come later, in logical pixels: some thousand at the size of a text.
constexpr float free_width = 1024.0F, free_height = 512.0F;
// Of one face between two frames; more come with the next frame.
constexpr std::size_t wanted_at_once = 256;
// Letters of all faces, boxes too, before those that nothing uses any more go.
constexpr std::size_t late_most = 4096;
constexpr float awaited_per_em = 0.6F;

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

namespace {

/// A box as wide as its code: two lines of two or of three digits.
Glyph box_glyph(const FontFace& face, char32_t code_point) {
  Glyph box;
  box.is_visible = box.is_box = true;
  box.advance = code_box_advance(face.size(), code_point);
  return box;
}

}  // namespace

bool FontFace::has(char32_t code_point) const noexcept {
  return code_point >= first_ && code_point - first_ < index_.size() &&
         index_[code_point - first_] != 0;
}

const Glyph& FontFace::glyph(char32_t code_point) const noexcept {
  // In one line, a new line and a tab are a space.
  if (code_point == U'\n' || code_point == U'\t') code_point = U' ';
  if (has(code_point)) return glyphs_[index_[code_point - first_] - 1U];
  if (const auto late = late_.find(code_point); late != late_.end()) {
    late->second.is_used = true;
    return late->second.glyph;
  }
  if (wanted_.size() < wanted_.capacity() &&
      std::find(wanted_.begin(), wanted_.end(), code_point) == wanted_.end())
    wanted_.push_back(code_point);
  return awaited_;
}

namespace {

/// Noto Sans of every script that is installed, without the widths and weights that repeat Latin.
void add_noto(std::vector<std::filesystem::path>& fonts) {
  std::vector<std::filesystem::path> found;
  for (const char* folder : {"/usr/share/fonts/truetype/noto", "/usr/share/fonts/opentype/noto"}) {
    std::error_code fault;
    for (const auto& entry : std::filesystem::directory_iterator(folder, fault)) {
      const std::string name = entry.path().filename().string();
      const bool is_plain =
          name.starts_with("NotoSans") && name.find("-Regular.") != std::string::npos &&
          !name.starts_with("NotoSansMono") && !name.starts_with("NotoSansDisplay");
      if (is_plain) found.push_back(entry.path());
    }
  }
  std::sort(found.begin(), found.end());
  fonts.insert(fonts.end(), found.begin(), found.end());
}

}  // namespace

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
  add_noto(files.others);
  if (std::filesystem::exists(sans)) files.others.emplace_back(sans);
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

FontAtlas::FontAtlas(ImFontAtlas& atlas, FontFiles files, float scale)
    : atlas_(&atlas),
      files_(std::move(files)),
      scale_(scale),
      letters_(std::make_unique<LetterSource>()),
      free_width_(static_cast<int>(free_width * scale)),
      free_height_(static_cast<int>(free_height * scale)) {
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.TexGlyphPadding = 1;
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  atlas.TexDesiredWidth = scale > 1.25F ? 4096 : 2048;
  std::vector<ImFont*> fonts;
  fonts.reserve(std::size(type_specs) + std::size(icon_sizes));
  for (const TypeSpec& spec : type_specs)
    fonts.push_back(add_font(atlas, file_of(files_, spec.cut), std::round(spec.size * scale),
                             spec.is_figure ? figure_ranges.data() : text_ranges.data()));
  const std::vector<ImWchar> icons = icon_ranges();
  for (const float size : icon_sizes)
    fonts.push_back(files_.icons.empty()
                        ? fonts.front()
                        : add_font(atlas, files_.icons, std::round(size * scale), icons.data()));
  const int kept_free = atlas.AddCustomRectRegular(free_width_, free_height_);
  if (!atlas.Build())
    throw std::runtime_error("The fonts could not be built at this content scale");
  const ImFontAtlasCustomRect* rect = atlas.GetCustomRectByIndex(kept_free);
  free_x_ = rect->X, free_y_ = rect->Y;
  shelf_ = std::make_unique<LetterShelf>(free_width_, free_height_);
  read_faces(fonts);
}

FontAtlas::~FontAtlas() = default;

void FontAtlas::read_faces(const std::vector<ImFont*>& fonts) {
  for (std::size_t type = 0; type < faces_.size(); ++type) {
    FontFace& face = faces_[type];
    face.size_ = fonts[type]->FontSize;
    face.ascent_ = fonts[type]->Ascent;
    face.cap_height_ = face.size_ * em_per_size * capital_per_em;
    face.awaited_.advance = face.size_ * em_per_size * awaited_per_em;
    face.wanted_.reserve(wanted_at_once);
    const Outline outline(file_of(files_, type_specs[type].cut), face.size_);
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

bool FontAtlas::wants_letters() const noexcept {
  return std::any_of(faces_.begin(), faces_.end(),
                     [](const FontFace& face) { return !face.wanted_.empty(); });
}

bool FontAtlas::load_wanted() {
  std::vector<Wanted> wanted;
  for (std::size_t type = 0; type < faces_.size(); ++type) {
    for (const char32_t letter : faces_[type].wanted_) wanted.push_back({type, letter});
    faces_[type].wanted_.clear();
  }
  const bool has_wanted = !wanted.empty();
  if (has_wanted && !load(wanted, false)) {
    std::vector<Wanted> all = forget_unused();
    all.insert(all.end(), wanted.begin(), wanted.end());
    load(all, true);
  }
  for (const FontFace& face : faces_)
    for (const auto& [letter, late] : face.late_) late.is_used = false;
  return has_wanted;
}

/// False where there was no room and it is not the last try; in the last one, what finds none is a
/// box.
bool FontAtlas::load(const std::vector<Wanted>& wanted, bool is_last_try) {
  std::size_t count = wanted.size();
  for (const FontFace& face : faces_) count += face.late_.size();
  if (count > late_most && !is_last_try) return false;
  for (const Wanted& each : wanted) {
    FontFace& face = faces_[each.type];
    if (face.late_.contains(each.letter)) continue;
    std::optional<Glyph> glyph = drawn(each);
    if (!glyph && !is_last_try) return false;
    face.late_[each.letter] = {glyph ? *glyph : box_glyph(face, each.letter)};
  }
  return true;
}

/// Nothing where there is no room for it.
std::optional<Glyph> FontAtlas::drawn(const Wanted& wanted) {
  const FontFace& face = faces_[wanted.type];
  std::vector<std::filesystem::path> files{file_of(files_, type_specs[wanted.type].cut)};
  files.insert(files.end(), files_.others.begin(), files_.others.end());
  const std::filesystem::path* file = letters_->file_with(wanted.letter, files);
  if (file == nullptr) return box_glyph(face, wanted.letter);
  const LetterPicture picture = letters_->draw(*file, wanted.letter, face.size_ * em_per_size);
  Glyph glyph;
  glyph.advance = picture.advance;
  if (picture.coverage.empty()) return glyph;
  const auto place = shelf_->take(picture.width, picture.height);
  if (!place) return std::nullopt;
  const int x = free_x_ + place->x, y = free_y_ + place->y;
  put(picture, x, y);
  const auto width = static_cast<float>(atlas_->TexWidth),
             height = static_cast<float>(atlas_->TexHeight);
  glyph.left = static_cast<float>(picture.left), glyph.top = static_cast<float>(picture.top);
  glyph.right = glyph.left + static_cast<float>(picture.width);
  glyph.bottom = glyph.top + static_cast<float>(picture.height);
  glyph.u0 = static_cast<float>(x) / width, glyph.v0 = static_cast<float>(y) / height;
  glyph.u1 = static_cast<float>(x + picture.width) / width;
  glyph.v1 = static_cast<float>(y + picture.height) / height;
  glyph.is_visible = true;
  return glyph;
}

/// The builder made the picture as coverage; the painter has it in colours as well.
void FontAtlas::put(const LetterPicture& picture, int x, int y) {
  auto* const pixels = static_cast<std::uint8_t*>(atlas_->TexPixelsAlpha8);
  unsigned* const colors = atlas_->TexPixelsRGBA32;
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      const auto in_picture =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
          static_cast<std::size_t>(column);
      const std::uint8_t cover = picture.coverage[in_picture];
      const int at = (y + row) * atlas_->TexWidth + x + column;
      if (pixels != nullptr) pixels[at] = cover;
      if (colors != nullptr) colors[at] = IM_COL32(255, 255, 255, cover);
    }
  }
}

/// All late letters go; returned are those that a text used since the last load_wanted.
std::vector<FontAtlas::Wanted> FontAtlas::forget_unused() {
  std::vector<Wanted> used;
  for (std::size_t type = 0; type < faces_.size(); ++type) {
    for (const auto& [letter, late] : faces_[type].late_)
      if (late.is_used) used.push_back({type, letter});
    faces_[type].late_.clear();
  }
  shelf_->clear();
  return used;
}

}  // namespace hallux::ui

// FreeType faces, each opened when a letter is first looked for in it, and kept: a name in another
// script comes with the letters of its neighbours. A font of pictures (colour emoji) has no
// outlines and counts as one that has no letters.
#include "ui/widgets/look/letter_source.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <cmath>
#include <map>
#include <stdexcept>

namespace hallux::ui {

struct LetterSource::Faces {
  FT_Library library = nullptr;
  /// Null: no font that can be drawn in any size.
  std::map<std::filesystem::path, FT_Face> by_file;

  FT_Face opened(const std::filesystem::path& file) {
    const auto [known, is_new] = by_file.try_emplace(file, nullptr);
    if (!is_new) return known->second;
    FT_Face face = nullptr;
    if (FT_New_Face(library, file.c_str(), 0, &face) != 0) return nullptr;
    if (FT_IS_SCALABLE(face) == 0) {
      FT_Done_Face(face);
      return nullptr;
    }
    return known->second = face;
  }
};

LetterSource::LetterSource() : faces_(std::make_unique<Faces>()) {
  if (FT_Init_FreeType(&faces_->library) != 0)
    throw std::runtime_error("FreeType does not start; install libfreetype6 again");
}

LetterSource::~LetterSource() {
  for (const auto& [file, face] : faces_->by_file)
    if (face != nullptr) FT_Done_Face(face);
  FT_Done_FreeType(faces_->library);
}

const std::filesystem::path* LetterSource::file_with(char32_t letter,
                                                     std::span<const std::filesystem::path> files) {
  for (const std::filesystem::path& file : files) {
    const FT_Face face = faces_->opened(file);
    if (face != nullptr && FT_Get_Char_Index(face, letter) != 0) return &file;
  }
  return nullptr;
}

LetterPicture LetterSource::draw(const std::filesystem::path& file, char32_t letter, float em) {
  LetterPicture picture;
  const FT_Face face = faces_->opened(file);
  FT_Size_RequestRec request{};
  request.type = FT_SIZE_REQUEST_TYPE_NOMINAL;
  request.height = static_cast<FT_Long>(std::lround(em * 64.0F));
  if (face == nullptr || FT_Request_Size(face, &request) != 0 ||
      FT_Load_Char(face, letter, FT_LOAD_NO_BITMAP | FT_LOAD_TARGET_NORMAL) != 0 ||
      FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL) != 0)
    return picture;
  const FT_GlyphSlot slot = face->glyph;
  picture.advance = static_cast<float>(slot->linearHoriAdvance) / 65536.0F;
  picture.left = slot->bitmap_left;
  picture.top = -slot->bitmap_top;
  picture.width = static_cast<int>(slot->bitmap.width);
  picture.height = static_cast<int>(slot->bitmap.rows);
  const std::size_t width = slot->bitmap.width;
  picture.coverage.reserve(width * slot->bitmap.rows);
  for (int row = 0; row < picture.height; ++row) {
    const std::uint8_t* begin = slot->bitmap.buffer + row * slot->bitmap.pitch;
    picture.coverage.insert(picture.coverage.end(), begin, begin + width);
  }
  return picture;
}

}  // namespace hallux::ui

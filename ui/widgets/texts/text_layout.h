/// Where the letters of a text stand: measuring, shortening and breaking into lines. Sizes are
/// device pixels.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/look/fonts.h"

namespace hallux::ui {

/// The code point that begins at `place` in UTF-8, and moves `place` behind it; U+FFFD for a broken
/// one.
char32_t next_code_point(std::string_view text, std::size_t& place) noexcept;

/// Byte offsets of the code points before and after `place`; 0 and the length at the ends.
std::size_t previous_place(std::string_view text, std::size_t place) noexcept;
std::size_t following_place(std::string_view text, std::size_t place) noexcept;

/// Appends `code_point` in UTF-8; what is no Unicode scalar value is left out.
void append_code_point(std::string& text, char32_t code_point);

/// Width of one line, unrounded.
float text_width(const FontFace& face, std::string_view text) noexcept;

/// `text` itself, or its longest beginning that fits into `width` with an ellipsis behind it.
std::string shortened(const FontFace& face, std::string_view text, float width);

/// The byte offset between two letters that lies nearest to `x`.
std::size_t place_at(const FontFace& face, std::string_view text, float x) noexcept;

/// A line of a broken text: bytes [begin, end) of it; the space or newline it was broken at is left
/// out.
struct TextLine {
  std::size_t begin = 0, end = 0;
};

/// `text` broken at spaces and newlines so that no line is wider than `width`; a word that is, is
/// broken inside.
/// ensures at least one line, also for an empty text; the lines in order cover all but the breaking
///         spaces
std::vector<TextLine> broken_lines(const FontFace& face, std::string_view text, float width);

}  // namespace hallux::ui

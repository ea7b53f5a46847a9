/// The box that stands for a letter which no font has: its code in small digits, two lines of two,
/// beyond U+FFFF of three. Nobody reads it, but two different letters look different and nothing is
/// taken for a question mark.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace hallux::ui {

/// A part of the box in its own small pixels, from its upper left corner.
struct CodeBoxPart {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Device pixels of one small pixel in a font of that size (ascent to descent).
int code_box_pixel(float font_size) noexcept;
/// Small pixels.
int code_box_width(char32_t code_point) noexcept;
inline constexpr int code_box_height = 15;
/// Device pixels from the pen to the next letter.
float code_box_advance(float font_size, char32_t code_point) noexcept;
/// Frame and digits.
std::vector<CodeBoxPart> code_box_parts(char32_t code_point);

}  // namespace hallux::ui

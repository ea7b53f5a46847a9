#include "ui/widgets/look/code_box.h"

#include <algorithm>
#include <cmath>

namespace hallux::ui {

namespace {

constexpr int digit_width = 3, digit_height = 5, frame = 1, padding = 1, digit_gap = 1;
constexpr float pixels_per_em = 15.0F;

/// Rows of three from the top, the highest bit first.
constexpr std::array<std::uint16_t, 16> digits{
    0b111'101'101'101'111, 0b010'110'010'010'111, 0b111'001'111'100'111, 0b111'001'111'001'111,
    0b101'101'111'001'001, 0b111'100'111'001'111, 0b111'100'111'101'111, 0b111'001'010'010'010,
    0b111'101'111'101'111, 0b111'101'111'001'111, 0b010'101'111'101'101, 0b110'101'110'101'110,
    0b111'100'100'100'111, 0b110'101'101'101'110, 0b111'100'111'100'111, 0b111'100'111'100'100};

int digits_in_line(char32_t code_point) noexcept { return code_point > 0xFFFF ? 3 : 2; }

void add_digit(std::vector<CodeBoxPart>& parts, std::uint16_t rows, int left, int top) {
  for (int row = 0; row < digit_height; ++row) {
    for (int column = 0; column < digit_width; ++column) {
      const int bit = (digit_height - 1 - row) * digit_width + digit_width - 1 - column;
      if ((rows >> bit & 1) != 0) parts.push_back({left + column, top + row, 1, 1});
    }
  }
}

}  // namespace

int code_box_pixel(float font_size) noexcept {
  return std::max(1, static_cast<int>(std::floor(font_size / pixels_per_em)));
}

int code_box_width(char32_t code_point) noexcept {
  const int count = digits_in_line(code_point);
  return 2 * (frame + padding) + count * digit_width + (count - 1) * digit_gap;
}

float code_box_advance(float font_size, char32_t code_point) noexcept {
  return static_cast<float>(code_box_pixel(font_size) * (code_box_width(code_point) + 2));
}

std::vector<CodeBoxPart> code_box_parts(char32_t code_point) {
  const int width = code_box_width(code_point), height = code_box_height;
  std::vector<CodeBoxPart> parts{{0, 0, width, frame},
                                 {0, height - frame, width, frame},
                                 {0, frame, frame, height - 2 * frame},
                                 {width - frame, frame, frame, height - 2 * frame}};
  const int in_line = digits_in_line(code_point);
  for (int place = 0; place < 2 * in_line; ++place) {
    const auto shift = static_cast<unsigned>(4 * (2 * in_line - 1 - place));
    const int left = frame + padding + place % in_line * (digit_width + digit_gap);
    const int top = frame + padding + place / in_line * (digit_height + digit_gap);
    add_digit(parts, digits[code_point >> shift & 0xFU], left, top);
  }
  return parts;
}

}  // namespace hallux::ui

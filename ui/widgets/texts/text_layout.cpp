// Letters by their own advances: UTF-8 is walked code point by code point, lines are broken at
// spaces and, where a word alone is too long, inside it. A text that is shortened keeps its
// beginning. A broken byte counts as one letter of its own, so that damaged text can be measured
// and edited like any other.
#include "ui/widgets/texts/text_layout.h"

namespace hallux::ui {
namespace {

constexpr std::string_view ellipsis = "\xE2\x80\xA6";
constexpr char32_t broken = 0xFFFD;

bool is_continuation(char byte) noexcept {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

// How many bytes a code point takes by its first byte; 0 for a byte that begins none.
std::size_t length_of(unsigned char first) noexcept {
  if (first < 0x80U) return 1;
  if (first >= 0xC2U && first < 0xE0U) return 2;
  if (first >= 0xE0U && first < 0xF0U) return 3;
  if (first >= 0xF0U && first < 0xF5U) return 4;
  return 0;
}

// The longest beginning of [begin, end) that fits, at least one code point.
std::size_t fitting_end(const FontFace& face, std::string_view text, TextLine word, float width) {
  float used = 0.0F;
  std::size_t place = word.begin;
  while (place < word.end) {
    const std::size_t start = place;
    used += face.glyph(next_code_point(text, place)).advance;
    if (used > width && start > word.begin) return start;
  }
  return word.end;
}

}  // namespace

char32_t next_code_point(std::string_view text, std::size_t& place) noexcept {
  const auto first = static_cast<unsigned char>(text[place]);
  const std::size_t length = length_of(first);
  if (length == 0 || place + length > text.size()) {
    ++place;
    return broken;
  }
  constexpr unsigned masks[] = {0U, 0x7FU, 0x1FU, 0x0FU, 0x07U};
  char32_t result = first & masks[length];
  for (std::size_t k = 1; k < length; ++k) {
    if (!is_continuation(text[place + k])) {
      ++place;
      return broken;
    }
    result = result << 6U | (static_cast<unsigned char>(text[place + k]) & 0x3FU);
  }
  place += length;
  return result;
}

std::size_t previous_place(std::string_view text, std::size_t place) noexcept {
  if (place == 0) return 0;
  --place;
  while (place > 0 && is_continuation(text[place])) --place;
  return place;
}

std::size_t following_place(std::string_view text, std::size_t place) noexcept {
  if (place >= text.size()) return text.size();
  ++place;
  while (place < text.size() && is_continuation(text[place])) ++place;
  return place;
}

void append_code_point(std::string& text, char32_t code_point) {
  const auto add = [&](char32_t byte) {
    text.push_back(static_cast<char>(static_cast<unsigned char>(byte)));
  };
  if (code_point < 0x80) {
    add(code_point);
  } else if (code_point < 0x800) {
    add(0xC0U | code_point >> 6U), add(0x80U | (code_point & 0x3FU));
  } else if (code_point < 0x10000) {
    if (code_point >= 0xD800 && code_point < 0xE000) return;
    add(0xE0U | code_point >> 12U), add(0x80U | (code_point >> 6U & 0x3FU)),
        add(0x80U | (code_point & 0x3FU));
  } else if (code_point < 0x110000) {
    add(0xF0U | code_point >> 18U), add(0x80U | (code_point >> 12U & 0x3FU));
    add(0x80U | (code_point >> 6U & 0x3FU)), add(0x80U | (code_point & 0x3FU));
  }
}

float text_width(const FontFace& face, std::string_view text) noexcept {
  float width = 0.0F;
  for (std::size_t place = 0; place < text.size();)
    width += face.glyph(next_code_point(text, place)).advance;
  return width;
}

std::string shortened(const FontFace& face, std::string_view text, float width) {
  if (text_width(face, text) <= width) return std::string(text);
  const float room = width - text_width(face, ellipsis);
  float used = 0.0F;
  std::size_t end = 0;
  for (std::size_t place = 0; place < text.size();) {
    used += face.glyph(next_code_point(text, place)).advance;
    if (used > room) break;
    end = place;
  }
  while (end > 0 && text[end - 1] == ' ') --end;
  return std::string(text.substr(0, end)).append(ellipsis);
}

std::size_t place_at(const FontFace& face, std::string_view text, float x) noexcept {
  float pen = 0.0F;
  for (std::size_t place = 0; place < text.size();) {
    const std::size_t start = place;
    const float advance = face.glyph(next_code_point(text, place)).advance;
    if (x < pen + advance / 2.0F) return start;
    pen += advance;
  }
  return text.size();
}

std::vector<TextLine> broken_lines(const FontFace& face, std::string_view text, float width) {
  std::vector<TextLine> lines;
  TextLine line{0, 0};
  std::size_t place = 0;
  while (place < text.size()) {
    if (text[place] == '\n') {
      lines.push_back(line);
      ++place;
      line = {place, place};
      continue;
    }
    std::size_t word_end = place;
    while (word_end < text.size() && text[word_end] == ' ') ++word_end;
    const std::size_t word = word_end;
    while (word_end < text.size() && text[word_end] != ' ' && text[word_end] != '\n') ++word_end;
    if (text_width(face, text.substr(line.begin, word_end - line.begin)) <= width) {
      line.end = place = word_end;
      continue;
    }
    if (line.end > line.begin) {  // the word goes to a line of its own
      lines.push_back(line);
      line = {word, word};
      place = word;
      continue;
    }
    line.end = fitting_end(face, text, {line.begin, word_end}, width);
    place = line.end;
    if (place < word_end) {
      lines.push_back(line);
      line = {place, place};
    }
  }
  lines.push_back(line);
  return lines;
}

}  // namespace hallux::ui

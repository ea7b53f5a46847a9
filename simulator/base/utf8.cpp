#include "simulator/base/utf8.h"

namespace hallux {

Character first_character(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80U) return {lead, 1};
  const std::size_t count = lead >= 0xF0U ? 4 : lead >= 0xE0U ? 3 : 2;
  if (lead < 0xC2U || lead > 0xF4U || text.size() < count) return {};
  std::uint32_t value = lead & (0x7FU >> count);
  for (std::size_t i = 1; i < count; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    value = (value << 6U) | (byte(i) & 0x3FU);
  }
  const bool is_overlong = (count == 3 && value < 0x800U) || (count == 4 && value < 0x10000U);
  const bool is_surrogate = value >= 0xD800U && value <= 0xDFFFU;
  if (is_overlong || is_surrogate || value > 0x10FFFFU) return {};
  return {value, count};
}

bool is_utf8(std::string_view text) noexcept {
  while (!text.empty()) {
    const Character character = first_character(text);
    if (character.byte_count == 0) return false;
    text.remove_prefix(character.byte_count);
  }
  return true;
}

bool is_control(std::uint32_t character) noexcept {
  return character < 0x20U || (character >= 0x7FU && character < 0xA0U);
}

bool turns_direction(std::uint32_t character) noexcept {
  return (character >= 0x202AU && character <= 0x202EU) ||
         (character >= 0x2066U && character <= 0x2069U);
}

bool has_hidden_letters(std::string_view text) noexcept {
  while (!text.empty()) {
    const Character character = first_character(text);
    const bool is_blank = character.value == '\n' || character.value == '\t';
    if (turns_direction(character.value) || (is_control(character.value) && !is_blank)) return true;
    text.remove_prefix(character.byte_count == 0 ? 1 : character.byte_count);
  }
  return false;
}

void append_utf8(std::string& text, std::uint32_t character) {
  const auto put = [&](std::uint32_t lead, unsigned continuations) {
    text += static_cast<char>(lead | character >> (6U * continuations));
    for (unsigned i = continuations; i > 0; --i) {
      text += static_cast<char>(0x80U | (character >> (6U * (i - 1)) & 0x3FU));
    }
  };
  if (character < 0x80) return put(0, 0);
  if (character < 0x800) return put(0xC0, 1);
  const bool is_surrogate = character >= 0xD800 && character <= 0xDFFF;
  if (is_surrogate || character > 0x10FFFF) return;
  character < 0x10000 ? put(0xE0, 2) : put(0xF0, 3);
}

std::string visible_text(std::string_view text) {
  std::string visible;
  while (!text.empty()) {
    const Character next = first_character(text);
    if (next.byte_count == 0) {
      text.remove_prefix(1);
      continue;
    }
    const std::string_view bytes = text.substr(0, next.byte_count);
    if (!is_control(next.value) && !turns_direction(next.value)) visible += bytes;
    text.remove_prefix(next.byte_count);
  }
  return visible;
}

}  // namespace hallux

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

}  // namespace hallux

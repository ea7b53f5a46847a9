#include "ui/app/terminal/terminal_text.h"

#include <cstddef>
#include <cstdint>

namespace hallux::ui {

namespace {

/// Source: The Unicode Standard, table 3-6 and D92; a character's value and its bytes, 0 bytes
/// where it is none.
struct Character {
  std::uint32_t value = 0;
  std::size_t byte_count = 0;
};

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

void append_escaped(std::string& shown, char letter) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto byte = static_cast<std::uint8_t>(letter);
  shown.append("\\x").append(1, digits[byte >> 4U]).append(1, digits[byte & 0xFU]);
}

}  // namespace

bool is_utf8(std::string_view text) noexcept {
  while (!text.empty()) {
    const Character character = first_character(text);
    if (character.byte_count == 0) return false;
    text.remove_prefix(character.byte_count);
  }
  return true;
}

std::string terminal_text(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const Character character = first_character(text);
    const std::size_t count = character.byte_count == 0 ? 1 : character.byte_count;
    const bool is_control =
        character.value < 0x20U || (character.value >= 0x7FU && character.value < 0xA0U);
    if (character.byte_count == 0 || is_control) {
      for (const char letter : text.substr(0, count)) append_escaped(shown, letter);
    } else {
      shown.append(text.substr(0, count));
    }
    text.remove_prefix(count);
  }
  return shown;
}

}  // namespace hallux::ui

#include "ui/app/terminal/terminal_text.h"

#include <cstddef>
#include <cstdint>

#include "simulator/base/utf8.h"

namespace hallux::ui {

namespace {

void append_escaped(std::string& shown, char letter) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto byte = static_cast<std::uint8_t>(letter);
  shown.append("\\x").append(1, digits[byte >> 4U]).append(1, digits[byte & 0xFU]);
}

}  // namespace

std::string terminal_text(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const Character character = first_character(text);
    const std::size_t count = character.byte_count == 0 ? 1 : character.byte_count;
    if (character.byte_count == 0 || is_control(character.value) ||
        turns_direction(character.value)) {
      for (const char letter : text.substr(0, count)) append_escaped(shown, letter);
    } else {
      shown.append(text.substr(0, count));
    }
    text.remove_prefix(count);
  }
  return shown;
}

}  // namespace hallux::ui

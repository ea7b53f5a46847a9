/// UTF-8 as texts from outside hold it, character by character.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hallux {

/// A character's value and its bytes; 0 bytes where it is none.
/// source  The Unicode Standard, table 3-6 and D92
struct Character {
  std::uint32_t value = 0;
  std::size_t byte_count = 0;
};

/// needs   a text that is not empty
Character first_character(std::string_view text) noexcept;

/// Whether all of it is well-formed: no stray bytes, no surrogates, nothing in a longer form than
/// needed.
bool is_utf8(std::string_view text) noexcept;

/// Appends a character; what is none (a surrogate, beyond U+10FFFF) is left out.
void append_utf8(std::string& text, std::uint32_t character);

/// C0, DEL and C1: what a terminal takes for a command.
bool is_control(std::uint32_t character) noexcept;
/// Marks after which letters are shown in another order than they stand in.
/// source  Unicode Standard Annex 9, explicit directional formatting characters
bool turns_direction(std::uint32_t character) noexcept;

/// Whether a text holds what a reader cannot see: controls other than a new line or a tab, or marks
/// that turn its direction.
bool has_hidden_letters(std::string_view text) noexcept;

/// Without what a reader cannot see, and without stray bytes: a text that a device says of itself.
std::string visible_text(std::string_view text);

}  // namespace hallux

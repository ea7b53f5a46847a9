/// The form of a one-time code: twelve letters and digits that cannot be taken for each other, with
/// dashes between groups ("7QK2-M9XD-3VTA"). Case, spaces and dashes do not matter; O, I, L read as
/// 0, 1, 1.
#pragma once

#include <cstddef>
#include <string_view>

namespace hallux::database {

/// Crockford's base 32: no I, L, O, U.
inline constexpr std::string_view code_letters = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
inline constexpr std::size_t code_length = 12;

/// A letter as it counts; 0 for what stands between.
constexpr char plain_code_letter(char typed) noexcept {
  if (typed == '-' || typed == ' ') return 0;
  const char upper = typed >= 'a' && typed <= 'z' ? static_cast<char>(typed - 32) : typed;
  if (upper == 'I' || upper == 'L') return '1';
  return upper == 'O' ? '0' : upper;
}

/// Whether what somebody typed has this form. A phrase of twelve letters has not: there is a digit
/// in it.
bool looks_like_code(std::string_view typed) noexcept;

}  // namespace hallux::database

#include "database/records/code_form.h"

namespace hallux::database {

bool looks_like_code(std::string_view typed) noexcept {
  std::size_t letters = 0;
  bool has_digit = false;
  for (const char each : typed) {
    const char plain = plain_code_letter(each);
    if (plain == 0) continue;
    if (code_letters.find(plain) == std::string_view::npos) return false;
    ++letters;
    has_digit = has_digit || (each >= '0' && each <= '9');
  }
  return letters == code_length && has_digit;
}

}  // namespace hallux::database

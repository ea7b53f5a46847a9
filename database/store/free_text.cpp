#include "database/store/free_text.h"

#include <cstdint>

#include "database/store/database_error.h"

namespace hallux::database {

namespace {

/// How many bytes follow a leading byte; nothing sensible (4) for one that leads nothing.
int followers_of(std::uint8_t lead) noexcept {
  if (lead < 0x80) return 0;
  if (lead >= 0xC2 && lead < 0xE0) return 1;
  if (lead >= 0xE0 && lead < 0xF0) return 2;
  if (lead >= 0xF0 && lead < 0xF5) return 3;
  return 4;
}

/// No surrogates, nothing beyond U+10FFFF, nothing in a longer form than needed: told by the first
/// follower.
bool is_good_pair(std::uint8_t lead, std::uint8_t next) noexcept {
  if (lead == 0xE0) return next >= 0xA0;
  if (lead == 0xED) return next < 0xA0;
  if (lead == 0xF0) return next >= 0x90;
  if (lead == 0xF4) return next < 0x90;
  return true;
}

bool is_utf8(std::string_view text) noexcept {
  for (std::size_t at = 0; at < text.size();) {
    const auto lead = static_cast<std::uint8_t>(text[at++]);
    const int followers = followers_of(lead);
    if (followers == 4 || text.size() - at < static_cast<std::size_t>(followers)) return false;
    for (int i = 0; i < followers; ++i) {
      const auto next = static_cast<std::uint8_t>(text[at++]);
      if ((next & 0xC0U) != 0x80U || (i == 0 && !is_good_pair(lead, next))) return false;
    }
  }
  return text.find('\0') == std::string_view::npos;
}

}  // namespace

void check_free_text(std::string_view what, std::string_view text) {
  const auto fail = [what](const char* why) {
    throw DatabaseError{DatabaseErrorKind::BadInput, std::string{what} + why};
  };
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    fail(" is empty; write a sentence");
  if (text.size() > free_text_bytes_max) fail(" is longer than 4000 bytes; shorten it");
  if (!is_utf8(text)) fail(" is not UTF-8 text; write it anew");
}

}  // namespace hallux::database

#include "database/text/free_text.h"

#include "database/store/database_error.h"
#include "simulator/base/utf8.h"

namespace hallux::database {

void check_free_text(std::string_view what, std::string_view text) {
  const auto fail = [what](const char* why) {
    throw DatabaseError{DatabaseErrorKind::BadInput, std::string{what} + why};
  };
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    fail(" is empty; write a sentence");
  if (text.size() > free_text_bytes_max) fail(" is longer than 4000 bytes; shorten it");
  if (!is_utf8(text) || text.find('\0') != std::string_view::npos)
    fail(" is not UTF-8 text; write it anew");
}

void check_name(std::string_view what, std::string_view name) {
  const auto fail = [what](const char* why) {
    throw DatabaseError{DatabaseErrorKind::BadInput, std::string{what} + why};
  };
  if (name.size() > name_bytes_max) fail(" is longer than 200 bytes; shorten it");
  if (!is_utf8(name)) fail(" is not UTF-8 text; write it anew");
  if (has_hidden_letters(name) || name.find_first_of("\n\t") != std::string_view::npos) {
    fail(" holds letters that nobody sees; write it anew");
  }
}

}  // namespace hallux::database

/// Texts and numbers as cells of CSV (RFC 4180) that no spreadsheet takes for a formula.
#pragma once

#include <string>
#include <string_view>

namespace hallux::database {

/// Quoted where it must be. A text that begins with = + - @ ' tab or CR gets an apostrophe before it: a reader takes the
/// first apostrophe of a cell away.
std::string csv_text(std::string_view text);
/// The shortest decimal that reads back as the same number; empty where it is not finite.
std::string csv_number(double value);

}  // namespace hallux::database

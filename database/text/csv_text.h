/// CSV rows that a spreadsheet opens without running anything (RFC 4180).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hallux::database {

/// One cell: quoted where it must be; a text that a spreadsheet would take for a formula (= + - @,
/// a tab, a line's end at its beginning) gets an apostrophe before it, and so does one that begins
/// with an apostrophe: a reader takes the first one away. A number needs none: say so with
/// `is_number`.
std::string csv_cell(std::string_view text, bool is_number = false);
/// The shortest decimal that reads back as the same number; empty where it is not finite.
std::string csv_number(double value);

}  // namespace hallux::database

/// Lines of integers, as the tables of an export consist of them: each in its shortest form, so
/// that the same rows give the same bytes. Inside this corner only.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "database/exchange/exchange_file.h"

namespace hallux::database {

void append_integer(std::string& line, std::int64_t value);

/// Takes the integers of the line that `lines` is at, as many as there are `numbers`.
/// errors  DatabaseError BadInput naming file and line: more or fewer columns, or another spelling
void take_integers(const ForeignLines& lines, std::string_view line,
                   std::span<std::int64_t> numbers);

}  // namespace hallux::database

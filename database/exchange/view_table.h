/// Table of the display facts of an exported attempt, CSV of integers: what was on the screen,
/// beside the record and outside its seal. Inside this corner only.
///
///   tick_ms,target_x_um,...   one line for each fact; missing where there is none
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "database/exchange/exchange_file.h"
#include "simulator/record/display_fact.h"

namespace hallux::database {

inline constexpr const char* view_table_name = "views.csv";

/// Without facts that are no views.
/// errors  DatabaseError
ExchangeFile write_view_table(const std::filesystem::path& folder,
                              std::span<const simulator::DisplayFact> facts);

/// None where `files` names no such table: an older program exported it, or nothing was shown.
/// ensures ticks rise, and each is a view; stereo and layout may be a newer program's
/// errors  DatabaseError BadInput naming file and line
std::vector<simulator::DisplayFact> read_view_table(const ForeignFolder& folder,
                                                    const std::vector<ExchangeFile>& files);

}  // namespace hallux::database

/// The ledger of a score card as a table: one line for each place where points were won or lost.
#pragma once

#include <filesystem>

#include "database/exchange/exchange_file.h"
#include "database/records/score.h"

namespace hallux::database {

/// errors  DatabaseError
ExchangeFile write_score_table(const std::filesystem::path& folder, const ScoreCard& card);

}  // namespace hallux::database

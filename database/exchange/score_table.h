/// Table of a score card in CSV: one line for each entry of its ledger. Inside this corner only.
#pragma once

#include <filesystem>

#include "database/exchange/exchange_file.h"
#include "database/records/score.h"

namespace hallux::database {

/// errors  DatabaseError
ExchangeFile write_score_table(const std::filesystem::path& folder, const ScoreCard& card);

}  // namespace hallux::database

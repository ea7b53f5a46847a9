/// A score card as the JSON that `hallux attempt` and `hallux score` answer with. Format:
/// docs/command.md. Inside this corner only.
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "assessment/measurement.h"
#include "database/records/score.h"

namespace hallux::ui {

/// Points as programs read them, from thousandths.
double points_from(std::int64_t milli) noexcept;
/// `score`, `measured_weight`, `groups`, `gates`, and what the score was computed with.
/// is_confirmed  an instructor stands for this score
nlohmann::ordered_json card_summary_json(const database::ScoreCard& card, bool is_confirmed);
/// `ledger`: one object a line; points_lost are shown points, so they add up to 100 - score.
nlohmann::ordered_json ledger_json(const database::ScoreCard& card);

/// `measurements`: one object for each metric of each subject, measured or not.
nlohmann::ordered_json measurements_json(std::span<const assessment::Measurement> measurements);

}  // namespace hallux::ui

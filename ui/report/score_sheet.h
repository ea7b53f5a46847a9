/// A score card as plain text for a terminal.
#pragma once

#include <string>

#include "scenarios/scenario.h"
#include "ui/report/report_material.h"

namespace hallux::ui {

/// Title, marks, score, groups with bars, gates, ledger; at most 100 columns, UTF-8, no control
/// codes.
std::string score_sheet(const ReportMaterial& material);
/// The same from a card, with the titles of its scenario.
/// signature  who stands for it
std::string score_sheet(const database::ScoreCard& card, const scenarios::Scenario& scenario,
                        std::string_view signature = unsigned_score);

}  // namespace hallux::ui

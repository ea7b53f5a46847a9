/// A score card as plain text for a terminal.
#pragma once

#include <string>

#include "ui/report/report_material.h"

namespace hallux::ui {

/// Title, marks, score, groups with bars, gates, ledger; at most 100 columns, UTF-8, no control codes.
std::string score_sheet(const ReportMaterial& material);
/// The same without titles: scenario, groups and gates appear by their names.
std::string score_sheet(const database::ScoreCard& card);

}  // namespace hallux::ui

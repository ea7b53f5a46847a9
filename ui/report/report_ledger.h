/// The parts of a report that say numbers: groups, gates, ledger. Inside this corner only.
#pragma once

#include <string>

#include "ui/report/report_material.h"

namespace hallux::ui {

/// A bar for each group: earned of possible, of 100 points in all, and an outline where nothing is
/// measured yet.
std::string groups_html(const ReportMaterial& material);
/// One line for each gate, with a shape beside every colour.
std::string gates_html(const ReportMaterial& material);
/// Every line of the ledger with its moment and the points of 100 that it cost; the last row says
/// that they add up.
std::string ledger_html(const ReportMaterial& material);

/// "partial: 58 % of the rubric is measured"; empty where it was all of it.
std::string partial_text(const database::ScoreCard& card);

}  // namespace hallux::ui

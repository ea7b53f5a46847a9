/// The parts of a report that say numbers: groups, gates, ledger.
#pragma once

#include <string>

#include "ui/report/report_material.h"

namespace hallux::ui {

/// A bar for each group: earned of measured, and an outline where nothing is measured yet.
std::string groups_html(const ReportMaterial& material);
/// One line for each gate, with a shape beside every colour.
std::string gates_html(const ReportMaterial& material);
/// Every line of the ledger with its moment, and the sums that must agree.
std::string ledger_html(const ReportMaterial& material);

/// "3 of 5 groups, 50 of 100 points": how much of the rubric was measured; empty where it was all of it.
std::string partial_text(const database::ScoreCard& card);

}  // namespace hallux::ui

/// Who, when and with what: the lines of a report that come from the stored attempt.
#pragma once

#include "database/records/attempt.h"
#include "database/records/certificate.h"
#include "scenarios/scenario.h"
#include "ui/report/report_material.h"

namespace hallux::ui {

/// Who stands for the score of that attempt, and whether for the one in force.
std::string signature_text(const database::AttemptHeader& header);

/// The scenario's titles: its own, its groups', its gates'.
/// needs   the card was made with this scenario
void add_titles(ReportMaterial& material, const scenarios::Scenario& scenario);

/// Adds facts and versions, and says in `quality` whether the recording is whole and may be graded;
/// `verdict` says why not.
void add_attempt_facts(ReportMaterial& material, const database::AttemptHeader& header,
                       const database::Verdict& verdict = {});

}  // namespace hallux::ui

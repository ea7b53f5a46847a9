/// `hallux score ATTEMPT` and `hallux report ATTEMPT -o FILE`.
#pragma once

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

/// needs   app and context outlive the parsing and the running of what was chosen
void add_score_verbs(CLI::App& app, VerbContext& context);

}  // namespace hallux::ui

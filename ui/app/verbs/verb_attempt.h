/// `hallux attempt SCENARIO` and `hallux attempts`.
#pragma once

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

/// needs   app and context outlive the parsing and the running of what was chosen
void add_attempt_verbs(CLI::App& app, VerbContext& context);

}  // namespace hallux::ui

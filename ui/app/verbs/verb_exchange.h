/// `hallux export`, `hallux import`, `hallux origins`: attempts as files, and where those that came
/// in were made.
#pragma once

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

void add_exchange_verbs(CLI::App& app, VerbContext& context);

}  // namespace hallux::ui

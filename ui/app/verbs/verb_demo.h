/// `hallux demo`: a simulated course in an empty data directory, marked as such.
#pragma once

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

void add_demo_verb(CLI::App& app, VerbContext& context);

}  // namespace hallux::ui

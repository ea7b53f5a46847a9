/// `hallux export-person LOGIN -o DIR`: all that is kept of one person, with an explanation.
#pragma once

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

void add_export_person_verb(CLI::App& app, VerbContext& context);

}  // namespace hallux::ui

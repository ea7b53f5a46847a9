/// `hallux verify`: integrity of the file and of every hash chain in it.
#pragma once

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

/// needs   app and context outlive the parsing and the running of what was chosen
void add_verify_verb(CLI::App& app, VerbContext& context);

}  // namespace hallux::ui

/// `hallux user add | list | passwd | disable | recover`.
#pragma once

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

/// needs   app and context outlive the parsing and the running of what was chosen
void add_user_verb(CLI::App& app, VerbContext& context);

}  // namespace hallux::ui

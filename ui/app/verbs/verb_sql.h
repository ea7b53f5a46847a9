/// `hallux sql "SELECT ..."`: reports in plain SQL.
#pragma once

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

void add_sql_verb(CLI::App& app, VerbContext& context);

}  // namespace hallux::ui

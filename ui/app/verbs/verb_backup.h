/// `hallux backup`, `hallux restore`, `hallux retention`: keeping what there is, and no longer than
/// it must be kept.
#pragma once

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

void add_backup_verb(CLI::App& app, VerbContext& context);
void add_restore_verb(CLI::App& app, VerbContext& context);
void add_retention_verb(CLI::App& app, VerbContext& context);

}  // namespace hallux::ui

/// `hallux cut MESH --plane nx,ny,nz,d --kerf MM [--sweep FILE] ... -o DIR`.
#pragma once

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

/// needs   app and context outlive the parsing and the running of what was chosen
void add_cut_verb(CLI::App& app, VerbContext& context);

}  // namespace hallux::ui

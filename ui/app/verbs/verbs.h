/// The verbs of the `hallux` command; docs/command.md says what each does. Their app and context
/// outlive the parsing and the running of what was chosen.
#pragma once

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

/// `hallux attempt SCENARIO` and `hallux attempts`.
void add_attempt_verbs(CLI::App& app, VerbContext& context);

/// `hallux replay ATTEMPT`: proves that a recording gives the same outputs again.
void add_replay_verb(CLI::App& app, VerbContext& context);

/// `hallux score ATTEMPT` and `hallux report ATTEMPT -o FILE`.
void add_score_verbs(CLI::App& app, VerbContext& context);

/// `hallux what-if ATTEMPT [--change CHANGE=VALUE]...`.
void add_what_if_verb(CLI::App& app, VerbContext& context);

/// `hallux metrics`: what is measured, how and by which source.
void add_metrics_verb(CLI::App& app, VerbContext& context);

/// `hallux rescore SCENARIO [--with-version N] [--dry-run]`.
void add_rescore_verb(CLI::App& app, VerbContext& context);

/// `hallux cut MESH --plane nx,ny,nz,d --kerf MM [--sweep FILE] ... -o DIR`.
void add_cut_verb(CLI::App& app, VerbContext& context);

/// `hallux scenario list | check FILE | show NAME | prove NAME`.
void add_scenario_verb(CLI::App& app, VerbContext& context);

/// `hallux user add | list | passwd | disable | erase | recover`.
void add_user_verb(CLI::App& app, VerbContext& context);

/// `hallux verify [--anchor FILE]`: integrity of the file, of every hash chain and row in it; and
/// `hallux anchor`: the head of the audit, to be kept elsewhere.
void add_verify_verbs(CLI::App& app, VerbContext& context);

/// `hallux backup`, `hallux restore`, `hallux retention`: keeping what there is, and no longer than
/// it must be kept.
void add_backup_verb(CLI::App& app, VerbContext& context);
void add_restore_verb(CLI::App& app, VerbContext& context);
void add_retention_verb(CLI::App& app, VerbContext& context);

/// `hallux export-person LOGIN -o DIR`: all that is kept of one person, with an explanation.
void add_export_person_verb(CLI::App& app, VerbContext& context);

/// `hallux sql "SELECT ..."`: reports in plain SQL.
void add_sql_verb(CLI::App& app, VerbContext& context);

/// `hallux export`, `hallux import`, `hallux origins`: attempts as files, and where those that came
/// in were made.
void add_exchange_verbs(CLI::App& app, VerbContext& context);

/// `hallux devices [rules | set ID KEY VALUE | test ID]`: what is plugged in, why it can be used or
/// not, and how to mend it.
void add_devices_verb(CLI::App& app, VerbContext& context);

/// `hallux demo`: a simulated course in an empty data directory, marked as such.
void add_demo_verb(CLI::App& app, VerbContext& context);

}  // namespace hallux::ui

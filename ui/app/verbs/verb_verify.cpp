#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

#include "database/maintenance/verify.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"

namespace hallux::ui {

namespace {

ExitCode verify_on(const VerbContext& context) {
  database::OpenOptions for_reading;
  for_reading.access = database::Access::ReadOnly;
  database::Database database = database::Database::open(context.data_directory, for_reading);
  const database::Verification found = verify(database, progress_on(context, "Verifying"));
  answer(context,
         {{"whole", found.is_whole()},
          {"first_damage", or_null(found.first_damage)},
          {"attempts", found.attempts},
          {"chunks", found.chunks},
          {"scores", found.scores},
          {"assets", found.assets},
          {"audit_rows", found.audit_rows},
          {"covered_since", or_null(found.covered_since_utc)}},
         [&](std::ostream& out) {
           if (!found.is_whole()) {
             out << "damaged: " << terminal_text(*found.first_damage) << "\n";
             return;
           }
           out << "whole: " << found.attempts << " attempts, " << found.chunks << " chunks, "
               << found.scores << " scores, " << found.assets << " assets, " << found.audit_rows
               << " audit rows; every row covered since "
               << found.covered_since_utc.value_or("nothing: an older program made it") << "\n";
         });
  return found.is_whole() ? ExitCode::Done : ExitCode::CheckFailed;
}

}  // namespace

void add_verify_verb(CLI::App& app, VerbContext& context) {
  CLI::App* verify = app.add_subcommand(
      "verify", "check the file and every hash chain; names the first row that was altered");
  choose(*verify, context, [&context] { return verify_on(context); });
}

}  // namespace hallux::ui

#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

#include "database/maintenance/verify.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;

ExitCode verify_on(const VerbContext& context) {
  database::OpenOptions for_reading;
  for_reading.access = database::Access::ReadOnly;
  database::Database database = database::Database::open(context.data_directory, for_reading);
  const database::Verification found = verify(database, progress_on(context, "Verifying"));
  if (context.json) {
    write_json(context.out,
               ordered_json{{"whole", found.is_whole()},
                            {"first_damage", found.first_damage ? ordered_json(*found.first_damage)
                                                                : ordered_json()},
                            {"attempts", found.attempts},
                            {"chunks", found.chunks},
                            {"scores", found.scores},
                            {"assets", found.assets},
                            {"audit_rows", found.audit_rows}});
  } else if (found.is_whole()) {
    context.out << "whole: " << found.attempts << " attempts, " << found.chunks << " chunks, "
                << found.scores << " scores, " << found.assets << " assets, " << found.audit_rows
                << " audit rows\n";
  } else {
    context.out << "damaged: " << terminal_text(*found.first_damage) << "\n";
  }
  return found.is_whole() ? ExitCode::Done : ExitCode::CheckFailed;
}

}  // namespace

void add_verify_verb(CLI::App& app, VerbContext& context) {
  CLI::App* verify = app.add_subcommand(
      "verify", "check the file and every hash chain; names the first row that was altered");
  choose(*verify, context, [&context] { return verify_on(context); });
}

}  // namespace hallux::ui

/// The whole line is understood before anything is done: verbs only choose what to run. Everything
/// thrown ends here, in one place, as a sentence on stderr and an exit code; what files hold is
/// made harmless for the terminal on the way.
#include "ui/app/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>

#include "database/maintenance/verify.h"
#include "database/store/database_error.h"
#include "simulator/base/progress.h"
#include "simulator/record/record.h"
#include "ui/app/terminal/interrupt.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/verbs.h"
#include "ui/app/window/open_window.h"
#include "ui/jobs/attempt_jobs.h"
#include "ui/jobs/files/output_error.h"

namespace hallux::ui {

namespace {

using database::DatabaseErrorKind;

ExitCode exit_code_of(DatabaseErrorKind kind) {
  switch (kind) {
    case DatabaseErrorKind::Refused:
      return ExitCode::Refused;
    case DatabaseErrorKind::NotFound:
    case DatabaseErrorKind::BadInput:
      return ExitCode::BadInput;
    default:
      return ExitCode::Storage;
  }
}

ExitCode exit_code_of(OutputErrorKind kind) {
  return kind == OutputErrorKind::Name ? ExitCode::BadInput : ExitCode::Storage;
}

/// A stream that swallows what is written to it: --quiet.
class NullBuffer final : public std::streambuf {
  int overflow(int letter) override { return letter; }
};

std::filesystem::path default_data_directory() {
  if (const char* data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != '\0') {
    return std::filesystem::path(data) / "hallux";
  }
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : ".") / ".local" / "share" / "hallux";
}

ExitCode run_chosen(const VerbContext& context, std::ostream& err) {
  // The one place where sentences reach the terminal: what files hold may not command it.
  const auto fail = [&err](const std::exception& error, ExitCode code) {
    err << "hallux: " << terminal_text(error.what()) << "\n";
    return code;
  };
  try {
    const ExitCode code = context.chosen();
    context.out.flush();
    if (!context.out) {
      err << "hallux: the answer could not be written to stdout; see where it leads\n";
      return ExitCode::Storage;
    }
    return code;
  } catch (const database::DatabaseError& error) {
    return fail(error, exit_code_of(error.kind()));
  } catch (const VerbError& error) {
    return fail(error, error.code());
  } catch (const OutputError& error) {
    return fail(error, exit_code_of(error.kind()));
  } catch (const Cancelled& error) {
    return fail(error, ExitCode::Interrupted);
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(error, ExitCode::Storage);
  } catch (const std::bad_alloc&) {
    err << "hallux: the memory of this machine is not enough for this\n";
    return ExitCode::BadInput;
  } catch (const std::exception& error) {
    // A mesh, a scenario, a file: what was given is not what was asked for.
    return fail(error, ExitCode::BadInput);
  }
}

void add_verbs(CLI::App& app, VerbContext& context) {
  add_attempt_verbs(app, context);
  add_replay_verb(app, context);
  add_score_verbs(app, context);
  add_rescore_verb(app, context);
  add_cut_verb(app, context);
  add_scenario_verb(app, context);
  add_user_verb(app, context);
  add_verify_verb(app, context);
  add_backup_verb(app, context);
  add_restore_verb(app, context);
  add_retention_verb(app, context);
  add_export_person_verb(app, context);
  add_sql_verb(app, context);
  add_exchange_verbs(app, context);
  add_demo_verb(app, context);
}

}  // namespace

ExitCode run_command_line(int argc, const char* const* argv, std::istream& in, std::ostream& out,
                          std::ostream& err) {
  NullBuffer null_buffer;
  std::ostream notes(err.rdbuf());
  VerbContext context{out, notes, in, default_data_directory(), {}, false, false, {}};

  CLI::App app(
      "Hallux: a bone-surgery trainer. Without a verb it opens its window. Scenarios are not "
      "surgeon-reviewed.",
      "hallux");
  app.fallthrough();
  app.require_subcommand(0, 1);
  app.set_version_flag("--version",
                       "hallux, engine version " + std::to_string(simulator::engine_version));
  app.add_option("--data", context.data_directory, "data directory; the database is DIR/hallux.db")
      ->check([](const std::string& name) {
        return std::string(name.empty() ? "must name a directory" : "");
      });
  app.add_option("--as", context.login,
                 "sign in as this person; the password comes from the terminal or stdin");
  app.add_flag("--json", context.json, "answer with exactly one JSON value on stdout");
  app.add_flag("--quiet", context.quiet, "no progress on stderr");
  app.add_flag_callback(
      "--no-backup", [&context] { context.backs_up_before_migration = false; },
      "migrate an older database without a copy of it");
  std::optional<std::filesystem::path> ui_map;
  app.add_option(
      "--ui-map", ui_map,
      "without a verb: keep what the window shows in this file, as JSON, for accessibility tools");
  add_verbs(app, context);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error, out, err);
    return code == 0 ? ExitCode::Done : ExitCode::WrongUsage;
  }
  const bool wants_window = !context.chosen;
  if (wants_window ? context.json || !context.login.empty() : ui_map.has_value()) {
    err << (wants_window ? "hallux: --json and --as belong to a verb; the verbs are:\n"
                         : "hallux: --ui-map belongs to the window, which opens without a verb:\n")
        << app.help();
    return ExitCode::WrongUsage;
  }
  if (wants_window) context.chosen = [&] { return open_window(context, ui_map); };
  if (context.quiet) notes.rdbuf(&null_buffer);
  const InterruptWatch interrupts;
  return run_chosen(context, err);
}

}  // namespace hallux::ui

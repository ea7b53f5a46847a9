/// The whole line is understood before anything is done: verbs only choose what to run. Everything
/// thrown ends here, in one place, as a sentence on stderr and an exit code, and with --json as the
/// one value that is answered; what files hold is made harmless for the terminal on the way.
#include "ui/app/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <sstream>
#include <string_view>

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

/// What came of a verb; a sentence where it failed.
struct Outcome {
  ExitCode code = ExitCode::Done;
  std::string failure = {};
};

Outcome outcome_of(const std::function<ExitCode()>& chosen) {
  const auto fail = [](const std::exception& error, ExitCode code) {
    return Outcome{code, error.what()};
  };
  try {
    return {chosen()};
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
    return {ExitCode::BadInput, "the memory of this machine is not enough for this"};
  } catch (const std::exception& error) {
    // A mesh, a scenario, a file: what was given is not what was asked for.
    return fail(error, ExitCode::BadInput);
  }
}

void write_failure_json(std::ostream& out, const Outcome& outcome) {
  write_json(out,
             {{"error", {{"code", static_cast<int>(outcome.code)}, {"message", outcome.failure}}}});
}

/// The one place where answers and sentences leave: with --json one value, whatever came of it, and
/// nothing that files hold may command the terminal.
ExitCode say(const Outcome& outcome, const VerbContext& context, const std::string& answer,
             std::ostream& out, std::ostream& err) {
  const bool has_failed = !outcome.failure.empty();
  if (has_failed) err << "hallux: " << terminal_text(outcome.failure) << "\n";
  out << answer;
  if (has_failed && context.json && answer.empty()) write_failure_json(out, outcome);
  out.flush();
  if (out || has_failed) return outcome.code;
  err << "hallux: the answer could not be written to stdout; see where it leads\n";
  return ExitCode::Storage;
}

/// Before the line is understood.
bool asks_for_json(int argc, const char* const* argv) {
  return std::any_of(argv, argv + argc,
                     [](const char* word) { return std::string_view{word} == "--json"; });
}

/// What was asked of the command itself (--help, --version), or what is wrong with the line.
ExitCode answer_misunderstood(const CLI::App& app, const CLI::ParseError& error, bool wants_json,
                              std::ostream& out, std::ostream& err) {
  std::ostringstream text;
  const bool is_asked_for = app.exit(error, text, err) == 0;
  if (!wants_json) {
    out << text.str();
  } else if (is_asked_for) {
    write_json(out, {{"text", text.str()}});
  } else {
    write_failure_json(out, {ExitCode::WrongUsage, error.what()});
  }
  return is_asked_for ? ExitCode::Done : ExitCode::WrongUsage;
}

void add_verbs(CLI::App& app, VerbContext& context) {
  add_attempt_verbs(app, context);
  add_replay_verb(app, context);
  add_score_verbs(app, context);
  add_what_if_verb(app, context);
  add_metrics_verb(app, context);
  add_rescore_verb(app, context);
  add_cut_verb(app, context);
  add_scenario_verb(app, context);
  add_user_verb(app, context);
  add_verify_verbs(app, context);
  add_devices_verb(app, context);
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
  std::ostringstream answer;
  VerbContext context{answer, notes, in, default_data_directory(), {}, false, false, {}};

  CLI::App app(
      "Hallux: a bone-surgery trainer. Without a verb it opens its window. Scenarios are not "
      "surgeon-reviewed.",
      "hallux");
  app.fallthrough();
  app.require_subcommand(0, 1);
  app.set_version_flag("--version",
                       "hallux, engine version " + std::to_string(simulator::engine_version));
  app.add_option("--data", context.data_directory, "data directory; the database is DIR/hallux.db")
      ->check(fault_in_place);
  app.add_option("--as", context.login,
                 "sign in as this person; the password comes from the terminal or stdin");
  app.add_flag("--json", context.json, "answer with exactly one JSON value on stdout");
  app.add_flag("--quiet", context.quiet, "no progress on stderr");
  app.add_flag_callback(
      "--no-backup", [&context] { context.backs_up_before_migration = false; },
      "migrate an older database without a copy of it");
  std::optional<std::filesystem::path> ui_map;
  app.add_option("--ui-map", ui_map,
                 "without a verb: keep what the window shows in this file, as JSON, for "
                 "accessibility tools")
      ->check(fault_in_place);
  add_verbs(app, context);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return answer_misunderstood(app, error, asks_for_json(argc, argv), out, err);
  }
  const bool wants_window = !context.chosen;
  if (wants_window ? context.json || !context.login.empty() : ui_map.has_value()) {
    const std::string misplaced =
        wants_window ? "--json and --as belong to a verb; the verbs are:"
                     : "--ui-map belongs to the window, which opens without a verb:";
    err << "hallux: " << misplaced << "\n" << app.help();
    if (context.json) write_failure_json(out, {ExitCode::WrongUsage, misplaced});
    return ExitCode::WrongUsage;
  }
  if (wants_window) context.chosen = [&] { return open_window(context, ui_map); };
  if (context.quiet) notes.rdbuf(&null_buffer);
  const InterruptWatch interrupts;
  const Outcome outcome = outcome_of(context.chosen);
  return say(outcome, context, answer.str(), out, err);
}

}  // namespace hallux::ui

/// What every verb of the `hallux` command is given, and how it is added to the command line.
///
/// A verb is added by `void add_<verb>_verb(CLI::App& app, VerbContext& context)`: it defines a
/// subcommand whose callback sets `context.chosen`. main() runs what was chosen after the whole
/// line was understood, and turns what is thrown into one sentence and an exit code.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

#include "simulator/base/progress.h"
#include "ui/app/terminal/exit_code.h"

namespace CLI {
class App;
}

namespace hallux::ui {

struct VerbContext {
  /// The answer: with --json exactly one JSON value.
  std::ostream& out;
  /// Progress and remarks, stderr; silent with --quiet.
  std::ostream& notes;
  /// Passwords, where stdin is no terminal.
  std::istream& in;
  /// --data, or the XDG data directory.
  std::filesystem::path data_directory;
  /// --as.
  std::string login;
  bool json = false;
  bool quiet = false;
  std::function<ExitCode()> chosen;
  /// Not with --no-backup.
  bool backs_up_before_migration = true;
};

/// Shows a long job on `notes`: "label  42 %", redrawn on a terminal, silent with --quiet.
/// Returns false once the user pressed Ctrl-C, which cancels the job.
Progress progress_on(const VerbContext& context, std::string label);

}  // namespace hallux::ui

/// What every verb of the `hallux` command is given, and how it is added to the command line.
///
/// A verb is added by `void add_<verb>_verb(CLI::App& app, VerbContext& context)`: it defines a
/// subcommand and says with choose() what it does. main() runs what was chosen after the whole line
/// was understood, and turns what is thrown into one sentence and an exit code.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "simulator/base/progress.h"
#include "ui/app/terminal/exit_code.h"
#include "ui/jobs/optional_json.h"

namespace CLI {
class App;
}

namespace hallux::ui {

/// A verb that will not do what it was asked, as one sentence: what, where, and the mend.
class VerbError : public std::runtime_error {
 public:
  VerbError(ExitCode code, const std::string& sentence)
      : std::runtime_error(sentence), code_(code) {}
  ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

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

/// The same for work of several stages, each of which is a label.
std::function<Progress(const std::string& stage)> stages_on(const VerbContext& context);

/// For options that name a place: what is wrong with an empty one.
std::string fault_in_place(const std::string& name);

/// Lets `verb` choose `run` once it stands on the line.
void choose(CLI::App& verb, VerbContext& context, std::function<ExitCode()> run);

/// Writes the value and a line end. Bytes that are not UTF-8 (a file's name may hold any) become
/// U+FFFD.
void write_json(std::ostream& out, const nlohmann::ordered_json& value);

/// What was asked for: the value with --json, else what `print` writes.
void answer(const VerbContext& context, const nlohmann::ordered_json& value,
            const std::function<void(std::ostream& out)>& print);

/// A list that was asked for: with --json one array of what `json_of` makes of each, else each as
/// `print(out, one)` writes it.
template <typename List, typename JsonOf, typename Print>
ExitCode answer_with_list(const VerbContext& context, const List& list, JsonOf json_of,
                          Print print) {
  auto rows = nlohmann::ordered_json::array();
  for (const auto& one : list) rows.push_back(json_of(one));
  answer(context, rows, [&](std::ostream& out) {
    for (const auto& one : list) print(out, one);
  });
  return ExitCode::Done;
}

}  // namespace hallux::ui

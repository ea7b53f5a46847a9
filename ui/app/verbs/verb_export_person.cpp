#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "simulator/base/progress.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"

namespace hallux::ui {

namespace {

struct ExportOptions {
  std::string login;
  std::filesystem::path directory;
};

/// One's own at one's own desk; another's at that of an administrator.
database::PersonExport exported(const VerbContext& context, database::Database& database,
                                const ExportOptions& options) {
  const Progress progress = progress_on(context, "Exporting");
  if (options.login != context.login) {
    AdministratorSession administrator =
        sign_in_administrator(context, database, "export what is kept of others");
    return administrator.desk.export_person(options.login, options.directory, progress);
  }
  database::Session session = sign_in_as(context, database);
  std::optional<database::TraineeDesk> desk = session.trainee();
  if (!desk) throw VerbError(ExitCode::Refused, context.login + " has no desk here");
  return desk->export_own(options.directory, progress);
}

ExitCode export_on(const VerbContext& context, const ExportOptions& options) {
  database::Database database = open_kept(context);
  const database::PersonExport done = exported(context, database, options);
  answer(context,
         {{"login", options.login},
          {"directory", done.directory.string()},
          {"files", done.files},
          {"rows", done.rows}},
         [&](std::ostream& out) {
           out << done.files << " files in " << terminal_text(done.directory.string())
               << "; begin with explanation.txt\n";
         });
  return ExitCode::Done;
}

}  // namespace

void add_export_person_verb(CLI::App& app, VerbContext& context) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* verb = app.add_subcommand(
      "export-person", "all that is kept of one person, for that person, with an explanation");
  verb->add_option("login", options->login, "whose; your own, or as an administrator anybody's")
      ->required();
  verb->add_option("-o,--output", options->directory, "directory that is new or empty")
      ->required()
      ->check(fault_in_place);
  choose(*verb, context, [options, &context] { return export_on(context, *options); });
}

}  // namespace hallux::ui

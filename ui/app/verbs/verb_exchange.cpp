/// export, import, origins. An attempt leaves at the desk that may export it, which with --as is
/// looked for among all that the person has; without people it is the house's. What came from
/// elsewhere counts once an administrator has accepted its origin.
#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "database/desks/exportable.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"
#include "ui/jobs/exchange_jobs.h"

namespace hallux::ui {

namespace {

using database::Action;
using nlohmann::ordered_json;

struct ExportOptions {
  std::string attempt;
  database::ExportChoice choice;
  bool is_all = false;
  std::filesystem::path folder;
};

struct OriginOptions {
  std::string accepted, unaccepted;
};

void check_choice(const ExportOptions& options) {
  const int said = (options.attempt.empty() ? 0 : 1) + (options.choice.login.empty() ? 0 : 1) +
                   (options.choice.cohort.empty() ? 0 : 1) + (options.is_all ? 1 : 0);
  if (said == 1) return;
  throw VerbError(ExitCode::WrongUsage,
                  "say what to export: an attempt, or one of --person, --cohort and --all");
}

/// At the house's desk: the robot's.
ExportRequest of_nobody(database::Database& database, const ExportOptions& options) {
  database::HouseDesk desk(database);
  ExportRequest request{{}, options.folder, database.directory()};
  if (!options.attempt.empty()) {
    request.attempts.push_back(desk.header({options.attempt}).id);
  } else if (options.is_all) {
    for (const database::AttemptHeader& header : desk.attempts()) {
      if (header.state != database::AttemptState::Recording) request.attempts.push_back(header.id);
    }
  }
  return request;
}

ExportRequest of_person(database::Database& database, database::Session& session,
                        const ExportOptions& options) {
  if (!options.attempt.empty()) return {{{options.attempt}}, options.folder, database.directory()};
  return {exportable_attempts(database, session, options.choice), options.folder,
          database.directory()};
}

ExitCode export_chosen(const VerbContext& context, const ExportRequest& request,
                       const FindDesk& desk_of) {
  if (request.attempts.empty()) {
    throw VerbError(ExitCode::BadInput,
                    "there is no such attempt that you may export; `hallux attempts` lists yours, "
                    "and --as says who you are");
  }
  export_attempts(request, desk_of, stages_on(context));
  answer(context, {{"folder", request.folder.string()}, {"attempts", request.attempts.size()}},
         [&](std::ostream& out) {
           out << request.attempts.size() << " attempts in "
               << terminal_text(request.folder.string()) << "\n";
         });
  return ExitCode::Done;
}

ExitCode export_on(const VerbContext& context, const ExportOptions& options) {
  check_choice(options);
  database::Database database = open_kept(context);
  if (context.login.empty()) {
    return export_chosen(context, of_nobody(database, options),
                         [&](const database::AttemptId&) { return database::HouseDesk(database); });
  }
  database::Session session = sign_in_as(context, database);
  const FindDesk desk_of = [&](const database::AttemptId& id) {
    std::optional<database::AttemptDesk> desk = session.desk_for(Action::ExportAttempt, id);
    if (!desk) throw VerbError(ExitCode::Refused, context.login + " has no desk here");
    return *desk;
  };
  return export_chosen(context, of_person(database, session, options), desk_of);
}

ordered_json ids_json(const std::vector<database::AttemptId>& ids) {
  ordered_json list = ordered_json::array();
  for (const database::AttemptId& id : ids) list.push_back(id.text);
  return list;
}

void say_imported(const VerbContext& context, const ImportReport& report) {
  ordered_json refused = ordered_json::array();
  for (const RefusedFolder& folder : report.refused) {
    refused.push_back({{"folder", folder.folder}, {"reason", folder.reason}});
    if (!context.json) context.out << "refused: " << terminal_text(folder.reason) << "\n";
  }
  for (const std::string& why : report.not_all) context.notes << terminal_text(why) << "\n";
  answer(context,
         {{"imported", ids_json(report.imported)},
          {"known", ids_json(report.known)},
          {"refused", refused},
          {"not_all", report.not_all}},
         [&](std::ostream& out) {
           out << report.imported.size() << " taken in, " << report.known.size()
               << " were here already, " << report.refused.size() << " refused\n";
         });
}

ExitCode import_on(const VerbContext& context, const std::filesystem::path& folder) {
  database::Database database = open_kept(context);
  AdministratorSession administrator = sign_in_administrator(context, database, "import attempts");
  const ImportReport report = import_attempts(administrator.desk, folder, stages_on(context));
  say_imported(context, report);
  return report.refused.empty() ? ExitCode::Done : ExitCode::BadInput;
}

ordered_json origin_json(const database::Origin& origin) {
  return {{"directory", origin.directory.text},
          {"accepted", origin.is_accepted},
          {"since", origin.imported_utc},
          {"attempts", origin.attempts},
          {"people", origin.people}};
}

void print_origin(std::ostream& out, const database::Origin& origin) {
  out << origin.directory.text << "  " << origin.attempts << " attempts of " << origin.people
      << " people  " << (origin.is_accepted ? "accepted" : "not accepted: does not count") << "\n";
}

ExitCode origins_on(const VerbContext& context, const OriginOptions& options) {
  database::Database database = open_kept(context);
  AdministratorSession administrator = sign_in_administrator(context, database, "see origins");
  if (!options.accepted.empty()) administrator.desk.set_accepted({options.accepted}, true);
  if (!options.unaccepted.empty()) administrator.desk.set_accepted({options.unaccepted}, false);
  return answer_with_list(context, administrator.desk.origins(), origin_json, print_origin);
}

void add_export_verb(CLI::App& app, VerbContext& context) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* verb = app.add_subcommand(
      "export", "attempts as files for other programs and for another data directory");
  verb->add_option("attempt", options->attempt, "the attempt's id, or its first characters");
  verb->add_option("--person", options->choice.login, "all attempts of this person");
  verb->add_option("--cohort", options->choice.cohort,
                   "all attempts of the trainees of this cohort");
  verb->add_flag("--all", options->is_all, "all that you may export");
  verb->add_option("-o,--output", options->folder, "folder that is new or empty")
      ->required()
      ->check(fault_in_place);
  choose(*verb, context, [options, &context] { return export_on(context, *options); });
}

}  // namespace

void add_exchange_verbs(CLI::App& app, VerbContext& context) {
  add_export_verb(app, context);
  auto folder = std::make_shared<std::filesystem::path>();
  CLI::App* import = app.add_subcommand(
      "import", "take in what another data directory exported; for administrators");
  import->add_option("folder", *folder, "what `hallux export` wrote")->required();
  choose(*import, context, [folder, &context] { return import_on(context, *folder); });

  auto options = std::make_shared<OriginOptions>();
  CLI::App* origins = app.add_subcommand(
      "origins", "where imported attempts were made, and whether they count; for administrators");
  CLI::Option* accept =
      origins->add_option("--accept", options->accepted, "what came from this directory counts");
  origins->add_option("--unaccept", options->unaccepted, "it counts no longer")->excludes(accept);
  choose(*origins, context, [options, &context] { return origins_on(context, *options); });
}

}  // namespace hallux::ui

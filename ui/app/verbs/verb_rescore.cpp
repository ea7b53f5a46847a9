#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"
#include "ui/jobs/rescore_jobs.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;

struct RescoreOptions {
  std::string scenario;
  std::int32_t version = 0;  ///< 0: of each attempt its own
  bool is_dry_run = false;
};

/// Those from which others' attempts are scored: nobody changes the rubric of their own.
std::vector<database::AttemptDesk> scoring_desks(database::Session& session) {
  std::vector<database::AttemptDesk> desks;
  for (const database::Membership& membership : session.memberships())
    if (const auto taught = session.instructor_of(membership.cohort)) desks.push_back(*taught);
  if (const auto administered = session.administrator()) desks.push_back(*administered);
  return desks;
}

/// What is published, and for administrators the whole catalogue.
std::vector<KnownVersion> known_versions(database::Session& session) {
  std::vector<KnownVersion> known;
  if (auto administered = session.administrator())
    for (const database::ScenarioVersion& version : administered->scenarios())
      known.push_back({version.name, version.version, version.id});
  if (auto own = session.trainee())
    for (const database::Operation& operation : own->operations())
      known.push_back({operation.name, operation.version, operation.scenario});
  return known;
}

ordered_json score_json(const std::optional<database::ScoreCard>& card) {
  if (!card) return nullptr;
  return {{"score", static_cast<double>(card->score_milli) / 1000.0},
          {"measured_weight", static_cast<double>(card->measured_milli) / 1000.0},
          {"scenario_version", card->scenario_version},
          {"rubric_version", card->rubric_version},
          {"engine_version", card->engine}};
}

ordered_json attempt_json(const RescoredAttempt& attempt) {
  const auto& login = attempt.header.login;
  ordered_json row = {{"attempt", attempt.header.id.text},
                      {"login", login.empty() ? ordered_json() : ordered_json(login)},
                      {"before", score_json(attempt.before)},
                      {"after", score_json(attempt.after)},
                      {"changed", attempt.is_changed},
                      {"stored", attempt.is_stored}};
  row["decision"] =
      attempt.header.decision ? ordered_json(name_of(*attempt.header.decision)) : ordered_json();
  row["fault"] = attempt.fault.empty() ? ordered_json() : ordered_json(attempt.fault);
  return row;
}

std::string points(const std::optional<database::ScoreCard>& card) {
  if (!card) return "-";
  const std::int64_t tenths = (card->score_milli + 50) / 100;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

void print_attempt(std::ostream& out, const RescoredAttempt& attempt) {
  const std::string who = attempt.header.login.empty() ? "robot" : attempt.header.login;
  out << attempt.header.id.text << "  " << terminal_text(who) << "  ";
  if (!attempt.fault.empty()) {
    out << "not scored: " << terminal_text(attempt.fault) << "\n";
    return;
  }
  out << points(attempt.before) << " -> " << points(attempt.after)
      << (!attempt.is_changed ? ", the same card"
          : attempt.is_stored ? ", stored"
                              : ", would be stored")
      << (attempt.is_changed && attempt.header.decision ? "; the decision stays as it is" : "")
      << "\n";
}

ExitCode answer_on(const VerbContext& context, const RescoreOptions& options,
                   const std::vector<RescoredAttempt>& attempts) {
  const auto count = [&](auto is_so) {
    return std::count_if(attempts.begin(), attempts.end(), is_so);
  };
  const auto changed = count([](const RescoredAttempt& each) { return each.is_changed; });
  const auto stored = count([](const RescoredAttempt& each) { return each.is_stored; });
  const auto faulty = count([](const RescoredAttempt& each) { return !each.fault.empty(); });
  ordered_json rows = ordered_json::array();
  for (const RescoredAttempt& attempt : attempts) rows.push_back(attempt_json(attempt));
  answer(context,
         {{"scenario", options.scenario},
          {"dry_run", options.is_dry_run},
          {"attempts", attempts.size()},
          {"changed", changed},
          {"stored", stored},
          {"not_scored", faulty},
          {"rows", rows}},
         [&](std::ostream& out) {
           for (const RescoredAttempt& attempt : attempts) print_attempt(out, attempt);
           out << attempts.size() << (attempts.size() == 1 ? " attempt, " : " attempts, ")
               << changed << " changed, " << stored << " stored"
               << (options.is_dry_run ? " (dry run)" : "") << "\n";
         });
  return faulty == 0 ? ExitCode::Done : ExitCode::CheckFailed;
}

ExitCode rescore_on(const VerbContext& context, const RescoreOptions& options) {
  database::Database database = open_kept(context);
  Rescoring rescoring{options.scenario, std::nullopt, options.is_dry_run, {}};
  if (options.version > 0) rescoring.version = options.version;
  const auto progress = progress_on(context, "Scoring");
  if (context.login.empty()) {
    std::vector<database::AttemptDesk> house{database::HouseDesk(database)};
    return answer_on(context, options, rescore(database, house, rescoring, progress));
  }
  database::Session session = sign_in_as(context, database);
  std::vector<database::AttemptDesk> desks = scoring_desks(session);
  if (desks.empty()) {
    throw VerbError(ExitCode::Refused,
                    "only instructors and administrators score many attempts anew; `hallux score` "
                    "scores one of your own");
  }
  rescoring.versions = known_versions(session);
  return answer_on(context, options, rescore(database, desks, rescoring, progress));
}

}  // namespace

void add_rescore_verb(CLI::App& app, VerbContext& context) {
  const auto options = std::make_shared<RescoreOptions>();
  CLI::App* verb = app.add_subcommand(
      "rescore", "score all attempts of an operation anew, beside their old scores");
  verb->add_option("scenario", options->scenario, "the operation's name")->required();
  verb->add_option("--with-version", options->version,
                   "score with the text of this version instead of each attempt's own")
      ->check(CLI::Range(1, 1'000'000));
  verb->add_flag("--dry-run", options->is_dry_run, "say what would change and store nothing");
  choose(*verb, context, [options, &context] { return rescore_on(context, *options); });
}

}  // namespace hallux::ui

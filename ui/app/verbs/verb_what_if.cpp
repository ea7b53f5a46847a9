/// what-if: what another performance would have earned, by the scorer itself. Stores nothing.
#include <CLI/CLI.hpp>
#include <charconv>
#include <memory>
#include <ostream>

#include "assessment/what_if.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"
#include "ui/app/verbs/card_json.h"
#include "ui/app/verbs/verbs.h"
#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {

namespace {

using assessment::Change;
using database::Action;
using nlohmann::ordered_json;

struct WhatIfOptions {
  std::string attempt;
  std::vector<std::string> changes;
};

/// "tilt:proximal_face=0".
/// errors  ScenarioError
Change change_from(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string number = equals == std::string::npos ? "" : text.substr(equals + 1);
  Change change{text.substr(0, equals), 0.0};
  const auto read = std::from_chars(number.data(), number.data() + number.size(), change.to);
  const bool is_number = read.ec == std::errc() && read.ptr == number.data() + number.size();
  constexpr double most = 1.0e6;
  if (is_number && !number.empty() && std::abs(change.to) <= most) return change;
  throw scenarios::ScenarioError("--change " + terminal_text(text) +
                                 ": give what is to change and its value, as tilt:CUT=0");
}

ordered_json proposal_json(const assessment::ProposedChange& proposed) {
  return {{"change", proposed.change.name},
          {"from", proposed.change.from},
          {"to", proposed.to},
          {"unit", proposed.change.unit},
          {"assumed", proposed.change.is_replaced},
          {"gain", points_from(proposed.gain_milli)},
          {"items", proposed.items}};
}

void answer_proposals(const VerbContext& context, const AttemptMaterial& material,
                      const assessment::WhatIf& what_if) {
  const assessment::Proposals proposals = what_if.propose(stages_on(context)("Trying changes"));
  const double score = points_from(what_if.examination().card.score_milli);
  if (context.json) {
    ordered_json changes = ordered_json::array();
    for (const auto& each : proposals.changes) changes.push_back(proposal_json(each));
    write_json(context.out, {{"attempt", material.header.id.text},
                             {"score", score},
                             {"changes", std::move(changes)},
                             {"all",
                              {{"score", points_from(proposals.score_milli)},
                               {"gain", points_from(proposals.gain_milli)}}}});
    return;
  }
  context.out << "score " << score << "\n";
  for (const auto& each : proposals.changes) {
    context.out << "  " << each.change.name << "  " << each.change.from << " -> " << each.to << " "
                << each.change.unit << "  +" << points_from(each.gain_milli) << "\n";
  }
  context.out << "all of them together: " << points_from(proposals.score_milli) << "\n";
}

void answer_changes(const VerbContext& context, const AttemptMaterial& material,
                    const assessment::WhatIf& what_if, const std::vector<Change>& changes) {
  const assessment::WhatIfOutcome outcome = what_if.with(changes);
  const std::int64_t gain_milli = outcome.card.score_milli - what_if.examination().card.score_milli;
  if (context.json) {
    write_json(context.out, {{"attempt", material.header.id.text},
                             {"score", points_from(outcome.card.score_milli)},
                             {"gain", points_from(gain_milli)},
                             {"ledger", ledger_json(outcome.card)}});
    return;
  }
  context.out << "score " << points_from(outcome.card.score_milli) << " instead of "
              << points_from(what_if.examination().card.score_milli) << "\n";
}

ExitCode what_if_on(const VerbContext& context, const WhatIfOptions& options) {
  std::vector<Change> changes;
  for (const std::string& text : options.changes) changes.push_back(change_from(text));
  database::Database database = open_to_read(context);
  const AttemptAction wanted{Action::ViewAttempt, {options.attempt}};
  return at_attempt_desk(context, database, wanted, [&](database::AttemptDesk& desk) {
    const AttemptMaterial material = load_attempt(database, desk, {options.attempt});
    const assessment::WhatIf what_if(material.scenario, material.bone, material.recording,
                                     material.header.begun.device_class,
                                     score_attempt(material, stages_on(context)));
    if (changes.empty()) {
      answer_proposals(context, material, what_if);
    } else {
      answer_changes(context, material, what_if, changes);
    }
    return ExitCode::Done;
  });
}

}  // namespace

void add_what_if_verb(CLI::App& app, VerbContext& context) {
  auto options = std::make_shared<WhatIfOptions>();
  CLI::App* verb =
      app.add_subcommand("what-if", "what another performance would have earned; stores nothing");
  verb->add_option("attempt", options->attempt, "the attempt's id, or its first characters")
      ->required();
  verb->add_option("--change", options->changes,
                   "CHANGE=VALUE, repeatable: tilt:CUT, roll:CUT [deg], offset:CUT, stop:HINGE "
                   "[mm], or a metric of the work; without one the three that gain most")
      ->type_name("CHANGE=VALUE")
      ->allow_extra_args(false);
  choose(*verb, context, [options, &context] { return what_if_on(context, *options); });
}

}  // namespace hallux::ui

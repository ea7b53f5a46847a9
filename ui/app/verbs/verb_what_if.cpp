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
#include "ui/report/what_if_text.h"

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

/// The words of report and screen, and what to give --change for each.
void write_proposals(std::ostream& out, const assessment::Proposals& proposals,
                     const SaidWhatIf& said) {
  for (std::size_t i = 0; i < said.changes.size(); ++i) {
    const SaidChange& change = said.changes[i];
    out << change.gain << "  " << change.head << "\n    " << change.body << "\n    --change "
        << proposals.changes[i].change.name << "=" << proposals.changes[i].to << "\n";
  }
  if (!said.together.empty())
    out << said.together_gain << "  " << said.together << "\n    " << said.together_score << "\n";
  if (!said.nothing.empty()) out << said.nothing << "\n";
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
  write_proposals(context.out, proposals,
                  said_what_if(proposals, material.scenario, what_if.examination().plan,
                               what_if.examination().card));
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
    const AttemptMaterial material = load_to_score(database, desk, {options.attempt});
    const assessment::WhatIf what_if(material.scenario, material.bones, material.recording,
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

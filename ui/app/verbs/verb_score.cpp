#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>

#include "database/audit/anchors.h"
#include "database/course/score_json.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"
#include "ui/app/verbs/card_json.h"
#include "ui/jobs/attempt_jobs.h"
#include "ui/jobs/files/output_file.h"
#include "ui/report/html_report.h"
#include "ui/report/report_facts.h"
#include "ui/report/report_pictures.h"
#include "ui/report/score_sheet.h"

namespace hallux::ui {

namespace {

using database::Action;
using nlohmann::ordered_json;

struct ReportOptions {
  std::string attempt;
  std::filesystem::path output;
};

/// The attempt as it is about that card: what was signed for another is signed for an earlier
/// score.
database::AttemptHeader header_about(database::AttemptDesk& desk, const database::AttemptId& id,
                                     const database::ScoreCard& card) {
  database::AttemptHeader header = desk.header(id);
  const std::optional<database::StoredScore> in_force = desk.score(id);
  if (!in_force || !database::is_same_score(in_force->card, card))
    header.decision_is_of_score_in_force = false;
  return header;
}

/// Somebody stands for the machine's score as it is.
bool is_confirmed(const database::AttemptHeader& header) noexcept {
  return header.decision == database::DecisionKind::Confirmed &&
         header.decision_is_of_score_in_force;
}

ExitCode score_on(const VerbContext& context, const std::string& id) {
  database::Database database = open_kept(context);
  const AttemptAction wanted{Action::StoreScore, {id}};
  return at_attempt_desk(context, database, wanted, [&](database::AttemptDesk& desk) {
    const AttemptMaterial material = load_to_score(database, desk, {id});
    const bool is_stored = desk.may(Action::StoreScore, material.header);
    if (!is_stored) {
      context.notes << "The score is shown and not kept: the robot's attempts are scored anew "
                       "without --as, or by instructors and administrators.\n";
    }
    const assessment::Examination examination = score_attempt(material, stages_on(context));
    const database::ScoreCard& card = examination.card;
    if (is_stored) store_examination(desk, material, examination);
    const database::AttemptHeader header = header_about(desk, material.header.id, card);
    if (context.json) {
      ordered_json answer = {{"attempt", material.header.id.text},
                             {"scenario", material.header.scenario_name},
                             {"state", database::name_of(material.header.state)},
                             {"stored", is_stored}};
      answer.update(card_summary_json(card, is_confirmed(header)));
      answer["ledger"] = ledger_json(card);
      answer["measurements"] = measurements_json(examination.measurements);
      write_json(context.out, answer);
    } else {
      context.out << score_sheet(card, material.scenario, signature_text(header));
    }
    return ExitCode::Done;
  });
}

ExitCode report_on(const VerbContext& context, const ReportOptions& options) {
  check_output(options.output, report_page, context.data_directory);
  database::Database database = open_to_read(context);
  const AttemptAction wanted{Action::ViewAttempt, {options.attempt}};
  return at_attempt_desk(context, database, wanted, [&](database::AttemptDesk& desk) {
    const AttemptMaterial material = load_to_score(database, desk, {options.attempt});
    const assessment::WhatIf what_if(material.scenario, material.bones, material.recording,
                                     material.header.begun.device_class,
                                     score_attempt(material, stages_on(context)));
    const assessment::Examination& examination = what_if.examination();
    ReportMaterial shown = report_material(material.scenario, material.bones, material.recording,
                                           examination, material.header.begun.guidance);
    const assessment::Proposals proposals =
        cancelled_as("stopped while trying changes; no report was written",
                     [&] { return what_if.propose(stages_on(context)("Trying changes")); });
    shown.what_if = said_what_if(proposals, material.scenario, examination.plan, examination.card);
    const auto quality = quality_from_json(material.header.quality_json);
    add_attempt_facts(shown, header_about(desk, material.header.id, shown.card),
                      quality ? verdict_of(quality->certificate) : database::Verdict{});
    shown.versions.push_back({"Anchor", text_of(database::take_anchor(database))});
    const std::string page = html_report(shown);
    write_output(options.output, page, report_page, context.data_directory);
    answer(context,
           {{"attempt", material.header.id.text},
            {"file", options.output.string()},
            {"bytes", page.size()}},
           [&](std::ostream& out) {
             out << "report " << terminal_text(options.output.string()) << "\n";
           });
    return ExitCode::Done;
  });
}

}  // namespace

void add_score_verbs(CLI::App& app, VerbContext& context) {
  auto id = std::make_shared<std::string>();
  CLI::App* score =
      app.add_subcommand("score", "score an attempt from what was recorded, and keep the score");
  score->add_option("attempt", *id, "the attempt's id, or its first characters")->required();
  choose(*score, context, [id, &context] { return score_on(context, *id); });

  auto options = std::make_shared<ReportOptions>();
  CLI::App* report = app.add_subcommand("report", "write an attempt's report as one HTML page");
  report->add_option("attempt", options->attempt, "the attempt's id, or its first characters")
      ->required();
  report->add_option("-o,--output", options->output, "the file to write")
      ->required()
      ->check(fault_in_place);
  choose(*report, context, [options, &context] { return report_on(context, *options); });
}

}  // namespace hallux::ui

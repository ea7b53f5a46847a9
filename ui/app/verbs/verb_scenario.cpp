#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iomanip>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "simulator/base/units.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/card_json.h"
#include "ui/jobs/course/scenario_jobs.h"
#include "ui/jobs/prove_scenario.h"
#include "ui/sight/check_start_view.h"

namespace hallux::ui {
namespace {

using nlohmann::ordered_json;
using scenarios::Scenario;

ordered_json summary_json(const Scenario& scenario) {
  return {{"name", scenario.name},
          {"title", scenario.title},
          {"version", scenario.version},
          {"rubric_version", scenario.rubric.version},
          {"reviewed", scenario.is_reviewed},
          {"review", scenarios::review_label(scenario)}};
}

ExitCode list_on(const VerbContext& context) {
  const auto print = [](std::ostream& out, const Scenario& scenario) {
    out << scenario.name << "  " << scenario.title << ", version " << scenario.version << ", "
        << scenarios::review_label(scenario) << "\n";
  };
  return answer_with_list(context, list_scenarios(), summary_json, print);
}

ordered_json planned_json(const scenarios::PlannedCut& cut) {
  const Vec3& normal = cut.face.normal;
  return {{"name", cut.name},
          {"normal", {normal.x, normal.y, normal.z}},
          {"offset_mm", cut.face.offset_mm},
          {"depth_mm", cut.depth_mm}};
}

ordered_json seen_json(const ViewJudgement& seen, bool is_default) {
  return {{"default", is_default},
          {"tooth_line_share", seen.mean.tooth_line_share},
          {"kerf_share", seen.mean.kerf_share},
          {"blade_angle_deg", degree_from_radian(seen.blade_angle_rad)},
          {"saw_inside", seen.is_saw_inside},
          {"saw_from_lower_corner", seen.is_from_lower_corner},
          {"good", is_good(seen)}};
}

/// Of the start that the scenario says, or of the one that it opens with without a word.
void print_seen(std::ostream& out, const StartViewCheck& view) {
  const char* which = view.is_default ? "The default start view" : "Its start view";
  if (!view.why_not_drawn.empty()) {
    out << which << " was not looked at: " << view.why_not_drawn << ".\n";
  }
  if (!view.judgement) return;
  const auto percent = [](double share) { return std::lround(std::floor(100.0 * share)); };
  out << which << " shows " << percent(view.judgement->mean.tooth_line_share)
      << " % of the teeth and " << percent(view.judgement->mean.kerf_share)
      << " % of the kerf over the planned strokes.\n";
}

ExitCode check_on(const VerbContext& context, const std::filesystem::path& file) {
  const CheckedScenario checked = check_scenario_file(file);
  const Scenario& scenario = checked.scenario;
  const StartViewCheck view =
      check_start_view(scenario, checked.bones, checked.plan, file.filename().string());
  if (context.json) {
    ordered_json answer = summary_json(scenario);
    answer["file"] = file.string();
    answer["cuts"] = ordered_json::array();
    for (const scenarios::PlannedCut& cut : checked.plan.cuts) {
      answer["cuts"].push_back(planned_json(cut));
    }
    answer["start_view"] =
        view.judgement ? seen_json(*view.judgement, view.is_default) : ordered_json();
    write_json(context.out, answer);
    return ExitCode::Done;
  }
  const std::size_t cut_count = checked.plan.cuts.size();
  context.out << terminal_text(file.string()) << ": \"" << scenario.name << "\" version "
              << scenario.version << " can be used: " << cut_count
              << (cut_count == 1 ? " cut meets" : " cuts meet") << " the bone; "
              << scenarios::review_label(scenario) << ".\n";
  print_seen(context.out, view);
  return ExitCode::Done;
}

ExitCode show_on(const VerbContext& context, const std::string& name) {
  const Scenario scenario = scenarios::load_shipped_scenario(name);
  ordered_json text = ordered_json::parse(scenario.text);
  text["review"] = scenarios::review_label(scenario);
  answer(context, text, [&](std::ostream& out) { out << scenario_sheet(scenario); });
  return ExitCode::Done;
}

ordered_json losses_json(const std::vector<LostPoints>& lost) {
  ordered_json list = ordered_json::array();
  for (const LostPoints& each : lost) {
    list.push_back(
        {{"item", each.item}, {"points_lost", points_from(each.lost_milli)}, {"text", each.text}});
  }
  return list;
}

ordered_json performance_json(const ProvedPerformance& performance) {
  return {{"name", performance.name},
          {"score", points_from(performance.score_milli)},
          {"lost", losses_json(performance.lost)},
          {"expected", performance.expected},
          {"ok", performance.is_ok()},
          {"differences", performance.differences}};
}

void print_performance(std::ostream& out, const ProvedPerformance& performance) {
  out << (performance.is_ok() ? "  as expected  " : "  DIFFERS      ") << std::fixed
      << std::setprecision(1) << points_from(performance.score_milli) << "  "
      << terminal_text(performance.name) << "\n";
  for (const std::string& difference : performance.differences)
    out << "      " << terminal_text(difference) << "\n";
}

ExitCode prove_on(const VerbContext& context, const std::string& name) {
  const Scenario scenario = load_scenario(name);
  const ScenarioProof proof = prove_scenario(scenario, stages_on(context));
  ordered_json performances = ordered_json::array();
  for (const ProvedPerformance& each : proof.faults) performances.push_back(performance_json(each));
  answer(context,
         {{"scenario", scenario.name},
          {"scenario_version", scenario.version},
          {"passed", proof.has_passed()},
          {"perfect", performance_json(proof.perfect)},
          {"performances", std::move(performances)}},
         [&](std::ostream& out) {
           print_performance(out, proof.perfect);
           for (const ProvedPerformance& each : proof.faults) print_performance(out, each);
           out << (proof.has_passed() ? "The rubric is proven.\n" : "The rubric is not proven.\n");
         });
  return proof.has_passed() ? ExitCode::Done : ExitCode::CheckFailed;
}

}  // namespace

void add_scenario_verb(CLI::App& app, VerbContext& context) {
  CLI::App* verb = app.add_subcommand("scenario", "list, check, prove and show operations");
  verb->require_subcommand(1);

  CLI::App* list = verb->add_subcommand("list", "list the scenarios that come with the program");
  choose(*list, context, [&context] { return list_on(context); });

  // The callbacks outlive this function, so what they read is shared between the option and the
  // callback.
  const auto file = std::make_shared<std::string>();
  CLI::App* check =
      verb->add_subcommand("check", "read a scenario and lay its planes on its patient");
  check->add_option("FILE", *file, "The scenario's JSON file")->required();
  choose(*check, context, [&context, file] { return check_on(context, *file); });

  const auto proved = std::make_shared<std::string>();
  CLI::App* prove = verb->add_subcommand(
      "prove", "let the perfect hand operate, without and with each fault that the scenario lists");
  prove->add_option("NAME", *proved, "A shipped scenario's name, or a file")->required();
  choose(*prove, context, [&context, proved] { return prove_on(context, *proved); });

  const auto name = std::make_shared<std::string>();
  CLI::App* show = verb->add_subcommand("show", "show a scenario with the origin of every number");
  show->add_option("NAME", *name, "The scenario's name, as `scenario list` prints it")->required();
  choose(*show, context, [&context, name] { return show_on(context, *name); });
}

}  // namespace hallux::ui

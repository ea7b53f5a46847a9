/// attempt, attempts. A scripted attempt goes through loop, recorder and score as a person's does,
/// and stays the robot's whoever asked for it. A hand that is none of the names is a file with a
/// motion: the hands that feel lead the saw themselves, so that the modelled arm takes a file
/// alone.
#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <iomanip>
#include <memory>
#include <ostream>
#include <vector>

#include "assessment/pass_mark.h"
#include "scenarios/hands/hand_file.h"
#include "scenarios/hands/hand_skill.h"
#include "simulator/base/digest.h"
#include "simulator/base/units.h"
#include "simulator/base/utf8.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"
#include "ui/app/verbs/card_json.h"
#include "ui/app/verbs/station_access.h"
#include "ui/jobs/attempt_jobs.h"
#include "ui/jobs/course/scenario_jobs.h"
#include "ui/jobs/devices/lent_hand.h"
#include "ui/jobs/files/read_small_file.h"
#include "ui/jobs/left_behind_json.h"
#include "ui/report/score_sheet.h"
#include "ui/sight/start_place.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t hand_mebibytes_max = 16;

struct AttemptOptions {
  std::string scenario, hand = "expert", pacing = "virtual", guidance = "none";
  std::string device = "scripted", force_law = "simulated";
  std::vector<std::string> faults;
  std::uint64_t seed = 1;
  /// Of somebody's hand on a device.
  double seconds = 0.0;
};

/// Neither of the two that are always there: the id of one that is plugged in.
bool is_plugged(const AttemptOptions& options) {
  return options.device != "scripted" && options.device != "arm";
}

/// errors  VerbError: WrongUsage
void check_device(const AttemptOptions& options) {
  if (options.device == "arm" && scenarios::is_hand_name(options.hand)) {
    throw VerbError(ExitCode::WrongUsage, "--device arm takes a hand from a file: the " +
                                              options.hand +
                                              " leads the saw itself; give --hand FILE");
  }
  if (is_plugged(options) && !(options.seconds > 0.0)) {
    throw VerbError(ExitCode::WrongUsage,
                    "--device " + terminal_text(options.device) +
                        " is held by somebody: say for how long, with --seconds");
  }
  if (!is_plugged(options) && options.seconds > 0.0) {
    throw VerbError(ExitCode::WrongUsage,
                    "--seconds is for a device that somebody holds; add --device ID");
  }
  if (options.device == "scripted" && options.force_law == "historic") {
    throw VerbError(ExitCode::WrongUsage,
                    "--force-law historic is felt by an arm alone; add --device arm");
  }
}

/// errors  VerbError: WrongUsage where no hand with a name would do them
void check_faults(const AttemptOptions& options) {
  if (options.faults.empty()) return;
  if (!scenarios::is_hand_name(options.hand) || is_plugged(options)) {
    throw VerbError(ExitCode::WrongUsage,
                    "--fault is of a hand that carries out the plan: give --hand expert, novice or "
                    "perfect, and no other --device");
  }
}

std::string fault_names() {
  std::string names;
  for (const scenarios::FaultRow& row : scenarios::fault_table())
    names += (names.empty() ? "" : ", ") + std::string(row.name);
  return names;
}

/// How a hand's file is named in the record: without the folders it lay in, and by its content.
/// errors  ScenarioError
std::string kept_name_of(const std::filesystem::path& file, std::string_view content) {
  constexpr std::size_t digits_shown = 16;
  const std::string name = file.filename().string();
  if (!is_utf8(name) || has_hidden_letters(name)) {
    throw scenarios::ScenarioError(
        terminal_text(name) +
        ": the name holds letters that nobody sees, and it is kept with the attempt; rename the "
        "file");
  }
  const Digest digest = digest_of(std::as_bytes(std::span{content.data(), content.size()}));
  return name + " " + hex_from_digest(digest).substr(0, digits_shown);
}

/// A whole number that fits; a larger one is not made to fit.
std::string fault_in_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seed);
  const bool is_seed = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return is_seed ? "" : "must be a whole number from 0 to 18446744073709551615";
}

/// A hand that is none of the names is a file with a motion.
ScriptedAttempt attempt_from(const AttemptOptions& options) {
  check_device(options);
  check_faults(options);
  ScriptedAttempt attempt;
  attempt.scenario = load_scenario(options.scenario);
  attempt.hand = options.hand;
  attempt.seed = options.seed;
  attempt.pacing =
      options.pacing == "real-time" ? simulator::Pacing::RealTime : simulator::Pacing::Virtual;
  attempt.guidance =
      database::named<simulator::Guidance>(options.guidance).value_or(simulator::Guidance::None);
  if (options.device == "arm") attempt.arm_law = force_law_from(options.force_law);
  attempt.faults = scenarios::parse_hand_faults(options.faults, attempt.scenario);
  if (scenarios::is_hand_name(options.hand)) return attempt;
  const std::string text =
      read_small_file(options.hand, hand_mebibytes_max,
                      "--hand takes expert, novice, perfect, or a file with a motion");
  attempt.motion =
      scenarios::parse_hand_motion(text, options.hand, scenarios::laid_out_tools(attempt.scenario));
  attempt.hand = kept_name_of(options.hand, text);
  return attempt;
}

ordered_json outcome_json(const ScriptedAttempt& attempt, const AttemptOutcome& outcome) {
  ordered_json answer = {{"attempt", outcome.attempt.text},
                         {"scenario", attempt.scenario.name},
                         {"hand", scenarios::hand_with_faults(attempt.hand, attempt.faults)},
                         {"faults", ordered_json::array()},
                         {"seed", attempt.seed}};
  for (const scenarios::HandFault& fault : attempt.faults) {
    answer["faults"].push_back(scenarios::text_of(fault));
  }
  answer.update(card_summary_json(outcome.card, false));
  answer["samples"] = outcome.recorder.samples;
  answer["duration_s"] = second_from_tick(outcome.loop.ticks);
  if (outcome.left) {
    answer["steps"] = steps_json(*outcome.left, attempt.scenario);
    answer["fragments"] = fragments_json(*outcome.left);
    answer["implants"] = implants_json(*outcome.left);
    answer["balance"] = balance_json(*outcome.left);
  }
  answer["quality"] = ordered_json::parse(quality_json(outcome.quality));
  answer["loop"] = {{"step_us",
                     {{"p50", outcome.loop.step_p50_us},
                      {"p99", outcome.loop.step_p99_us},
                      {"max", outcome.loop.step_max_us}}}};
  answer["recorder"] = {{"bytes", outcome.recorder.bytes},
                        {"chunks", outcome.recorder.chunks},
                        {"cpu_s", outcome.recorder.cpu_s},
                        {"commit_max_s", outcome.recorder.commit_max_s}};
  return answer;
}

/// Whoever moves the device leads the saw, from where the operation begins and as it is seen there.
/// errors  VerbError: NoDisplay where the device cannot be used, or nobody brought it home
HeldHand held_hand(const VerbContext& context, const AttemptOptions& options,
                   const std::shared_ptr<simulator::Station>& station,
                   const scenarios::Scenario& scenario) {
  const simulator::FoundDevice found = usable_device(*station, options.device);
  had_or_not_usable(
      [&] { bring_home(*station, found, progress_on(context, "Homing " + found.id)); });
  HeldHand held;
  held.last_tick = static_cast<std::int64_t>(options.seconds / step_s);
  held.force_law = *force_law_from(options.force_law);
  held.lend = [station, &scenario, found](const simulator::Bones& bones,
                                          const scenarios::Plan& plan) {
    std::unique_ptr<simulator::HapticDevice> device;
    had_or_not_usable([&] {
      device = lend_hand(
          station, found, {},
          {start_pose(scenario, bones, plan), start_camera(scenario, bones, plan).world_from_view});
    });
    return device;
  };
  return held;
}

ExitCode run_attempt_verb(const VerbContext& context, const AttemptOptions& options) {
  ScriptedAttempt attempt = attempt_from(options);
  attempt.asks_what_is_left = context.json;
  if (is_plugged(options)) {
    attempt.held = held_hand(context, options, open_station(context), attempt.scenario);
    attempt.hand = "held";
    attempt.pacing = simulator::Pacing::RealTime;
  }
  database::Database database = open_to_record(context);
  // The attempt is the robot's all the same; but nobody is told that another's name was good.
  if (!context.login.empty()) sign_in_as(context, database);
  const AttemptOutcome outcome = run_scripted_attempt(database, attempt, stages_on(context));
  answer(context, outcome_json(attempt, outcome), [&](std::ostream& out) {
    out << score_sheet(outcome.card, attempt.scenario) << "\nattempt " << outcome.attempt.text
        << "\n";
  });
  return ExitCode::Done;
}

ordered_json points_json(const std::optional<std::int64_t>& milli) {
  return milli ? ordered_json(static_cast<double>(*milli) / 1000.0) : ordered_json();
}

/// The result that stands, with what it was made with: the signed score's, or the machine's.
ordered_json result_json(const database::AttemptHeader& header) {
  if (!header.score_milli || header.state == database::AttemptState::Void) return nullptr;
  const std::int64_t milli = header.decided_milli.value_or(*header.score_milli);
  const assessment::PassAnswer answer = assessment::pass_answer(header.pass, milli);
  return {{"score", points_json(milli)},
          {"rubric_version", header.rubric_version},
          {"measured_weight", points_json(header.pass.measured_milli)},
          {"gated", header.pass.is_gated},
          {"passed", answer == assessment::PassAnswer::NotDecided
                         ? ordered_json()
                         : ordered_json(answer == assessment::PassAnswer::Reached)}};
}

ordered_json attempt_json(const database::AttemptHeader& header) {
  return {{"attempt", header.id.text},
          {"scenario", header.scenario_name},
          {"number", header.number},
          {"person", header.begun.person ? ordered_json(header.login) : ordered_json()},
          {"hand", header.begun.hand},
          {"seed", header.begun.seed},
          {"started", header.started_utc},
          {"state", database::name_of(header.state)},
          {"score", points_json(header.score_milli)},
          {"kind", database::name_of(header.begun.kind)},
          {"guidance", database::name_of(header.begun.guidance)},
          {"decision",
           header.decision ? ordered_json(database::name_of(*header.decision)) : ordered_json()},
          {"decided_score", points_json(header.decided_milli)},
          {"signed_for_score_in_force",
           header.decision ? ordered_json(header.decision_is_of_score_in_force) : ordered_json()},
          {"grade", is_grade(header)},
          {"result", result_json(header)},
          {"simulated", header.is_simulated},
          {"valid", or_null(header.is_valid)}};
}

void print_attempt(std::ostream& out, const database::AttemptHeader& header) {
  const std::string who =
      header.begun.person ? header.login : "robot, " + terminal_text(header.begun.hand);
  out << header.id.text << "  " << header.started_utc << "  " << std::left << std::setw(12)
      << header.scenario_name << std::setw(20) << who << std::setw(12)
      << database::name_of(header.state);
  if (header.score_milli) {
    out << std::fixed << std::setprecision(1) << static_cast<double>(*header.score_milli) / 1000.0;
  } else {
    out << "not scored";
  }
  if (header.begun.guidance != simulator::Guidance::None) {
    out << "  guided: " << database::name_of(header.begun.guidance);
  }
  if (header.decision) out << "  " << database::name_of(*header.decision);
  if (header.decision && !header.decision_is_of_score_in_force) out << " (an earlier score)";
  if (header.decided_milli && header.decided_milli != header.score_milli) {
    out << " " << static_cast<double>(*header.decided_milli) / 1000.0;
  }
  out << (header.is_simulated ? "  simulated" : "") << "\n";
}

/// Those that who signed in may list from any of their desks; the robot's without --as.
std::vector<database::AttemptHeader> visible_attempts(const VerbContext& context,
                                                      database::Database& database) {
  if (context.login.empty()) return database::HouseDesk(database).attempts();
  return sign_in_as(context, database).attempts();
}

ExitCode list_attempts_on(const VerbContext& context) {
  if (!has_database(context)) {
    context.notes << "there is no database in " << terminal_text(context.data_directory.string())
                  << " yet\n";
    if (context.json) write_json(context.out, ordered_json::array());
    return ExitCode::Done;
  }
  database::Database database = open_to_read(context);
  return answer_with_list(context, visible_attempts(context, database), attempt_json,
                          print_attempt);
}

}  // namespace

void add_attempt_verbs(CLI::App& app, VerbContext& context) {
  auto options = std::make_shared<AttemptOptions>();
  CLI::App* attempt = app.add_subcommand(
      "attempt", "run a scripted attempt through loop, recorder and score; it is the robot's");
  attempt->add_option("scenario", options->scenario, "a shipped scenario's name, or a file")
      ->required();
  attempt
      ->add_option("--hand", options->hand,
                   "expert, novice, perfect (without any error), or a file with a motion")
      ->capture_default_str();
  attempt
      ->add_option("--fault", options->faults,
                   "what the hand does wrong on purpose, NAME[:SUBJECT][=SIZE], may be repeated: " +
                       fault_names())
      ->type_name("FAULT")
      ->allow_extra_args(false);
  attempt->add_option("--seed", options->seed, "seed of the hand's errors")
      ->check(fault_in_seed)
      ->capture_default_str();
  attempt->add_option("--pacing", options->pacing, "virtual (as fast as it goes) or real-time")
      ->check(CLI::IsMember({"virtual", "real-time"}))
      ->capture_default_str();
  attempt
      ->add_option("--guidance", options->guidance,
                   "how firmly the planned plane leads the hand: none, soft or slot")
      ->check(CLI::IsMember({"none", "soft", "slot"}))
      ->capture_default_str();
  attempt
      ->add_option(
          "--device", options->device,
          "scripted (nothing pushes the hand), arm (a modelled one, led by the motion of a "
          "file), or one that `hallux devices` lists: whoever moves it operates")
      ->type_name("DEVICE")
      ->capture_default_str();
  attempt->add_option("--seconds", options->seconds, "how long somebody operates with a device")
      ->check(CLI::Range(0.1, 3600.0));
  attempt
      ->add_option(
          "--force-law", options->force_law,
          "what the arm is made to feel: simulated, or historic (the thesis's, for the lesson)")
      ->check(CLI::IsMember({"simulated", "historic"}))
      ->capture_default_str();
  choose(*attempt, context, [options, &context] { return run_attempt_verb(context, *options); });

  CLI::App* attempts = app.add_subcommand("attempts", "list attempts, newest first");
  choose(*attempts, context, [&context] { return list_attempts_on(context); });
}

}  // namespace hallux::ui

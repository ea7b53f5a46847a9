#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "ui/app/verbs/access.h"
#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;
using simulator::ReplayResult;

ordered_json replay_json(const AttemptMaterial& material, const std::optional<ReplayResult>& result,
                         double seconds) {
  ordered_json answer = {
      {"attempt", material.header.id.text},
      {"identical", result ? ordered_json(result->is_identical) : ordered_json()},
      {"bone_hash", result ? ordered_json(hex_from_digest(result->bone)) : ordered_json()},
      {"output_hash", result ? ordered_json(hex_from_digest(result->outputs)) : ordered_json()},
      {"samples", static_cast<std::int64_t>(material.recording.samples.size())},
      {"seconds", seconds},
      {"engine", simulator::engine_version},
      {"attempt_engine", material.header.begun.engine}};
  if (result && !result->is_identical) {
    answer["first_difference_tick"] = result->first_difference_tick;
    answer["difference"] = result->difference;
  }
  return answer;
}

void print_replay(std::ostream& out, const AttemptMaterial& material,
                  const std::optional<ReplayResult>& result, double seconds) {
  if (!result) {
    out << "The attempt was made by engine version " << material.header.begun.engine
        << ", this is version " << simulator::engine_version
        << ": a replay would prove nothing. It is still scored from what was recorded.\n";
  } else if (result->is_identical) {
    out << "identical: " << result->samples << " samples in " << seconds << " s\nbone "
        << hex_from_digest(result->bone) << "\n";
  } else {
    out << "different from tick " << result->first_difference_tick << " on: " << result->difference
        << "\n";
  }
}

ExitCode replay_on(const VerbContext& context, const std::string& id) {
  database::Database database = open_to_read(context);
  const AttemptAction wanted{database::Action::ViewAttempt, {id}};
  return at_attempt_desk(context, database, wanted, [&](database::AttemptDesk& desk) {
    const AttemptMaterial material = load_attempt(database, desk, {id});
    const auto before = std::chrono::steady_clock::now();
    const std::optional<ReplayResult> result = replay_attempt(material, stages_on(context));
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    answer(context, replay_json(material, result, seconds),
           [&](std::ostream& out) { print_replay(out, material, result, seconds); });
    return result && !result->is_identical ? ExitCode::CheckFailed : ExitCode::Done;
  });
}

}  // namespace

void add_replay_verb(CLI::App& app, VerbContext& context) {
  auto id = std::make_shared<std::string>();
  CLI::App* replay = app.add_subcommand(
      "replay", "run the step again from the recorded input and compare every output");
  replay->add_option("attempt", *id, "the attempt's id, or its first characters")->required();
  choose(*replay, context, [id, &context] { return replay_on(context, *id); });
}

}  // namespace hallux::ui

#include "ui/jobs/attempt_jobs.h"

#include <utility>

#include "assessment/metrics_version.h"
#include "assessment/sentences.h"
#include "database/content/assets.h"
#include "database/recording/recordings.h"
#include "scenarios/hands/feeling_hand.h"
#include "scenarios/patient.h"
#include "scenarios/plan_digest.h"
#include "scenarios/simulation_setup.h"
#include "simulator/base/check.h"
#include "simulator/base/progress.h"
#include "simulator/device/modelled/modelled_arm.h"
#include "simulator/device/scripted.h"

namespace hallux::ui {

namespace {

constexpr std::string_view bone_asset = "bone";

}  // namespace

std::vector<simulator::Bone> patient_of(const scenarios::Scenario& scenario,
                                        const StageProgress& progress) {
  return cancelled_as("stopped while the bone was being built; nothing was stored", [&] {
    return scenarios::make_patient_bones(scenario, progress("Building the bone"));
  });
}

void put_patient(database::Database& database, const simulator::Bones& bones,
                 database::NewAttempt& begun) {
  begun.bone = put_asset(database, bone_asset, encode_patient(bones));
}

namespace {

database::NewAttempt describe(database::Database& database, const ScriptedAttempt& attempt,
                              const simulator::Bones& bones,
                              const simulator::DeviceDescription& device) {
  const scenarios::Scenario& scenario = attempt.scenario;
  database::NewAttempt begun;
  begun.scenario = put_scenario_version(
      database, {scenario.name, scenario.version, scenario.text, scenario.claims_review});
  begun.hand = scenarios::hand_with_faults(attempt.hand, attempt.faults);
  begun.seed = attempt.seed;
  begun.guidance = attempt.guidance;
  begun.device_class = device.device_class;
  begun.pacing = attempt.pacing == simulator::Pacing::RealTime ? "real_time" : "virtual";
  put_patient(database, bones, begun);
  return begun;
}

/// `setup` is told how long it takes and who says commands.
std::unique_ptr<simulator::HapticDevice> hand_for(const ScriptedAttempt& attempt,
                                                  const simulator::Bones& bones,
                                                  const scenarios::Plan& plan,
                                                  simulator::AttemptSetup& setup) {
  if (attempt.held) {
    setup.last_tick = attempt.held->last_tick;
    setup.force_law = attempt.held->force_law;
    setup.commands = {{0, {simulator::CommandKind::Start, 0, 0}},
                      {setup.last_tick, {simulator::CommandKind::Finish, 0, 0}}};
    return attempt.held->lend(bones, plan);
  }
  if (attempt.motion) {
    setup.commands = attempt.motion->commands;
    setup.last_tick = attempt.motion->last_tick() + 1;
    if (attempt.arm_law) {
      setup.force_law = *attempt.arm_law;
      simulator::ModelledArmSetup arm;
      arm.seed = attempt.seed;
      return std::make_unique<simulator::ModelledArm>(*attempt.motion, arm);
    }
    return std::make_unique<simulator::ScriptedDevice>(*attempt.motion);
  }
  auto hand = std::make_unique<scenarios::FeelingHand>(
      attempt.scenario, bones, plan,
      scenarios::with_faults(scenarios::hand_skill(attempt.hand), attempt.faults), attempt.seed);
  setup.last_tick = hand->end_tick();
  setup.attempt_operator = hand.get();
  return hand;
}

}  // namespace

SetUpHand set_up_hand(const ScriptedAttempt& attempt, simulator::Bones bones,
                      const scenarios::Plan& plan) {
  SetUpHand made{{simulation_setup(attempt.scenario, bones, plan, attempt.guidance)}, nullptr};
  made.setup.pacing = attempt.pacing;
  made.hand = hand_for(attempt, bones, plan, made.setup);
  return made;
}

namespace {

/// All but the card. What it took is let go of before somebody scores it.
AttemptOutcome operate(database::Database& database, database::HouseDesk& desk,
                       const ScriptedAttempt& attempt, const StageProgress& progress) {
  const std::vector<simulator::Bone> bones = patient_of(attempt.scenario, progress);
  // The plan is laid on the patient before anything is stored, also where a motion from a file does
  // not need it.
  const scenarios::Plan plan = plan_on(attempt.scenario, bones);
  const SetUpHand set_up = set_up_hand(attempt, bones, plan);

  AttemptOutcome outcome;
  simulator::AttemptChannels channels;
  database::Recorder recorder(
      database, desk.begin_attempt(describe(database, attempt, bones, set_up.hand->description())),
      channels);
  outcome.attempt = recorder.attempt();
  const auto operating = progress("Operating");
  outcome.loop = run_attempt(set_up.setup, *set_up.hand, channels, operating);
  outcome.recorder = recorder.drain();
  if (outcome.loop.end == simulator::AttemptEnd::Cancelled) {
    throw Cancelled("stopped while operating; attempt " + outcome.attempt.text +
                    " is kept as interrupted");
  }
  // A hand that is done early, or between two reports, is done.
  if (operating) operating(1.0);
  outcome.quality = quality_of(outcome.loop, outcome.recorder);
  outcome.quality.device = set_up.hand->facts();
  outcome.recorder = recorder.finish(quality_json(outcome.quality));
  return outcome;
}

}  // namespace

AttemptOutcome run_scripted_attempt(database::Database& database, const ScriptedAttempt& attempt,
                                    const StageProgress& progress) {
  CHECK(!attempt.arm_law || attempt.motion);
  database::HouseDesk desk(database);
  AttemptOutcome outcome = operate(database, desk, attempt, progress);
  const AttemptMaterial material = load_to_score(database, desk, outcome.attempt);
  assessment::Examination examination = score_attempt(material, progress);
  store_examination(desk, material, examination);
  outcome.card = std::move(examination.card);
  if (attempt.asks_what_is_left) {
    outcome.left =
        left_behind(material.scenario, examination.plan, material.bones, material.recording,
                    std::move(examination.rebuilt), progress("Looking at what is left"));
  }
  return outcome;
}

namespace {

/// Without its recording.
AttemptMaterial load_patient(database::Database& database, database::AttemptDesk& desk,
                             const database::AttemptId& id) {
  AttemptMaterial material;
  material.header = desk.header(id);
  const database::ScenarioText text =
      get_scenario_version(database, material.header.begun.scenario);
  material.scenario = scenarios::parse_scenario(text.json, text.name);
  material.bones = simulator::decode_patient(get_asset(database, material.header.begun.bone));
  return material;
}

void load_recording(database::AttemptDesk& desk, AttemptMaterial& material,
                    database::RecordingPart part) {
  material.recording = desk.recording(material.header.id, part);
}

void load_packed(database::AttemptDesk& desk, AttemptMaterial& material) {
  database::PackedRecording packed = desk.packed_recording(material.header.id);
  material.recording = std::move(packed.outputs);
  material.packed_tape = std::move(packed.tape);
}

}  // namespace

simulator::Recorded AttemptMaterial::recorded() const {
  if (!recording.tape.empty()) return recording;
  return {recording, packed_tape.lines()};
}

AttemptMaterial load_attempt(database::Database& database, database::AttemptDesk& desk,
                             const database::AttemptId& id) {
  AttemptMaterial material = load_patient(database, desk, id);
  load_recording(desk, material, database::RecordingPart::Whole);
  return material;
}

AttemptMaterial load_to_score(database::Database& database, database::AttemptDesk& desk,
                              const database::AttemptId& id) {
  AttemptMaterial material = load_patient(database, desk, id);
  load_packed(desk, material);
  return material;
}

MeasuredMaterial load_measured(database::Database& database, database::AttemptDesk& desk,
                               const database::AttemptId& id) {
  MeasuredMaterial measured{load_patient(database, desk, id), std::nullopt};
  AttemptMaterial& attempt = measured.attempt;
  measured.measurements = desk.measurements(
      attempt.header.id, measured_by(attempt.scenario, attempt.header.begun.bone));
  if (measured.measurements) {
    load_recording(desk, attempt, database::RecordingPart::Outputs);
  } else {
    load_packed(desk, attempt);
  }
  return measured;
}

std::optional<simulator::ReplayResult> replay_attempt(const AttemptMaterial& material,
                                                      const StageProgress& progress) {
  if (material.header.begun.engine != simulator::engine_version) return std::nullopt;
  bool is_cancelled = false;
  const auto report = progress("Replaying");
  const scenarios::Plan plan = plan_on(material.scenario, material.bones);
  const simulator::ReplayResult result = replay(
      material.recording,
      simulation_setup(material.scenario, material.bones, plan, material.header.begun.guidance),
      [&](double fraction) {
        is_cancelled = report && !report(fraction);
        return !is_cancelled;
      });
  if (is_cancelled) throw Cancelled("stopped while replaying; nothing was changed");
  if (report) report(1.0);
  return result;
}

database::MeasuredBy measured_by(const scenarios::Scenario& scenario, const Digest& bone) {
  return {plan_digest(scenario, bone), assessment::metrics_version};
}

void store_examination(database::AttemptDesk& desk, const AttemptMaterial& material,
                       const assessment::Examination& examination) {
  const database::AttemptId& id = material.header.id;
  desk.store_score(id, examination.card);
  desk.store_measurements(id, measured_by(material.scenario, material.header.begun.bone),
                          examination.measurements);
}

std::optional<database::StoredScore> told_score(database::AttemptDesk& desk,
                                                const database::AttemptId& id) {
  std::optional<database::StoredScore> score = desk.score(id);
  if (score) assessment::say(score->card);
  return score;
}

assessment::Examination score_attempt(const AttemptMaterial& material,
                                      const StageProgress& progress) {
  return cancelled_as("stopped while scoring; nothing was changed", [&] {
    return assessment::assess_fully(material.scenario, material.bones, material.recorded(),
                                    material.header.begun.device_class, progress("Scoring"));
  });
}

}  // namespace hallux::ui

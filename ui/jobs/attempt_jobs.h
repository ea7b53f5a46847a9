/// What verbs and screens do with attempts: run a scripted one, score it, replay it, gather what a
/// report shows.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "assessment/assess.h"
#include "database/desks/desks.h"
#include "database/recording/packed_tape.h"
#include "database/recording/recorder.h"
#include "database/records/attempt.h"
#include "scenarios/hands/hand_fault.h"
#include "scenarios/plan.h"
#include "simulator/base/progress.h"
#include "simulator/loop/attempt_loop.h"
#include "simulator/loop/replay.h"
#include "ui/jobs/left_behind.h"
#include "ui/jobs/recording_quality.h"

namespace hallux::ui {

/// Gives the progress function of one stage of a job ("Building the bone"); see progress_on.
using StageProgress = std::function<Progress(const std::string& stage)>;

/// Somebody's hand on a device, in place of a scripted one.
struct HeldHand {
  /// The device for these bones and plan; outlived by what it borrows.
  std::function<std::unique_ptr<simulator::HapticDevice>(const simulator::Bones& bones,
                                                         const scenarios::Plan& plan)>
      lend;
  std::int64_t last_tick = 0;
  simulator::ForceLaw force_law = simulator::ForceLaw::Simulated;
};

struct ScriptedAttempt {
  scenarios::Scenario scenario;
  /// One of hand_names, or what a file is called in the record.
  std::string hand = "expert";
  /// Done wrong on purpose by a hand that has a name.
  std::vector<scenarios::HandFault> faults;
  /// From a file; else made for the hand and seed.
  std::optional<simulator::HandMotion> motion;
  std::uint64_t seed = 1;
  simulator::Pacing pacing = simulator::Pacing::Virtual;
  simulator::Guidance guidance = simulator::Guidance::None;
  /// What a modelled arm that the motion leads is made to feel; none: the hand leads the saw
  /// itself, and nothing pushes it.
  std::optional<simulator::ForceLaw> arm_law;
  /// Nobody scripted: whoever holds the device; in real time.
  std::optional<HeldHand> held = std::nullopt;
  /// Whether the outcome tells it.
  bool asks_what_is_left = false;
};

/// The patient of a scenario: all its bones.
/// errors  ScenarioError, MeshError; Cancelled
std::vector<simulator::Bone> patient_of(const scenarios::Scenario& scenario,
                                        const StageProgress& progress);

/// Who carries an attempt out, and how it is run.
struct SetUpHand {
  /// Borrows the hand.
  simulator::AttemptSetup setup;
  std::unique_ptr<simulator::HapticDevice> hand;
};
/// The motion of the attempt, or the hand of its name and seed.
/// needs   the plan is the scenario's on these bones; all three outlive what is returned
SetUpHand set_up_hand(const ScriptedAttempt& attempt, simulator::Bones bones,
                      const scenarios::Plan& plan);

/// Stores the patient that is operated on, as one, and names it in what begins.
/// errors  DatabaseError
void put_patient(database::Database& database, const simulator::Bones& bones,
                 database::NewAttempt& begun);

struct AttemptOutcome {
  database::AttemptId attempt;
  database::ScoreCard card;
  Quality quality;
  simulator::LoopStatistics loop;
  database::RecorderStatistics recorder;
  /// Where it was asked for.
  std::optional<LeftBehind> left = std::nullopt;
};

/// Makes the patient, runs the hand through loop and recorder, scores what was recorded. The
/// attempt is the robot's.
/// needs   a motion where there is an arm: the hands that feel lead the saw themselves
/// errors  ScenarioError, MeshError, DatabaseError; Cancelled: what was recorded stays, as
///         interrupted
AttemptOutcome run_scripted_attempt(database::Database& database, const ScriptedAttempt& attempt,
                                    const StageProgress& progress);

/// An attempt as it is computed with: what was operated on, how, and all that was recorded.
struct AttemptMaterial {
  database::AttemptHeader header;
  scenarios::Scenario scenario;
  /// Of the patient, the operated one first.
  std::vector<simulator::Bone> bones;
  simulator::Recording recording;
  /// Where the recording is without its tape: that, where somebody scores it.
  database::PackedTape packed_tape = {};

  const simulator::Bone& bone() const noexcept { return bones.front(); }
  /// The recording with its tape, wherever that is; borrows both.
  simulator::Recorded recorded() const;
};

/// With its whole recording, 168 bytes a tick: to replay it.
/// errors  DatabaseError: NotFound, Refused, Damaged
AttemptMaterial load_attempt(database::Database& database, database::AttemptDesk& desk,
                             const database::AttemptId& id);
/// With the outputs of its recording, 56 bytes a tick, and the tape as it is stored.
/// errors  DatabaseError: NotFound, Refused, Damaged
AttemptMaterial load_to_score(database::Database& database, database::AttemptDesk& desk,
                              const database::AttemptId& id);

/// An attempt with what was measured of it before; else with all that score_attempt needs.
struct MeasuredMaterial {
  AttemptMaterial attempt;
  std::optional<std::vector<assessment::Measurement>> measurements;
};

/// errors  DatabaseError: NotFound, Refused, Damaged
MeasuredMaterial load_measured(database::Database& database, database::AttemptDesk& desk,
                               const database::AttemptId& id);

/// Nothing where the attempt was made by another engine version: a replay would prove nothing.
std::optional<simulator::ReplayResult> replay_attempt(const AttemptMaterial& material,
                                                      const StageProgress& progress);

/// What the measurements of a recording depend on beside it.
database::MeasuredBy measured_by(const scenarios::Scenario& scenario, const Digest& bone);

/// Stores the score, and the measurements it was made from for later ones.
/// needs   the material's whole recording was examined
/// errors  DatabaseError
void store_examination(database::AttemptDesk& desk, const AttemptMaterial& material,
                       const assessment::Examination& examination);

/// The score in force, in words.
/// errors  DatabaseError
std::optional<database::StoredScore> told_score(database::AttemptDesk& desk,
                                                const database::AttemptId& id);

/// errors  Cancelled
assessment::Examination score_attempt(const AttemptMaterial& material,
                                      const StageProgress& progress);

}  // namespace hallux::ui

/// Facts of an attempt, as they are stored beside its recording.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "database/records/decision.h"
#include "database/records/ids.h"
#include "database/records/names.h"
#include "database/records/score.h"
#include "simulator/base/digest.h"
#include "simulator/record/guidance.h"
#include "simulator/record/record.h"

namespace hallux::database {

enum class AttemptState {
  /// A live writer holds its lease.
  Recording,
  /// Sealed: whole, with duration and quality.
  Closed,
  /// Its writer is gone; valid up to the last committed window.
  Interrupted,
  /// Set aside by an instructor, kept.
  Void
};

template <>
inline constexpr std::array<std::string_view, 4> stored_names<AttemptState>{"recording", "closed",
                                                                            "interrupted", "void"};

/// Of a recording, what is read.
enum class RecordingPart {
  Whole,
  /// Samples and events: what a replay is shown from. The input tape, two thirds of a
  /// recording's memory, is checked and not kept.
  Outputs
};

/// What an attempt was for. In an assessment nothing helps: no ghost of the plan, no read-out.
enum class AttemptKind { Practice, Assessment };

template <>
inline constexpr std::array<std::string_view, 2> stored_names<AttemptKind>{"practice",
                                                                           "assessment"};

template <>
inline constexpr std::array<std::string_view, 3> stored_names<simulator::Guidance>{"none", "soft",
                                                                                   "slot"};

/// What is known when an attempt begins; none of it changes later.
struct NewAttempt {
  ScenarioVersionId scenario;
  /// Nothing: the robot's.
  std::optional<PersonId> person;
  /// "expert", "novice", "perfect", a file's name, or "" for a person's own.
  std::string hand;
  std::uint64_t seed = 0;
  std::string device_class = "scripted";
  /// "virtual" or "real_time".
  std::string pacing = "virtual";
  std::string stereo_mode = "none";
  /// The asset operated on; stored before the attempt.
  Digest bone;
  std::int32_t engine = simulator::engine_version;
  AttemptKind kind = AttemptKind::Practice;
  /// Of a practice only.
  simulator::Guidance guidance = simulator::Guidance::None;
};

struct AttemptHeader {
  AttemptId id;
  /// In which attempts were begun in this directory.
  std::int64_t order = 0;
  /// Of the attempts of its person (or of the robot) at this operation, over all its versions: 1 is
  /// the first that was begun here. What everybody calls it by.
  std::int64_t number = 0;
  NewAttempt begun;
  std::string scenario_name;
  std::int32_t scenario_version = 0;
  Digest scenario_digest;
  /// Of a simulated course: never a person's, never a grade.
  bool is_simulated = false;
  /// Of `begun.person`; "" for the robot and for erased people.
  std::string login;
  /// ISO 8601.
  std::string started_utc;
  AttemptState state = AttemptState::Recording;
  /// Once closed.
  std::optional<std::int64_t> duration_ticks;
  /// Once closed.
  std::string quality_json;
  /// Once closed: no sample was lost.
  bool is_complete = false;
  /// Once closed: may be graded, by its certificate; counts for a limit.
  std::optional<bool> is_valid;
  /// Once closed.
  std::optional<Digest> seal;
  /// Of the machine's score in force, 0 to 100 000.
  std::optional<std::int64_t> score_milli;
  /// Of the score that stands: the one that was signed, else the one in force. What it was made
  /// with.
  std::int32_t rubric_version = 0;
  /// What its card says about passing.
  PassFacts pass;
  /// Not all of the rubric was measured for it.
  bool is_partial = false;
  /// In force; nothing: the machine's score is advisory.
  std::optional<DecisionKind> decision;
  /// The score that stands once confirmed or overridden.
  std::optional<std::int64_t> decided_milli;
  /// False: the machine scored anew since.
  bool decision_is_of_score_in_force = false;
  /// Of an imported one: where it was made.
  std::optional<DirectoryId> origin;
  /// False: from an origin that no administrator accepted.
  bool is_counted = true;
};

/// Whether the result counts: an assessment of a person, with every sample, valid by its
/// certificate and not from an origin that nobody accepted, and either confirmed where the whole
/// rubric was measured, or overridden by an instructor; signed for the score in force, and not for
/// an earlier one.
bool is_grade(const AttemptHeader& header) noexcept;

}  // namespace hallux::database

/// An attempt's facts as they are kept beside its recording.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "database/records/decision.h"
#include "database/records/ids.h"
#include "database/records/score.h"
#include "simulator/base/digest.h"
#include "simulator/record/guidance.h"
#include "simulator/record/record.h"

namespace hallux::database {

enum class AttemptState {
  Recording,    ///< a live writer holds its lease
  Closed,       ///< sealed: whole, with duration and quality
  Interrupted,  ///< its writer is gone; valid up to the last committed window
  Void          ///< set aside by an instructor, kept
};

std::string_view name_of(
    AttemptState state) noexcept;  ///< "recording", "closed", "interrupted", "void"
/// Nothing where `name` is none of the four.
std::optional<AttemptState> attempt_state_from(std::string_view name) noexcept;

/// What an attempt was for. In an assessment nothing helps: no ghost of the plan, no read-out.
enum class AttemptKind { Practice, Assessment };

std::string_view name_of(AttemptKind kind) noexcept;  ///< "practice", "assessment"
/// Nothing where `name` is none of the two.
std::optional<AttemptKind> attempt_kind_from(std::string_view name) noexcept;

std::string_view name_of(simulator::Guidance guidance) noexcept;  ///< "none", "soft", "slot"
/// Nothing where `name` is none of the three.
std::optional<simulator::Guidance> guidance_from(std::string_view name) noexcept;

/// What is known when an attempt begins; none of it changes later.
struct NewAttempt {
  ScenarioVersionId scenario;
  std::optional<PersonId> person;  ///< nothing: the robot's
  std::string hand;                ///< "expert", "novice", a file's name, or "" for a person's own
  std::uint64_t seed = 0;
  std::string device_class = "scripted";
  std::string pacing = "virtual";  ///< "virtual" or "real_time"
  std::string stereo_mode = "none";
  Digest bone;  ///< the asset operated on; stored before the attempt
  std::int32_t engine = simulator::engine_version;
  AttemptKind kind = AttemptKind::Practice;
  simulator::Guidance guidance = simulator::Guidance::None;  ///< of a practice only
};

struct AttemptHeader {
  AttemptId id;
  std::int64_t order = 0;  ///< in which attempts were begun in this directory
  NewAttempt begun;
  std::string scenario_name;
  std::int32_t scenario_version = 0;
  Digest scenario_digest;
  bool is_simulated = false;  ///< of a simulated course: never a person's, never a grade
  std::string login;          ///< of `begun.person`; "" for the robot and for erased people
  std::string started_utc;    ///< ISO 8601
  AttemptState state = AttemptState::Recording;
  std::optional<std::int64_t> duration_ticks;  ///< once closed
  std::string quality_json;                    ///< once closed
  bool is_complete = false;                    ///< once closed: no sample was lost
  std::optional<bool>
      is_valid;  ///< once closed: may be graded, by its certificate; counts for a limit
  std::optional<Digest> seal;               ///< once closed
  std::optional<std::int64_t> score_milli;  ///< of the machine's score in force, 0 to 100 000
  std::int32_t rubric_version = 0;          ///< that score was made with
  PassFacts pass;                           ///< what that score's card says about passing
  bool is_partial = false;                  ///< that score: not all of the rubric was measured
  std::optional<DecisionKind> decision;     ///< in force; nothing: the machine's score is advisory
  std::optional<std::int64_t>
      decided_milli;  ///< the score that stands once confirmed or overridden
  bool decision_is_of_score_in_force = false;  ///< false: the machine scored anew since
  std::optional<DirectoryId> origin;           ///< of an imported one: where it was made
  bool is_counted = true;  ///< false: from an origin that no administrator accepted
};

/// Whether the result counts: an assessment of a person, with every sample, valid by its certificate and not from an origin
/// that nobody accepted, and either confirmed where the whole rubric was measured, or overridden by an instructor.
bool is_grade(const AttemptHeader& header) noexcept;

}  // namespace hallux::database

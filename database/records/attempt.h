/// An attempt's facts as they are kept beside its recording.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "database/records/ids.h"
#include "simulator/base/digest.h"
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
};

struct AttemptHeader {
  AttemptId id;
  NewAttempt begun;
  std::string scenario_name;
  std::int32_t scenario_version = 0;
  Digest scenario_digest;
  std::string login;        ///< of `begun.person`; "" for the robot and for erased people
  std::string started_utc;  ///< ISO 8601
  AttemptState state = AttemptState::Recording;
  std::optional<std::int64_t> duration_ticks;  ///< once closed
  std::string quality_json;                    ///< once closed
  std::optional<Digest> seal;                  ///< once closed
  std::optional<std::int64_t> score_milli;     ///< of the score in force, 0 to 100 000
};

}  // namespace hallux::database

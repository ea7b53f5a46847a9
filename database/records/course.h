/// Cohorts, who is in them and how they stand; scenario versions and the operations that are
/// published.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "database/records/attempt.h"
#include "database/records/ids.h"
#include "database/records/limit.h"
#include "database/records/names.h"
#include "database/records/person.h"
#include "database/records/score.h"

namespace hallux::database {

struct Cohort {
  CohortId id;
  std::string name;
  std::string created_utc;
  std::int32_t trainees = 0, instructors = 0;
};

struct CohortMember {
  PersonId id;
  std::string login, display_name;
  CohortRole role = CohortRole::Trainee;
  bool is_disabled = false;
  /// "" where that was not noted yet.
  std::string enrolled_utc;
};

struct Membership {
  CohortId cohort;
  std::string cohort_name;
  CohortRole role = CohortRole::Trainee;
};

/// A scored assessment that counts, as learning is judged by it.
struct AssessedRun {
  /// Of the calendar, since 1970.
  std::int64_t begun_s = 0;
  std::int32_t rubric_version = 0;
  /// The decided score where there is one.
  std::int64_t standing_milli = 0;
  PassFacts pass;
};

/// By one kind of device: what is done by mouse says little about an arm.
struct DeviceRuns {
  std::string device_class;
  /// Oldest first.
  std::vector<AssessedRun> runs;
};

/// How one person stands in one operation, over all its versions. Attempts that are void, not
/// valid, of a directory that is not accepted, or without a score count as attempts only. Never the
/// robot's.
struct OperationStanding {
  std::string scenario_name;
  std::int32_t attempts = 0;
  /// The decided score where there is one. Last is what was begun last; of two that were begun on
  /// different devices in the same millisecond, by the name of the device class.
  std::optional<std::int64_t> best_milli, last_milli;
  std::string last_started_utc;
  /// Of the attempts those for a grade that count.
  std::int32_t assessments = 0;
  /// Those with scored assessments, by name.
  std::vector<DeviceRuns> by_device = {};
};

struct TraineeStanding {
  PersonId id;
  std::string login, display_name;
  bool is_disabled = false;
  /// By name.
  std::vector<OperationStanding> operations;
  /// Newest first, at most as many as were asked for.
  std::vector<AttemptHeader> last_attempts;
  std::int32_t open_help_requests = 0;
};

enum class ScenarioState { Draft, Published, Retired };

template <>
inline constexpr std::array<std::string_view, 3> stored_names<ScenarioState>{"draft", "published",
                                                                             "retired"};

struct ScenarioVersion {
  ScenarioVersionId id;
  std::string name;
  std::int32_t version = 1;
  /// A surgeon signed it.
  bool is_reviewed = false;
  ScenarioState state = ScenarioState::Draft;
  /// Who put it into that state; "" for erased people.
  std::string changed_by;
  std::string since_utc;
  /// Made with it, the robot's included.
  std::int32_t attempts = 0;
};

/// A published operation as its trainee sees it.
struct Operation {
  ScenarioVersionId scenario;
  std::string name;
  std::int32_t version = 1;
  bool is_reviewed = false;
  std::string published_utc;
  /// The trainee's own.
  OperationStanding standing;
  /// Nothing: as many assessments as they like.
  std::optional<AttemptAllowance> allowance;
};

}  // namespace hallux::database

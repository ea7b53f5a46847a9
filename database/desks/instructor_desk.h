/// The instructor's desk for one cohort: see, replay, note, answer, decide.
/// Inside this corner only.
#pragma once

#include <string>
#include <vector>

#include "database/course/comparisons.h"
#include "database/course/help_requests.h"
#include "database/desks/desks.h"
#include "database/records/limit.h"

namespace hallux::database {

/// Of the attempts those of the cohort's trainees, and the robot's, which belongs to no cohort.
/// errors  DatabaseError: Refused, NotFound; and as in the files that are included
class InstructorDesk : public CourseDesk {
 public:
  Cohort cohort();
  /// By login, each with at most `attempts_max` of their newest attempts.
  std::vector<TraineeStanding> trainees(std::int32_t attempts_max = 0);
  /// One of them.
  TraineeStanding trainee(PersonId id, std::int32_t attempts_max = 0);
  /// The newest of the whole cohort, newest first.
  std::vector<AttemptHeader> newest_attempts(std::int32_t count);
  /// Those of one trainee, newest first.
  std::vector<AttemptHeader> attempts_of(PersonId trainee);

  /// How many assessments of an operation each trainee has; by name of the operation.
  std::vector<AttemptLimit> limits();
  void set_limit(const std::string& scenario_name, std::int32_t attempts_max);
  void clear_limit(const std::string& scenario_name);
  /// As its trainees see it.
  std::vector<CohortComparison> cohort_comparisons(const std::string& scenario_name);

  NoteId add_note(const NewNote& note);
  /// The inbox: open first, oldest first; then the answered, newest first.
  std::vector<HelpRequest> help_requests(bool open_only = false);
  void answer(HelpRequestId request, const std::string& text);
  /// Confirms, overrides or voids; the machine's score is kept.
  DecisionId decide(const NewDecision& decision);

 private:
  void tell_of_decision(const NewDecision& decision);

  friend class Session;
  using CourseDesk::CourseDesk;
};

}  // namespace hallux::database

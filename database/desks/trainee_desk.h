/// The trainee's desk, which everybody has: operate, read standings and notes, ask for help.
#pragma once

#include <vector>

#include "database/course/catalogue.h"
#include "database/course/comparisons.h"
#include "database/course/help_requests.h"
#include "database/desks/desks.h"
#include "database/maintenance/person_export.h"
#include "database/records/hand_settings.h"
#include "simulator/base/progress.h"

namespace hallux::database {

/// Of the attempts the own and the robot's. Nothing here names another trainee.
/// errors  DatabaseError: Refused, NotFound; and as in the files that are included
class TraineeDesk : public CourseDesk {
 public:
  /// What is published, with how this person stands in each and how many assessments are left.
  std::vector<Operation> operations();
  /// errors  DatabaseError: Refused where the attempt is not this person's; BadInput where its
  ///         scenario is not published; Refused where no assessment is left, which is written to
  ///         the audit
  WriterLease begin_attempt(const NewAttempt& attempt);
  /// How the cohorts in which this person is a trainee stand, where there are enough people in
  /// them.
  std::vector<CohortComparison> cohort_comparisons(const std::string& scenario_name);
  /// Flags a moment of an own attempt with a question to the instructors of the person's cohorts.
  HelpRequestId ask_for_help(const NewHelpRequest& request);
  /// The own ones: open first, then the answered, newest first.
  std::vector<HelpRequest> help_requests();
  /// What this person was told and did not acknowledge, newest first.
  std::vector<Notice> notices();
  /// errors  DatabaseError Refused where it was told to somebody else, or there is none
  void acknowledge(NoticeId notice);
  /// How this person holds the saw, wherever they sign in.
  HandSettings hand_settings();
  /// errors  DatabaseError BadInput for a scale or a share that cannot be
  void choose_hand(const HandSettings& settings);
  /// All that is kept of this person (database/maintenance/person_export.h).
  PersonExport export_own(const std::filesystem::path& directory, const Progress& progress = {});

 private:
  friend class Session;
  using CourseDesk::CourseDesk;
};

}  // namespace hallux::database

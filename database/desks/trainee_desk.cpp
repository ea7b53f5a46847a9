#include "database/desks/trainee_desk.h"

#include "database/audit/audit.h"
#include "database/people/hand_settings.h"
#include "database/store/sql.h"
#include "simulator/base/progress.h"

namespace hallux::database {

std::vector<Operation> TraineeDesk::operations() {
  require(*database_, holder_, Action::ListOperations, Relation::Own, "the operations");
  return list_operations(*database_, *holder_.person);
}

WriterLease TraineeDesk::begin_attempt(const NewAttempt& attempt) {
  require(*database_, holder_, Action::BeginAttempt, relation_to(attempt.person), "a new attempt");
  if (!is_published(*database_, attempt.scenario)) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        "this version of the operation is not published; choose one that is"};
  }
  try {
    return begin(attempt);
  } catch (const DatabaseError& error) {
    if (error.kind() == DatabaseErrorKind::Refused)
      append_audit(*database_,
                   {holder_.person, "begin_attempt", "scenario_version",
                    std::to_string(attempt.scenario.number), true, std::nullopt, error.what()});
    throw;
  }
}

std::vector<CohortComparison> TraineeDesk::cohort_comparisons(const std::string& scenario_name) {
  require(*database_, holder_, Action::CompareWithCohort, Relation::Own, "the cohorts");
  std::vector<CohortComparison> comparisons;
  for (const Membership& membership : memberships_of(*database_, *holder_.person)) {
    if (membership.role != CohortRole::Trainee) continue;
    for (CohortComparison& comparison :
         database::cohort_comparisons(*database_, membership.cohort, scenario_name))
      comparisons.push_back(std::move(comparison));
  }
  return comparisons;
}

HelpRequestId TraineeDesk::ask_for_help(const NewHelpRequest& request) {
  NewHelpRequest allowed = request;
  allowed.attempt = allowed_header(Action::AskForHelp, request.attempt).id;
  return in_transaction(*database_, "ask for help", [&] {
    const HelpRequestId id = add_help_request(*database_, allowed, *holder_.person);
    audit("help_asked", "help_request", std::to_string(id.number));
    return id;
  });
}

std::vector<HelpRequest> TraineeDesk::help_requests() {
  require(*database_, holder_, Action::ReadHelp, Relation::Own, "the help requests");
  return list_help_requests(*database_, {holder_.person, std::nullopt, false});
}

std::vector<Notice> TraineeDesk::notices() {
  require(*database_, holder_, Action::ReadNotices, Relation::Own, "the notices");
  return unseen_notices(*database_, *holder_.person);
}

void TraineeDesk::acknowledge(NoticeId notice) {
  const auto audience = audience_of(*database_, notice);
  const bool is_own = audience && audience->person == holder_.person;
  require(*database_, holder_, Action::ReadNotices, is_own ? Relation::Own : Relation::Other,
          "notice " + std::to_string(notice.number));
  acknowledge_notice(*database_, notice, *holder_.person);
}

HandSettings TraineeDesk::hand_settings() {
  require(*database_, holder_, Action::ChooseHand, Relation::Own, "how you hold the saw");
  return load_hand_settings(*database_, *holder_.person);
}

void TraineeDesk::choose_hand(const HandSettings& settings) {
  require(*database_, holder_, Action::ChooseHand, Relation::Own, "how you hold the saw");
  in_transaction(*database_, "keep how somebody holds the saw", [&] {
    store_hand_settings(*database_, *holder_.person, settings);
    audit("hand_chosen", "person", std::to_string(holder_.person->number));
  });
}

PersonExport TraineeDesk::export_own(const std::filesystem::path& directory,
                                     const Progress& progress) {
  require(*database_, holder_, Action::ExportPerson, Relation::Own, "your data");
  PersonExport made = export_person(*database_, *holder_.person, directory, progress);
  audit("person_exported", "person", std::to_string(holder_.person->number));
  return made;
}

}  // namespace hallux::database

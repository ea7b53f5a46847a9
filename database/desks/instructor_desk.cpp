#include "database/desks/instructor_desk.h"

#include "database/course/limits.h"
#include "database/course/standings.h"
#include "database/store/sql.h"

namespace hallux::database {

Cohort InstructorDesk::cohort() {
  require(*database_, holder_, Action::SeeCohort, Relation::Cohort, "the cohort");
  return load_cohort(*database_, *holder_.cohort);
}

std::vector<TraineeStanding> InstructorDesk::trainees(std::int32_t attempts_max) {
  require(*database_, holder_, Action::SeeCohort, Relation::Cohort, "the cohort");
  return list_standings(*database_, *holder_.cohort, attempts_max);
}

TraineeStanding InstructorDesk::trainee(PersonId id, std::int32_t attempts_max) {
  require(*database_, holder_, Action::SeeCohort, relation_to(id),
          "person " + std::to_string(id.number));
  return load_standing(*database_, *holder_.cohort, id, attempts_max);
}

std::vector<AttemptHeader> InstructorDesk::newest_attempts(std::int32_t count) {
  require(*database_, holder_, Action::SeeCohort, Relation::Cohort, "the cohort");
  AttemptFilter filter;
  filter.cohort = holder_.cohort;
  filter.count_max = count;
  return list_attempts(*database_, filter);
}

std::vector<AttemptHeader> InstructorDesk::attempts_of(PersonId trainee) {
  require(*database_, holder_, Action::ListAttempts, relation_to(trainee),
          "the attempts of person " + std::to_string(trainee.number));
  AttemptFilter filter;
  filter.person = trainee;
  return list_attempts(*database_, filter);
}

std::vector<AttemptLimit> InstructorDesk::limits() {
  require(*database_, holder_, Action::SeeCohort, Relation::Cohort, "the cohort");
  return list_limits(*database_, *holder_.cohort);
}

void InstructorDesk::set_limit(const std::string& scenario_name, std::int32_t attempts_max) {
  require(*database_, holder_, Action::LimitAttempts, Relation::Cohort, "the cohort");
  database::set_limit(*database_, *holder_.cohort, {scenario_name, attempts_max, "", ""},
                      *holder_.person);
}

void InstructorDesk::clear_limit(const std::string& scenario_name) {
  require(*database_, holder_, Action::LimitAttempts, Relation::Cohort, "the cohort");
  database::clear_limit(*database_, *holder_.cohort, scenario_name, *holder_.person);
}

std::vector<CohortComparison> InstructorDesk::cohort_comparisons(const std::string& scenario_name) {
  require(*database_, holder_, Action::CompareWithCohort, Relation::Cohort, "the cohort");
  return database::cohort_comparisons(*database_, *holder_.cohort, scenario_name);
}

NoteId InstructorDesk::add_note(const NewNote& note) {
  NewNote allowed = note;
  allowed.attempt = allowed_header(Action::WriteNote, note.attempt).id;
  return in_transaction(*database_, "add a note", [&] {
    const NoteId id = database::add_note(*database_, allowed, *holder_.person);
    audit("note_written", "note", std::to_string(id.number));
    return id;
  });
}

std::vector<HelpRequest> InstructorDesk::help_requests(bool open_only) {
  require(*database_, holder_, Action::ReadHelp, Relation::Cohort, "the help requests");
  return list_help_requests(*database_, {std::nullopt, holder_.cohort, open_only});
}

void InstructorDesk::answer(HelpRequestId request, const std::string& text) {
  const std::optional<HelpRequest> asked = find_help_request(*database_, request);
  const std::string subject = "help request " + std::to_string(request.number);
  if (!asked || !allows(holder_.role, Action::ReadHelp, relation_to(asked->asker))) {
    refuse_unseen(Action::AnswerHelp, subject, asked.has_value());
  }
  require(*database_, holder_, Action::AnswerHelp, relation_to(asked->asker), subject);
  in_transaction(*database_, "answer a help request", [&] {
    answer_help_request(*database_, request, text, *holder_.person);
    audit("help_answered", "help_request", std::to_string(request.number));
  });
}

/// The trainee need not look whether a result still stands.
void InstructorDesk::tell_of_decision(const NewDecision& decision) {
  if (decision.kind == DecisionKind::Confirmed) return;
  const auto trainee = load_header(*database_, decision.attempt).begun.person;
  if (!trainee) return;
  tell_person(*database_, *trainee,
              decision.kind == DecisionKind::Voided ? NoticeKind::ResultVoided
                                                    : NoticeKind::ResultOverridden,
              {std::nullopt, decision.attempt});
}

DecisionId InstructorDesk::decide(const NewDecision& decision) {
  NewDecision allowed = decision;
  allowed.attempt = allowed_header(Action::DecideResult, decision.attempt).id;
  return in_transaction(*database_, "decide about a result", [&] {
    tell_of_decision(allowed);
    return database::decide(*database_, allowed, *holder_.person);
  });
}

}  // namespace hallux::database

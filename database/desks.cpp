#include "database/desks.h"

#include "database/audit.h"
#include "database/recordings.h"
#include "database/sql.h"

namespace hallux::database {

namespace {

constexpr std::array<std::string_view, action_count> action_names{
    "begin_attempt",   "list_attempts",   "view_attempt",       "store_score",
    "list_operations", "read_notes",      "read_private_notes", "write_note",
    "reply_to_note",   "ask_for_help",    "read_help",          "answer_help",
    "decide_result",   "see_cohort",      "change_password",    "set_password",
    "issue_code",      "add_person",      "list_people",        "disable_person",
    "change_role",     "add_cohort",      "list_cohorts",       "enrol",
    "list_scenarios",  "import_scenario", "publish_scenario",   "retire_scenario",
    "read_audit",      "back_up",         "list_origins",       "accept_origin",
    "read_notices",    "change_settings", "erase_person"};

/// A desk taken at sign-in may outlive the right to it.
bool still_holds_role(Database& database, const DeskHolder& holder) {
  if (!holder.person) return holder.role == Role::House;
  const Person person = load_person(database, *holder.person);
  if (person.is_disabled) return false;
  if (holder.role == Role::Administrator) return person.is_administrator;
  if (holder.role != Role::Instructor) return true;
  return holder.cohort &&
         role_in(database, *holder.cohort, *holder.person) == CohortRole::Instructor;
}

}  // namespace

void require(Database& database, const DeskHolder& holder, Action action, Relation relation,
             const std::string& subject) {
  if (allows(holder.role, action, relation) && still_holds_role(database, holder)) return;
  const std::string name{action_names[static_cast<std::size_t>(action)]};
  append_audit(database, {holder.person, name, "desk", "", true, {}, subject});
  throw DatabaseError{DatabaseErrorKind::Refused, "you may not do this (" + name + ") to " +
                                                      subject +
                                                      "; sign in with --as as someone who may"};
}

void require_proof(const DeskHolder& holder, const PasswordProof& proof) {
  if (holder.person == proof.person()) return;
  throw DatabaseError{DatabaseErrorKind::Refused, "somebody else gave their password"};
}

Relation AttemptDesk::relation_to(const std::optional<PersonId>& owner) {
  if (!owner) return Relation::Robot;
  if (holder_.person == owner) return Relation::Own;
  if (holder_.cohort && role_in(*database_, *holder_.cohort, *owner) == CohortRole::Trainee) {
    return Relation::Cohort;
  }
  return Relation::Other;
}

AttemptHeader AttemptDesk::allowed_header(Action action, const AttemptId& id) {
  AttemptHeader header = load_header(*database_, id);
  require(*database_, holder_, action, relation_to(header.begun.person),
          "attempt " + header.id.text);
  return header;
}

void AttemptDesk::audit(const std::string& action, const char* subject_kind,
                        std::string subject_id) {
  append_audit(*database_,
               {holder_.person, action, subject_kind, std::move(subject_id), false, {}, ""});
}

std::vector<AttemptHeader> AttemptDesk::attempts() {
  AttemptFilter filter;
  filter.of_nobody = allows(holder_.role, Action::ListAttempts, Relation::Robot);
  require(*database_, holder_, Action::ListAttempts, Relation::Robot, "the attempts");
  if (allows(holder_.role, Action::ListAttempts, Relation::Own)) filter.person = holder_.person;
  if (allows(holder_.role, Action::ListAttempts, Relation::Cohort)) filter.cohort = holder_.cohort;
  return list_attempts(*database_, filter);
}

AttemptHeader AttemptDesk::header(const AttemptId& id) {
  return allowed_header(Action::ViewAttempt, id);
}

simulator::Recording AttemptDesk::recording(const AttemptId& id) {
  const AttemptHeader header = allowed_header(Action::ViewAttempt, id);
  if (header.begun.person && header.begun.person != holder_.person) {
    audit("attempt_viewed", "attempt", header.id.text);
  }
  return load_recording(*database_, header.id);
}

std::optional<StoredScore> AttemptDesk::score(const AttemptId& id) {
  return load_score(*database_, allowed_header(Action::ViewAttempt, id).id);
}

std::vector<Decision> AttemptDesk::decisions(const AttemptId& id) {
  return load_decisions(*database_, allowed_header(Action::ViewAttempt, id).id);
}

bool AttemptDesk::may(Action action, const AttemptHeader& header) {
  return allows(holder_.role, action, relation_to(header.begun.person)) &&
         still_holds_role(*database_, holder_);
}

ScoreId AttemptDesk::store_score(const AttemptId& id, const ScoreCard& card) {
  return database::store_score(*database_, allowed_header(Action::StoreScore, id).id, card,
                               holder_.person);
}

WriterLease AttemptDesk::begin(const NewAttempt& attempt) {
  require(*database_, holder_, Action::BeginAttempt, relation_to(attempt.person), "a new attempt");
  return create_attempt(*database_, attempt);
}

std::vector<Note> CourseDesk::notes(const AttemptId& id) {
  const AttemptHeader header = allowed_header(Action::ReadNotes, id);
  return list_notes(
      *database_, header.id,
      allows(holder_.role, Action::ReadPrivateNotes, relation_to(header.begun.person)));
}

void CourseDesk::reply(NoteId note, const std::string& text) {
  const Note replied = load_note(*database_, note);
  const AttemptHeader header = allowed_header(Action::ReplyToNote, replied.attempt);
  if (replied.is_private &&
      !allows(holder_.role, Action::ReadPrivateNotes, relation_to(header.begun.person))) {
    throw DatabaseError{
        DatabaseErrorKind::NotFound,
        "there is no note " + std::to_string(note.number) + " in " + database_->file().string()};
  }
  in_transaction(*database_, "reply to a note", [&] {
    add_reply(*database_, note, text, *holder_.person);
    audit("note_replied", "note", std::to_string(note.number));
  });
}

}  // namespace hallux::database

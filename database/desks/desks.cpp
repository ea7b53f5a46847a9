/// A desk may outlive the right to it, so every question looks at the tables again. An attempt that
/// somebody may not view and one that is not there are refused alike; only the audit says which it
/// was, in a subject cut to 80 characters: what somebody typed is no place to fill it from.
#include "database/desks/desks.h"

#include "database/audit/audit.h"
#include "database/course/begin_attempt.h"
#include "database/course/measurements.h"
#include "database/exchange/export_attempt.h"
#include "database/recording/display_facts.h"
#include "database/recording/recordings.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr std::array<std::string_view, action_count> action_names{"begin_attempt",
                                                                  "list_attempts",
                                                                  "view_attempt",
                                                                  "store_score",
                                                                  "list_operations",
                                                                  "read_notes",
                                                                  "read_private_notes",
                                                                  "write_note",
                                                                  "reply_to_note",
                                                                  "ask_for_help",
                                                                  "read_help",
                                                                  "answer_help",
                                                                  "decide_result",
                                                                  "see_cohort",
                                                                  "change_password",
                                                                  "set_password",
                                                                  "issue_code",
                                                                  "add_person",
                                                                  "list_people",
                                                                  "disable_person",
                                                                  "correct_name",
                                                                  "change_role",
                                                                  "add_cohort",
                                                                  "list_cohorts",
                                                                  "enrol",
                                                                  "list_scenarios",
                                                                  "import_scenario",
                                                                  "publish_scenario",
                                                                  "retire_scenario",
                                                                  "read_audit",
                                                                  "back_up",
                                                                  "list_origins",
                                                                  "accept_origin",
                                                                  "read_notices",
                                                                  "change_settings",
                                                                  "erase_person",
                                                                  "export_person",
                                                                  "retain",
                                                                  "limit_attempts",
                                                                  "compare_with_cohort",
                                                                  "run_report",
                                                                  "export_attempt",
                                                                  "import_attempt",
                                                                  "choose_hand"};

std::string_view name_of(Action action) noexcept {
  return action_names[static_cast<std::size_t>(action)];
}

/// A replay reads its attempt piece by piece: one line for all that is read within a minute.
bool was_viewed_lately(Database& database, PersonId viewer, const AttemptId& attempt) {
  return translating(database, "look into the audit", [&] {
    return single<bool>(
        database,
        "SELECT EXISTS (SELECT 1 FROM audit WHERE audit_id > (SELECT max(audit_id) FROM audit) - "
        "100 "
        "AND actor_person_id = ?1 AND action = 'attempt_viewed' AND subject_id = ?2 "
        "AND at_utc BETWEEN strftime('%Y-%m-%dT%H:%M:%fZ', ?3, '-1 minute') AND ?3)",
        viewer.number, attempt.text, utc_now(database));
  });
}

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
  const std::string name{name_of(action)};
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

std::optional<AttemptHeader> AttemptDesk::seen_header(const AttemptId& id, Action action) {
  std::vector<AttemptHeader> found = headers_that_begin_with(*database_, id);
  std::erase_if(found, [&](const AttemptHeader& header) {
    return !may(Action::ViewAttempt, header) && !may(action, header);
  });
  if (found.empty()) return std::nullopt;
  return the_one_of(*database_, std::move(found), id);
}

AttemptHeader AttemptDesk::allowed_header(Action action, const AttemptId& id) {
  std::optional<AttemptHeader> header = seen_header(id, action);
  // Where nobody signs in there is nobody's to be kept from: the usual words about a mistyped name.
  if (!header && !holder_.person && !has_people(*database_)) return load_header(*database_, id);
  if (!header) {
    refuse_unseen(action, "attempt '" + id.text + "'",
                  !headers_that_begin_with(*database_, id).empty());
  }
  require(*database_, holder_, action, relation_to(header->begun.person),
          "attempt " + header->id.text);
  return *std::move(header);
}

void AttemptDesk::refuse_unseen(Action action, const std::string& subject, bool is_there) {
  // What somebody typed is no place to fill the audit from.
  const std::string named = subject.substr(0, 80);
  const std::string name{name_of(action)};
  const std::string seen = named + (is_there ? "" : ", which is not there");
  append_audit(*database_, {holder_.person, name, "desk", "", true, {}, seen});
  throw DatabaseError{DatabaseErrorKind::NotFound,
                      "there is no " + named +
                          " that you may see; `hallux attempts` lists those "
                          "you may, and --as says who you are"};
}

void AttemptDesk::note_view(const AttemptHeader& header) {
  if (!header.begun.person || header.begun.person == holder_.person) return;
  if (was_viewed_lately(*database_, *holder_.person, header.id)) return;
  audit("attempt_viewed", "attempt", header.id.text);
}

void AttemptDesk::audit(const std::string& action, const char* subject_kind,
                        std::string subject_id) {
  append_audit(*database_, {holder_.person, action, subject_kind, std::move(subject_id)});
}

std::vector<AttemptHeader> AttemptDesk::attempts(std::optional<std::int32_t> count_max) {
  AttemptFilter filter;
  filter.count_max = count_max;
  filter.of_nobody = allows(holder_.role, Action::ListAttempts, Relation::Robot);
  require(*database_, holder_, Action::ListAttempts, Relation::Robot, "the attempts");
  if (allows(holder_.role, Action::ListAttempts, Relation::Own)) filter.person = holder_.person;
  if (allows(holder_.role, Action::ListAttempts, Relation::Cohort)) filter.cohort = holder_.cohort;
  return list_attempts(*database_, filter);
}

AttemptHeader AttemptDesk::header(const AttemptId& id) {
  return allowed_header(Action::ViewAttempt, id);
}

simulator::Recording AttemptDesk::recording(const AttemptId& id, RecordingPart part) {
  const AttemptHeader header = allowed_header(Action::ViewAttempt, id);
  note_view(header);
  return load_recording(*database_, header.id, part);
}

PackedRecording AttemptDesk::packed_recording(const AttemptId& id) {
  const AttemptHeader header = allowed_header(Action::ViewAttempt, id);
  note_view(header);
  return load_packed_recording(*database_, header.id);
}

std::vector<simulator::DisplayFact> AttemptDesk::display_facts(const AttemptId& id) {
  const AttemptHeader header = allowed_header(Action::ViewAttempt, id);
  note_view(header);
  return load_display_facts(*database_, header.id);
}

std::optional<StoredScore> AttemptDesk::score(const AttemptId& id) {
  const AttemptHeader header = allowed_header(Action::ViewAttempt, id);
  note_view(header);
  return load_score(*database_, header.id);
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

void AttemptDesk::store_scores(std::span<const NewScore> scores) {
  std::vector<AttemptId> allowed;
  for (const NewScore& score : scores)
    allowed.push_back(allowed_header(Action::StoreScore, score.attempt).id);
  in_transaction(*database_, "store the scores of " + std::to_string(scores.size()) + " attempts",
                 [&] {
                   for (std::size_t i = 0; i < scores.size(); ++i)
                     database::store_score(*database_, allowed[i], scores[i].card, holder_.person);
                 });
}

std::optional<std::vector<Measurement>> AttemptDesk::measurements(const AttemptId& id,
                                                                  const MeasuredBy& by) {
  const AttemptHeader header = allowed_header(Action::ViewAttempt, id);
  note_view(header);
  return load_measurements(*database_, header.id, by);
}

void AttemptDesk::store_measurements(const AttemptId& id, const MeasuredBy& by,
                                     std::span<const Measurement> measurements) {
  database::store_measurements(*database_, allowed_header(Action::StoreScore, id).id, by,
                               measurements, holder_.person);
}

void AttemptDesk::export_attempt(const AttemptId& id, const std::filesystem::path& folder,
                                 const MakeDerived& make_derived) {
  const AttemptHeader header = allowed_header(Action::ExportAttempt, id);
  // Noted before it leaves: what was begun and not ended may have been read as well.
  if (holder_.person) audit("attempt_exported", "attempt", header.id.text);
  database::export_attempt(*database_, header.id, folder, make_derived);
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

std::vector<HelpRequest> CourseDesk::help_requests_about(const AttemptId& id) {
  HelpFilter filter;
  filter.attempt = allowed_header(Action::ReadHelp, id).id;
  return list_help_requests(*database_, filter);
}

void CourseDesk::check_may_reply(NoteId note) {
  const std::optional<Note> replied = find_note(*database_, note);
  const std::optional<AttemptHeader> header =
      replied ? seen_header(replied->attempt, Action::ViewAttempt) : std::nullopt;
  const bool may_read =
      header && may(replied->is_private ? Action::ReadPrivateNotes : Action::ReadNotes, *header);
  const std::string subject = "note " + std::to_string(note.number);
  if (!may_read) refuse_unseen(Action::ReplyToNote, subject, replied.has_value());
  require(*database_, holder_, Action::ReplyToNote, relation_to(header->begun.person), subject);
}

void CourseDesk::reply(NoteId note, const std::string& text) {
  check_may_reply(note);
  in_transaction(*database_, "reply to a note", [&] {
    add_reply(*database_, note, text, *holder_.person);
    audit("note_replied", "note", std::to_string(note.number));
  });
}

}  // namespace hallux::database

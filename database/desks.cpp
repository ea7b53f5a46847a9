#include "database/desks.h"

#include "database/audit.h"
#include "database/recordings.h"
#include "database/sql.h"

namespace hallux::database {

namespace {

constexpr std::array<std::string_view, action_count> action_names{
    "begin_attempt",   "list_attempts", "view_attempt", "store_score",
    "change_password", "set_password",  "add_person",   "list_people",
    "disable_person",  "add_cohort",    "enrol"};

Relation relation_to_attempt(Database& database, const DeskHolder& holder,
                             const std::optional<PersonId>& owner) {
  if (!owner) return Relation::Robot;
  if (holder.person == owner) return Relation::Own;
  if (holder.cohort && role_in(database, *holder.cohort, *owner) == CohortRole::Trainee) {
    return Relation::Cohort;
  }
  return Relation::Other;
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

/// The header, once the table allowed `action` on it.
AttemptHeader allowed_header(Database& database, const DeskHolder& holder, Action action,
                             const AttemptId& id) {
  AttemptHeader header = load_header(database, id);
  const Relation relation = relation_to_attempt(database, holder, header.begun.person);
  require(database, holder, action, relation, "attempt " + header.id.text);
  return header;
}

void audit_person(Database& database, const DeskHolder& holder, const char* action, PersonId id) {
  append_audit(database,
               {holder.person, action, "person", std::to_string(id.number), false, {}, ""});
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

std::vector<AttemptHeader> AttemptDesk::attempts() {
  AttemptFilter filter;
  filter.of_nobody = allows(holder_.role, Action::ListAttempts, Relation::Robot);
  require(*database_, holder_, Action::ListAttempts, Relation::Robot, "the attempts");
  if (allows(holder_.role, Action::ListAttempts, Relation::Own)) filter.person = holder_.person;
  if (allows(holder_.role, Action::ListAttempts, Relation::Cohort)) filter.cohort = holder_.cohort;
  return list_attempts(*database_, filter);
}

AttemptHeader AttemptDesk::header(const AttemptId& id) {
  return allowed_header(*database_, holder_, Action::ViewAttempt, id);
}

simulator::Recording AttemptDesk::recording(const AttemptId& id) {
  const AttemptHeader header = allowed_header(*database_, holder_, Action::ViewAttempt, id);
  if (header.begun.person && header.begun.person != holder_.person) {
    append_audit(*database_,
                 {holder_.person, "attempt_viewed", "attempt", header.id.text, false, {}, ""});
  }
  return load_recording(*database_, header.id);
}

std::optional<StoredScore> AttemptDesk::score(const AttemptId& id) {
  return load_score(*database_, allowed_header(*database_, holder_, Action::ViewAttempt, id).id);
}

bool AttemptDesk::may(Action action, const AttemptHeader& header) {
  const Relation relation = relation_to_attempt(*database_, holder_, header.begun.person);
  return allows(holder_.role, action, relation) && still_holds_role(*database_, holder_);
}

ScoreId AttemptDesk::store_score(const AttemptId& id, const ScoreCard& card) {
  return database::store_score(*database_,
                               allowed_header(*database_, holder_, Action::StoreScore, id).id, card,
                               holder_.person);
}

WriterLease AttemptDesk::begin(const NewAttempt& attempt) {
  require(*database_, holder_, Action::BeginAttempt,
          relation_to_attempt(*database_, holder_, attempt.person), "a new attempt");
  return create_attempt(*database_, attempt);
}

Relation AdministratorDesk::relation_to(const Person& person) const noexcept {
  return holder_.person == person.id ? Relation::Own : Relation::Other;
}

PersonId AdministratorDesk::add_person(const NewPerson& person, const SecretText& password,
                                       const PasswordCost& cost) {
  require(*database_, holder_, Action::AddPerson, Relation::Other, "a new person");
  return in_transaction(*database_, "add a person", [&] {
    const PersonId id = create_person(*database_, person, password, cost);
    audit_person(*database_, holder_, "person_added", id);
    return id;
  });
}

std::vector<Person> AdministratorDesk::people() {
  require(*database_, holder_, Action::ListPeople, Relation::Other, "the people");
  return list_people(*database_);
}

void AdministratorDesk::set_password(const std::string& login, const SecretText& password,
                                     const PasswordCost& cost) {
  const Person person = find_person(*database_, login);
  require(*database_, holder_, Action::SetPassword, relation_to(person),
          "the password of " + login);
  in_transaction(*database_, "set a password", [&] {
    database::set_password(*database_, person.id, password, cost);
    audit_person(*database_, holder_, "password_set", person.id);
  });
}

void AdministratorDesk::set_disabled(const std::string& login, bool is_disabled) {
  const Person person = find_person(*database_, login);
  require(*database_, holder_, Action::DisablePerson, relation_to(person), login);
  in_transaction(*database_, "disable or enable a person", [&] {
    database::set_disabled(*database_, person.id, is_disabled);
    audit_person(*database_, holder_, is_disabled ? "person_disabled" : "person_enabled",
                 person.id);
  });
}

CohortId AdministratorDesk::add_cohort(const std::string& name) {
  require(*database_, holder_, Action::AddCohort, Relation::Other, "a new cohort");
  return in_transaction(*database_, "add a cohort", [&] {
    const CohortId id = create_cohort(*database_, name);
    append_audit(
        *database_,
        {holder_.person, "cohort_added", "cohort", std::to_string(id.number), false, {}, ""});
    return id;
  });
}

void AdministratorDesk::enrol(CohortId cohort, const std::string& login, CohortRole role) {
  const Person person = find_person(*database_, login);
  require(*database_, holder_, Action::Enrol, relation_to(person), login);
  in_transaction(*database_, "enrol a person", [&] {
    database::enrol(*database_, cohort, person.id, role);
    append_audit(*database_,
                 {holder_.person,
                  role == CohortRole::Trainee ? "enrolled_as_trainee" : "enrolled_as_instructor",
                  "membership",
                  std::to_string(cohort.number) + "/" + std::to_string(person.id.number),
                  false,
                  {},
                  ""});
  });
}

}  // namespace hallux::database

/// A refused sign-in writes and costs the same whether the login is known or not, and a try is
/// counted before its password is looked at: neither time nor rows tell who is here, and two
/// windows cannot guess side by side. A session itself holds no rights: each desk is given out by
/// what the tables say at that moment, because a role may end while the window is open.
#include "database/desks/session.h"

#include <algorithm>
#include <tuple>

#include "database/audit/audit.h"
#include "database/reports/report_process.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

std::string number_text(PersonId id) { return std::to_string(id.number); }

std::int64_t open_session(Database& database, PersonId person, std::string_view login) {
  return in_transaction(database, "sign in", [&] {
    forget_tries(database, login);
    execute(database, "INSERT INTO session (person_id, started_utc) VALUES (?, ?)", person.number,
            utc_now(database));
    const std::int64_t number = database.connection().getLastInsertRowid();
    append_audit(database, {person, "signed_in", "session", std::to_string(number)});
    return number;
  });
}

/// Written alike for somebody who is known and for somebody who is not, so that the time tells
/// nothing.
void note_refusal(Database& database, const std::string& action, std::string_view login) {
  in_transaction(database, "note a refusal", [&] {
    const std::optional<Person> known = known_person(database, login);
    if (known) tell_of_refused_sign_in(database, known->id);
    append_audit(database, {std::nullopt, action, known ? "person" : "login",
                            known ? number_text(known->id) : std::string{}, true});
  });
}

}  // namespace

Session sign_in(Database& database, std::string_view login, const SecretText& password,
                const PasswordCost& cost) {
  count_try(database, login);
  std::optional<Person> person = verify_person(database, login, password, cost);
  if (!person) {
    note_refusal(database, "signed_in", login);
    throw DatabaseError{DatabaseErrorKind::Refused,
                        "could not sign in as '" + std::string{login} +
                            "': the login or the password is wrong, or the person is disabled"};
  }
  const std::int64_t number = open_session(database, person->id, login);
  return {database, std::move(*person), number};
}

Session redeem_code(Database& database, std::string_view login, const SecretText& code,
                    const SecretText& new_password, const PasswordCost& cost) {
  count_try(database, login);
  const std::optional<Person> person = verify_code(database, login, code, cost);
  if (!person) {
    note_refusal(database, "code_redeemed", login);
    throw DatabaseError{DatabaseErrorKind::Refused,
                        "could not sign in as '" + std::string{login} +
                            "': the login or the code is wrong, the code has expired or was used, "
                            "or the person is disabled; an administrator can issue another code"};
  }
  forget_tries(database, login);
  in_transaction(database, "redeem a one-time code", [&] {
    set_password(database, person->id, new_password, cost);
    remove_code(database, person->id);
    append_audit(database, {person->id, "code_redeemed", "person", number_text(person->id)});
  });
  const std::int64_t number = open_session(database, person->id, login);
  return {database, load_person(database, person->id), number};
}

std::optional<TraineeDesk> Session::trainee() {
  if (load_person(*database_, person_.id).is_disabled) return std::nullopt;
  return TraineeDesk{*database_, DeskHolder{Role::Trainee, person_.id, std::nullopt}};
}

std::optional<InstructorDesk> Session::instructor_of(CohortId cohort) {
  if (load_person(*database_, person_.id).is_disabled) return std::nullopt;
  if (role_in(*database_, cohort, person_.id) != CohortRole::Instructor) return std::nullopt;
  return InstructorDesk{*database_, DeskHolder{Role::Instructor, person_.id, cohort}};
}

std::optional<AdministratorDesk> Session::administrator() {
  const Person person = load_person(*database_, person_.id);
  if (person.is_disabled || !person.is_administrator) return std::nullopt;
  return AdministratorDesk{*database_, DeskHolder{Role::Administrator, person_.id, std::nullopt}};
}

std::vector<Membership> Session::memberships() { return memberships_of(*database_, person_.id); }

std::vector<AttemptDesk> Session::desks() {
  std::vector<AttemptDesk> held;
  if (const auto own = trainee()) held.push_back(*own);
  for (const Membership& membership : memberships()) {
    if (const auto taught = instructor_of(membership.cohort)) held.push_back(*taught);
  }
  if (const auto administered = administrator()) held.push_back(*administered);
  return held;
}

std::vector<AttemptHeader> Session::attempts(std::optional<std::int32_t> count_max) {
  std::vector<AttemptHeader> listed;
  for (AttemptDesk& desk : desks()) {
    for (AttemptHeader& header : desk.attempts(count_max)) listed.push_back(std::move(header));
  }
  const auto key = [](const AttemptHeader& header) {
    return std::tie(header.started_utc, header.order);
  };
  std::sort(listed.begin(), listed.end(),
            [&](const AttemptHeader& a, const AttemptHeader& b) { return key(a) > key(b); });
  listed.erase(
      std::unique(listed.begin(), listed.end(),
                  [](const AttemptHeader& a, const AttemptHeader& b) { return a.id == b.id; }),
      listed.end());
  if (count_max && std::ssize(listed) > *count_max)
    listed.resize(static_cast<std::size_t>(std::max(0, *count_max)));
  return listed;
}

std::optional<AttemptDesk> Session::desk_for(Action action, const AttemptId& id) {
  std::vector<AttemptDesk> held = desks();
  for (AttemptDesk& desk : held) {
    const std::optional<AttemptHeader> header = desk.seen_header(id, action);
    if (header && desk.may(action, *header)) return desk;
  }
  if (held.empty()) return std::nullopt;
  return held.front();
}

/// Guarded like a sign-in: a window left open is no place to guess at.
bool Session::is_own_password(const SecretText& password, const std::string& action,
                              const PasswordCost& cost) {
  count_try(*database_, person_.login);
  if (!verify_person(*database_, person_.login, password, cost)) {
    append_audit(*database_, {person_.id, action, "person", number_text(person_.id), true});
    return false;
  }
  forget_tries(*database_, person_.login);
  return true;
}

PasswordProof Session::prove(const SecretText& password, const PasswordCost& cost) {
  if (is_own_password(password, "password_asked", cost)) return PasswordProof{person_.id};
  throw DatabaseError{DatabaseErrorKind::Refused, "the password is wrong"};
}

std::vector<Notice> Session::notices() {
  std::vector<Notice> told;
  if (auto desk = trainee()) told = desk->notices();
  if (auto desk = administrator()) {
    for (Notice& notice : desk->notices()) told.push_back(std::move(notice));
  }
  std::sort(told.begin(), told.end(), [](const Notice& a, const Notice& b) { return b.id < a.id; });
  return told;
}

void Session::acknowledge(const Notice& notice) {
  if (auto desk = administrator(); desk && notice.is_for_administrators) {
    desk->acknowledge(notice.id);
  } else if (auto own = trainee()) {
    own->acknowledge(notice.id);
  }
}

void Session::change_password(const SecretText& old_password, const SecretText& new_password,
                              const PasswordCost& cost) {
  const DeskHolder holder{Role::Trainee, person_.id, std::nullopt};
  require(*database_, holder, Action::ChangePassword, Relation::Own, "your password");
  if (!is_own_password(old_password, "password_changed", cost)) {
    throw DatabaseError{DatabaseErrorKind::Refused,
                        "could not change the password: the old password is wrong"};
  }
  in_transaction(*database_, "change a password", [&] {
    set_password(*database_, person_.id, new_password, cost);
    append_audit(*database_, {person_.id, "password_changed", "person", number_text(person_.id)});
  });
}

void Session::sign_out() {
  in_transaction(*database_, "sign out", [&] {
    if (execute(*database_,
                "UPDATE session SET ended_utc = ? WHERE session_id = ? AND ended_utc IS NULL",
                utc_now(*database_), number_) == 0)
      return;
    append_audit(*database_, {person_.id, "signed_out", "session", std::to_string(number_)});
  });
}

std::optional<OpenHouse> OpenHouse::enter(Database& database) {
  if (has_people(database)) return std::nullopt;
  return OpenHouse{database};
}

Database& OpenHouse::open(const char* else_who) const {
  if (!has_people(*database_)) return *database_;
  throw DatabaseError{
      DatabaseErrorKind::Refused,
      "somebody was added to " + database_->file().string() + " in the meantime; " + else_who};
}

Report OpenHouse::report(const std::string& sql, ReportProcess& process) {
  const Database& database = open("an administrator may run reports, with --as");
  return process.answer(database.directory(), sql);
}

Backup OpenHouse::back_up(const std::filesystem::path& directory, const Progress& progress) {
  return back_up_with_rotation(open(), directory, std::nullopt, {progress, {}});
}

std::vector<Backup> OpenHouse::backups() { return list_backups(open().directory() / "backups"); }

RetentionRules OpenHouse::retention() { return load_retention(open()); }

void OpenHouse::set_retention(const RetentionRules& rules) { store_retention(open(), rules); }

std::vector<RetentionPiece> OpenHouse::retention_plan() { return plan_retention(open()); }

RetentionDone OpenHouse::retain(const Progress& progress) {
  return apply_retention(open(), std::nullopt, progress);
}

PersonId OpenHouse::add_first_administrator(const NewPerson& person, const SecretText& password,
                                            const PasswordCost& cost) {
  if (!person.is_administrator) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        "the first person must be an administrator; add '" + person.login +
                            "' as one, or add an administrator before"};
  }
  return in_transaction(*database_, "add the first administrator", [&] {
    Database& database = open("an administrator must add further people");
    const PersonId id = create_person(database, person, password, cost);
    append_audit(*database_,
                 {std::nullopt, "first_administrator_added", "person", number_text(id)});
    return id;
  });
}

}  // namespace hallux::database

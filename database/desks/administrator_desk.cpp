/// Each method asks the policy table, acts, and writes its line of the audit in the transaction of
/// the act: neither is there without the other. Where an act is about a person, the login is looked
/// up first: an administrator may see who is there, so a wrong login is said to be one.
#include "database/desks/administrator_desk.h"

#include "database/audit/audit.h"
#include "database/audit/audit_page.h"
#include "database/course/limits.h"
#include "database/exchange/import_attempt.h"
#include "database/exchange/origins.h"
#include "database/reports/report_process.h"
#include "database/store/settings.h"
#include "database/store/sql.h"
#include "simulator/base/progress.h"

namespace hallux::database {

namespace {

std::string membership_text(CohortId cohort, PersonId person) {
  return std::to_string(cohort.number) + "/" + std::to_string(person.number);
}

}  // namespace

Person AdministratorDesk::allowed_person(Action action, const std::string& login,
                                         const char* subject) {
  Person person = find_person(*database_, login);
  require(*database_, holder_, action,
          holder_.person == person.id ? Relation::Own : Relation::Other, subject + login);
  return person;
}

std::vector<Person> AdministratorDesk::people() {
  require(*database_, holder_, Action::ListPeople, Relation::Other, "the people");
  return list_people(*database_);
}

AddedPerson AdministratorDesk::add_person_with_code(const NewPerson& person,
                                                    const PasswordCost& cost) {
  require(*database_, holder_, Action::AddPerson, Relation::Other, "a new person");
  return in_transaction(*database_, "add a person", [&] {
    const PersonId id = create_person_without_password(*database_, person);
    audit("person_added", "person", std::to_string(id.number));
    if (person.is_administrator) audit("administrator_made", "person", std::to_string(id.number));
    IssuedCode issued = issue_code(*database_, id, *holder_.person, cost);
    audit("code_issued", "person", std::to_string(id.number));
    return AddedPerson{id, std::move(issued)};
  });
}

PersonId AdministratorDesk::add_person(const NewPerson& person, const SecretText& password,
                                       const PasswordCost& cost) {
  require(*database_, holder_, Action::AddPerson, Relation::Other, "a new person");
  return in_transaction(*database_, "add a person", [&] {
    const PersonId id = create_person(*database_, person, password, cost);
    audit("person_added", "person", std::to_string(id.number));
    if (person.is_administrator) audit("administrator_made", "person", std::to_string(id.number));
    return id;
  });
}

IssuedCode AdministratorDesk::reset(const std::string& login, const PasswordCost& cost) {
  const Person person = allowed_person(Action::IssueCode, login, "the password of ");
  return in_transaction(*database_, "reset a password", [&] {
    remove_password(*database_, person.id);
    IssuedCode issued = issue_code(*database_, person.id, *holder_.person, cost);
    tell_person(*database_, person.id, NoticeKind::CodeIssued, {holder_.person, {}});
    audit("password_reset", "person", std::to_string(person.id.number));
    return issued;
  });
}

void AdministratorDesk::set_password(const std::string& login, const SecretText& password,
                                     const PasswordCost& cost) {
  const Person person = allowed_person(Action::SetPassword, login, "the password of ");
  in_transaction(*database_, "set a password", [&] {
    database::set_password(*database_, person.id, password, cost);
    remove_code(*database_, person.id);
    if (holder_.person != person.id) {
      tell_person(*database_, person.id, NoticeKind::PasswordSet, {holder_.person, {}});
    }
    audit("password_set", "person", std::to_string(person.id.number));
  });
}

void AdministratorDesk::set_disabled(const std::string& login, bool is_disabled) {
  const Person person = allowed_person(Action::DisablePerson, login);
  in_transaction(*database_, "disable or enable a person", [&] {
    database::set_disabled(*database_, person.id, is_disabled);
    audit(is_disabled ? "person_disabled" : "person_enabled", "person",
          std::to_string(person.id.number));
  });
}

void AdministratorDesk::correct_name(const std::string& login, const std::string& name) {
  const Person person = allowed_person(Action::CorrectName, login, "the name of ");
  in_transaction(*database_, "correct a name", [&] {
    const std::string before = set_display_name(*database_, person.id, name);
    if (holder_.person != person.id) {
      tell_person(*database_, person.id, NoticeKind::NameCorrected, {holder_.person, {}});
    }
    append_audit(*database_, {holder_.person,
                              "name_corrected",
                              "person",
                              std::to_string(person.id.number),
                              false,
                              {},
                              before});
  });
}

void AdministratorDesk::set_administrator(const std::string& login, bool is_administrator) {
  const Person person = allowed_person(Action::ChangeRole, login);
  in_transaction(*database_, "change a role", [&] {
    database::set_administrator(*database_, person.id, is_administrator);
    if (is_administrator && !person.is_administrator) {
      tell_administrators(*database_, NoticeKind::AdministratorMade, {person.id, {}});
    }
    audit(is_administrator ? "administrator_made" : "administrator_unmade", "person",
          std::to_string(person.id.number));
  });
}

ErasedPieces AdministratorDesk::erase_person(const EraseRequest& request,
                                             const PasswordProof& proof, const Progress& progress) {
  const Person person = allowed_person(Action::ErasePerson, request.login, "the person ");
  require_proof(holder_, proof);
  return database::erase_person(*database_, {person.id, request.with_recordings, request.reason},
                                holder_.person, progress);
}

PersonExport AdministratorDesk::export_person(const std::string& login,
                                              const std::filesystem::path& directory,
                                              const Progress& progress) {
  const Person person = allowed_person(Action::ExportPerson, login, "the data of ");
  PersonExport made = database::export_person(*database_, person.id, directory, progress);
  audit("person_exported", "person", std::to_string(person.id.number));
  return made;
}

std::vector<Cohort> AdministratorDesk::cohorts() {
  require(*database_, holder_, Action::ListCohorts, Relation::Other, "the cohorts");
  return list_cohorts(*database_);
}

std::vector<CohortMember> AdministratorDesk::members(CohortId cohort) {
  require(*database_, holder_, Action::ListCohorts, Relation::Other, "the cohorts");
  return list_members(*database_, load_cohort(*database_, cohort).id);
}

CohortId AdministratorDesk::add_cohort(const std::string& name) {
  require(*database_, holder_, Action::AddCohort, Relation::Other, "a new cohort");
  return in_transaction(*database_, "add a cohort", [&] {
    const CohortId id = create_cohort(*database_, name);
    audit("cohort_added", "cohort", std::to_string(id.number));
    return id;
  });
}

void AdministratorDesk::enrol(CohortId cohort, const std::string& login, CohortRole role) {
  const Person person = allowed_person(Action::Enrol, login);
  in_transaction(*database_, "enrol a person", [&] {
    database::enrol(*database_, cohort, person.id, role);
    audit(role == CohortRole::Trainee ? "enrolled_as_trainee" : "enrolled_as_instructor",
          "membership", membership_text(cohort, person.id));
  });
}

void AdministratorDesk::remove_from_cohort(CohortId cohort, const std::string& login) {
  const Person person = allowed_person(Action::Enrol, login);
  in_transaction(*database_, "take a person out of a cohort", [&] {
    database::remove_from_cohort(*database_, cohort, person.id);
    audit("removed_from_cohort", "membership", membership_text(cohort, person.id));
  });
}

std::vector<AttemptLimit> AdministratorDesk::limits(CohortId cohort) {
  require(*database_, holder_, Action::ListCohorts, Relation::Other, "the cohorts");
  return list_limits(*database_, load_cohort(*database_, cohort).id);
}

void AdministratorDesk::set_limit(CohortId cohort, const std::string& scenario_name,
                                  std::int32_t attempts_max) {
  require(*database_, holder_, Action::LimitAttempts, Relation::Other, "a cohort");
  database::set_limit(*database_, cohort, {scenario_name, attempts_max, "", ""}, *holder_.person);
}

void AdministratorDesk::clear_limit(CohortId cohort, const std::string& scenario_name) {
  require(*database_, holder_, Action::LimitAttempts, Relation::Other, "a cohort");
  database::clear_limit(*database_, cohort, scenario_name, *holder_.person);
}

std::vector<ScenarioVersion> AdministratorDesk::scenarios() {
  require(*database_, holder_, Action::ListScenarios, Relation::Other, "the scenario versions");
  return list_scenario_versions(*database_);
}

ScenarioText AdministratorDesk::scenario_text(ScenarioVersionId id) {
  require(*database_, holder_, Action::ListScenarios, Relation::Other, "the scenario versions");
  return get_scenario_version(*database_, id);
}

ScenarioVersionId AdministratorDesk::import_scenario(const ScenarioText& text) {
  require(*database_, holder_, Action::ImportScenario, Relation::Other, "a scenario");
  return database::import_scenario(*database_, text, *holder_.person);
}

void AdministratorDesk::publish_scenario(ScenarioVersionId id) {
  require(*database_, holder_, Action::PublishScenario, Relation::Other, "a scenario");
  database::publish_scenario(*database_, id, *holder_.person);
}

void AdministratorDesk::retire_scenario(ScenarioVersionId id) {
  require(*database_, holder_, Action::RetireScenario, Relation::Other, "a scenario");
  database::retire_scenario(*database_, id, *holder_.person);
}

AuditPage AdministratorDesk::audit_page(const AuditRequest& request) {
  require(*database_, holder_, Action::ReadAudit, Relation::Other, "the audit");
  return read_audit_page(*database_, request);
}

Backup AdministratorDesk::back_up(const std::filesystem::path& directory,
                                  const Progress& progress) {
  require(*database_, holder_, Action::BackUp, Relation::Other, "the database");
  return back_up_with_rotation(*database_, directory, holder_.person, {progress, {}});
}

Report AdministratorDesk::report(const std::string& sql, ReportProcess& process) {
  require(*database_, holder_, Action::RunReport, Relation::Other, "the tables");
  append_audit(*database_, {holder_.person, "report_run", "database", "", false, {}, sql});
  return process.answer(database_->directory(), sql);
}

bool AdministratorDesk::is_here(const ImportedAttempt& attempt) {
  require(*database_, holder_, Action::ImportAttempt, Relation::Other, "an attempt");
  return database::is_here(*database_, attempt);
}

bool AdministratorDesk::import_attempt(const ImportedAttempt& attempt,
                                       const std::optional<ScoreCard>& rescored) {
  if (is_here(attempt)) return false;
  store_imported(*database_, attempt, rescored, *holder_.person);
  return true;
}

std::vector<Origin> AdministratorDesk::origins() {
  require(*database_, holder_, Action::ListOrigins, Relation::Other, "the origins");
  return list_origins(*database_);
}

void AdministratorDesk::set_accepted(const DirectoryId& directory, bool is_accepted) {
  require(*database_, holder_, Action::AcceptOrigin, Relation::Other, "an origin");
  in_transaction(*database_, "accept an origin", [&] {
    database::set_accepted(*database_, directory, is_accepted);
    audit(is_accepted ? "origin_accepted" : "origin_unaccepted", "origin", directory.text);
  });
}

std::vector<Notice> AdministratorDesk::notices() {
  require(*database_, holder_, Action::ReadNotices, Relation::Other, "the notices");
  return unseen_notices_of_administrators(*database_, *holder_.person);
}

void AdministratorDesk::acknowledge(NoticeId notice) {
  const auto audience = audience_of(*database_, notice);
  const bool is_for_all = audience && !audience->person;
  require(*database_, holder_, Action::ReadNotices, is_for_all ? Relation::Other : Relation::Own,
          "notice " + std::to_string(notice.number));
  acknowledge_notice(*database_, notice, *holder_.person);
}

void AdministratorDesk::set_idle_lock_min(std::int32_t minutes) {
  require(*database_, holder_, Action::ChangeSettings, Relation::Other, "the settings");
  in_transaction(*database_, "change a setting", [&] {
    store_idle_lock_min(*database_, minutes);
    const std::string text = std::to_string(minutes);
    append_audit(*database_,
                 {holder_.person, "setting_changed", "setting", "idle_lock_min", false, {}, text});
  });
}

std::vector<Backup> AdministratorDesk::backups() {
  require(*database_, holder_, Action::BackUp, Relation::Other, "the backups");
  return list_backups(database_->directory() / "backups");
}

RetentionRules AdministratorDesk::retention() {
  require(*database_, holder_, Action::Retain, Relation::Other, "how long what is kept");
  return load_retention(*database_);
}

void AdministratorDesk::set_retention(const RetentionRules& rules) {
  require(*database_, holder_, Action::ChangeSettings, Relation::Other, "how long what is kept");
  in_transaction(*database_, "set how long what is kept", [&] {
    store_retention(*database_, rules);
    audit("retention_changed", "database", "");
  });
}

std::vector<RetentionPiece> AdministratorDesk::retention_plan() {
  require(*database_, holder_, Action::Retain, Relation::Other, "what need not be kept");
  return plan_retention(*database_);
}

RetentionDone AdministratorDesk::retain(const Progress& progress) {
  require(*database_, holder_, Action::Retain, Relation::Other, "what need not be kept");
  return apply_retention(*database_, holder_.person, progress);
}

}  // namespace hallux::database

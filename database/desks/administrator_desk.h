/// The administrator's desk: people, cohorts, scenarios, audit, backups, the robot's attempts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "database/course/catalogue.h"
#include "database/desks/desks.h"
#include "database/exchange/read_exported.h"
#include "database/maintenance/backup_rotation.h"
#include "database/maintenance/erasures.h"
#include "database/maintenance/person_export.h"
#include "database/maintenance/retention.h"
#include "database/people/one_time_codes.h"
#include "database/records/audit_line.h"
#include "database/records/limit.h"
#include "database/records/origin.h"
#include "database/records/report.h"
#include "database/reports/report_process.h"
#include "simulator/base/progress.h"

namespace hallux::database {

struct AddedPerson {
  PersonId id;
  IssuedCode issued;
};

struct EraseRequest {
  std::string login;
  std::string reason;
  bool with_recordings = false;
};

/// errors  DatabaseError: Refused, NotFound; and as in the files that are included
class AdministratorDesk : public AttemptDesk {
 public:
  // People.
  std::vector<Person> people();
  /// A person who chooses their password with the code that is returned.
  AddedPerson add_person_with_code(const NewPerson& person, const PasswordCost& cost = {});
  PersonId add_person(const NewPerson& person, const SecretText& password,
                      const PasswordCost& cost = {});
  /// Takes the password away and returns a code in its place. Not of oneself: change the password
  /// instead.
  IssuedCode reset(const std::string& login, const PasswordCost& cost = {});
  void set_password(const std::string& login, const SecretText& password,
                    const PasswordCost& cost = {});
  /// Disables, or enables again.
  /// errors  DatabaseError Refused for the last administrator who can sign in
  void set_disabled(const std::string& login, bool is_disabled);
  /// Corrects how a person is called; they are told, and the audit keeps the name before.
  /// errors  DatabaseError BadInput for a name against the rules, and where it is theirs already
  void correct_name(const std::string& login, const std::string& name);
  /// errors  DatabaseError Refused where it would take the role from the last administrator who can
  ///         sign in
  void set_administrator(const std::string& login, bool is_administrator);
  /// Takes all that names them away, for good.
  /// errors  DatabaseError: Refused for oneself, and where the proof is not the administrator's; as
  ///         in database/maintenance/erasures.h; Cancelled
  ErasedPieces erase_person(const EraseRequest& request, const PasswordProof& proof,
                            const Progress& progress = {});
  /// All that is kept of them, for them (database/maintenance/person_export.h).
  PersonExport export_person(const std::string& login, const std::filesystem::path& directory,
                             const Progress& progress = {});

  // Cohorts.
  std::vector<Cohort> cohorts();
  std::vector<CohortMember> members(CohortId cohort);
  CohortId add_cohort(const std::string& name);
  /// Puts a person into a cohort, or changes what they are there.
  void enrol(CohortId cohort, const std::string& login, CohortRole role);
  /// Takes a person out; their attempts stay theirs.
  void remove_from_cohort(CohortId cohort, const std::string& login);
  /// How many assessments of an operation each trainee of the cohort has; by name of the operation.
  std::vector<AttemptLimit> limits(CohortId cohort);
  void set_limit(CohortId cohort, const std::string& scenario_name, std::int32_t attempts_max);
  void clear_limit(CohortId cohort, const std::string& scenario_name);

  // Scenarios.
  std::vector<ScenarioVersion> scenarios();
  ScenarioText scenario_text(ScenarioVersionId id);
  /// needs   the text was checked (ui/jobs)
  ScenarioVersionId import_scenario(const ScenarioText& text);
  void publish_scenario(ScenarioVersionId id);
  void retire_scenario(ScenarioVersionId id);

  // The directory.
  AuditPage audit_page(const AuditRequest& request);
  /// Into `directory`, or where that is empty into `backups` of the data directory; lets go of old
  /// ones (rotation).
  Backup back_up(const std::filesystem::path& directory = {}, const Progress& progress = {});
  /// The answer to one SELECT over what reports may read; the statement is written to the audit,
  /// also where it fails.
  /// errors  DatabaseError as ReportConnection::answer
  Report report(const std::string& sql, ReportProcess& process);
  /// Where imported attempts come from.
  std::vector<Origin> origins();
  /// Whether this very attempt is here already.
  bool is_here(const ImportedAttempt& attempt);
  /// `rescored`: what this program makes of a sealed one. False where it was here already, and
  /// nothing was done.
  bool import_attempt(const ImportedAttempt& attempt, const std::optional<ScoreCard>& rescored);
  /// What was imported from there counts from now on, or no longer.
  void set_accepted(const DirectoryId& directory, bool is_accepted);
  /// What every administrator was told and this one did not acknowledge, newest first.
  std::vector<Notice> notices();
  /// errors  DatabaseError Refused where it was told to one person, or there is none
  void acknowledge(NoticeId notice);
  /// After how many minutes without a touch a window locks.
  /// errors  DatabaseError BadInput outside 5 to 60
  void set_idle_lock_min(std::int32_t minutes);
  /// Of `backups` in the data directory.
  std::vector<Backup> backups();
  RetentionRules retention();
  void set_retention(const RetentionRules& rules);
  /// A dry run: exactly what would go now.
  std::vector<RetentionPiece> retention_plan();
  RetentionDone retain(const Progress& progress = {});

 private:
  friend class Session;
  using AttemptDesk::AttemptDesk;
  /// The person of that login, once the table allowed `action` on them; `subject` begins what a
  /// refusal names.
  Person allowed_person(Action action, const std::string& login, const char* subject = "");
};

}  // namespace hallux::database

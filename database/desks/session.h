/// Signing in, and the data directory that has no people yet.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "database/desks/administrator_desk.h"
#include "database/desks/desks.h"
#include "database/desks/instructor_desk.h"
#include "database/desks/trainee_desk.h"
#include "database/people/sign_in_guard.h"

namespace hallux::database {

/// Somebody who signed in. Yields the desks they have a right to; must not outlive the Database.
class Session {
 public:
  const Person& person() const noexcept { return person_; }

  /// Everybody's own attempts; nothing for a person disabled since.
  std::optional<TraineeDesk> trainee();
  /// Nothing where the person is not an instructor of that cohort.
  std::optional<InstructorDesk> instructor_of(CohortId cohort);
  /// Nothing where the person is not an administrator.
  std::optional<AdministratorDesk> administrator();
  /// In which cohorts the person is what, by name.
  std::vector<Membership> memberships();

  /// All desks of this person: as trainee, as instructor of each cohort they teach, as
  /// administrator. None for a person disabled since.
  std::vector<AttemptDesk> desks();
  /// What they may list from any of them, each attempt once, newest first; all, or so many.
  std::vector<AttemptHeader> attempts(std::optional<std::int32_t> count_max = std::nullopt);
  /// The first of this person's desks from which the table allows `action` on that attempt; where
  /// none does, or there is no such attempt, the trainee's, which refuses; nothing for a person
  /// disabled since. Looking for it is not written to the audit.
  /// errors  DatabaseError NotFound where `id` begins more than one that they may see
  std::optional<AttemptDesk> desk_for(Action action, const AttemptId& id);

  /// errors  DatabaseError: Refused where the old password is wrong; TooSoon; BadInput for a weak
  ///         new one
  void change_password(const SecretText& old_password, const SecretText& new_password,
                       const PasswordCost& cost = {});
  /// The person at the window is still the one who signed in: for what a passer-by must not be able
  /// to do, and to open a locked window. Refusals are counted and written to the audit as those of
  /// a sign-in.
  /// errors  DatabaseError Refused where the password is wrong; TooSoon
  PasswordProof prove(const SecretText& password, const PasswordCost& cost = {});

  /// What this person was told and did not acknowledge: to them, and to every administrator where
  /// they are one.
  std::vector<Notice> notices();
  /// errors  DatabaseError Refused where it was told to others
  void acknowledge(const Notice& notice);
  void sign_out();

 private:
  friend Session sign_in(Database& database, std::string_view login, const SecretText& password,
                         const PasswordCost& cost);
  friend Session redeem_code(Database& database, std::string_view login, const SecretText& code,
                             const SecretText& new_password, const PasswordCost& cost);
  Session(Database& database, Person person, std::int64_t number)
      : database_(&database), person_(std::move(person)), number_(number) {}
  bool is_own_password(const SecretText& password, const std::string& action,
                       const PasswordCost& cost);

  Database* database_;
  Person person_;
  std::int64_t number_ = 0;
};

/// Takes as long for an unknown login as for a wrong password, and says the same. Both are written
/// to the audit, without what was typed: a password often lands in the wrong field.
/// errors  DatabaseError Refused; TooSoon
Session sign_in(Database& database, std::string_view login, const SecretText& password,
                const PasswordCost& cost = {});

/// Signs in with a one-time code, which is then gone, and sets the password chosen with it. An
/// unknown login, a wrong and an expired code are answered alike, and written to the audit.
/// errors  DatabaseError: Refused; TooSoon; BadInput for a weak password, which leaves the code as
///         it is
Session redeem_code(Database& database, std::string_view login, const SecretText& code,
                    const SecretText& new_password, const PasswordCost& cost = {});

/// A data directory without people: no sign-in is needed, and whoever is there may add the first
/// administrator, and keeps the directory as an administrator does at a desk.
/// errors  of all methods: DatabaseError Refused once somebody was added; as in the files that are
///         included
class OpenHouse {
 public:
  /// Nothing once there are people.
  static std::optional<OpenHouse> enter(Database& database);

  /// errors  DatabaseError BadInput where the person is no administrator
  PersonId add_first_administrator(const NewPerson& person, const SecretText& password,
                                   const PasswordCost& cost = {});

  /// The answer to one SELECT over what reports may read.
  Report report(const std::string& sql, ReportProcess& process);
  /// Without a directory into `backups` of the data directory.
  Backup back_up(const std::filesystem::path& directory = {}, const Progress& progress = {});
  std::vector<Backup> backups();
  RetentionRules retention();
  void set_retention(const RetentionRules& rules);
  std::vector<RetentionPiece> retention_plan();
  RetentionDone retain(const Progress& progress = {});

 private:
  explicit OpenHouse(Database& database) : database_(&database) {}
  /// The database, while it still has no people; `else_who` ends the refusal.
  Database& open(const char* else_who = "an administrator must do this") const;
  Database* database_;
};

}  // namespace hallux::database

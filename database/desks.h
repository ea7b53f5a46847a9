/// Desks: what a role may do. There is no other door to what is kept of people.
///
/// A desk offers only what its role may ever do; whether this person may do it to that row is decided by the policy table
/// (database/policy.h), which each method asks first. A refusal is written to the audit and thrown. A desk is had from a
/// Session, or from the house for what belongs to nobody (database/session.h); it must not outlive the Database.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/attempts.h"
#include "database/people.h"
#include "database/policy.h"
#include "database/scores.h"
#include "simulator/record/record.h"

namespace hallux::database {

class Session;
class OpenHouse;

/// Who sits at a desk.
struct DeskHolder {
  Role role = Role::House;
  std::optional<PersonId> person;  ///< nothing at the house's desk
  std::optional<CohortId> cohort;  ///< the instructor's
};

/// Reading attempts: the same for every role, with other rows.
class AttemptDesk {
 public:
  /// Those the table lets this desk list, newest first.
  std::vector<AttemptHeader> attempts();
  /// errors  DatabaseError: NotFound, Refused; of the other methods as well
  AttemptHeader header(const AttemptId& id);
  simulator::Recording recording(const AttemptId& id);
  std::optional<StoredScore> score(const AttemptId& id);
  /// Whether the table allows `action` on that attempt; asking is no refusal and is not written to the audit.
  bool may(Action action, const AttemptHeader& header);
  ScoreId store_score(const AttemptId& id, const ScoreCard& card);

 protected:
  AttemptDesk(Database& database, DeskHolder holder) : database_(&database), holder_(holder) {}
  WriterLease begin(const NewAttempt& attempt);

  Database* database_;
  DeskHolder holder_;
};

/// Nobody's desk: the robot's attempts, for scripts and for a data directory without people.
class HouseDesk : public AttemptDesk {
 public:
  explicit HouseDesk(Database& database) : AttemptDesk(database, {}) {}
  /// errors  DatabaseError Refused where the attempt names a person
  WriterLease begin_attempt(const NewAttempt& attempt) { return begin(attempt); }
};

class TraineeDesk : public AttemptDesk {
 public:
  /// errors  DatabaseError Refused where the attempt is not this person's
  WriterLease begin_attempt(const NewAttempt& attempt) { return begin(attempt); }

 private:
  friend class Session;
  using AttemptDesk::AttemptDesk;
};

class InstructorDesk : public AttemptDesk {
 private:
  friend class Session;
  using AttemptDesk::AttemptDesk;
};

/// People, and of the attempts the robot's only.
/// errors  DatabaseError: Refused; and as in database/people.h
class AdministratorDesk : public AttemptDesk {
 public:
  PersonId add_person(const NewPerson& person, const SecretText& password,
                      const PasswordCost& cost = {});
  std::vector<Person> people();
  void set_password(const std::string& login, const SecretText& password,
                    const PasswordCost& cost = {});
  /// Disables, or enables again.
  void set_disabled(const std::string& login, bool is_disabled);
  CohortId add_cohort(const std::string& name);
  void enrol(CohortId cohort, const std::string& login, CohortRole role);

 private:
  friend class Session;
  using AttemptDesk::AttemptDesk;
  Relation relation_to(const Person& person) const noexcept;
};

/// Asks the policy table, and whether the holder still has the role; writes a refusal to the audit.
/// errors  DatabaseError Refused
void require(Database& database, const DeskHolder& holder, Action action, Relation relation,
             const std::string& subject);

}  // namespace hallux::database

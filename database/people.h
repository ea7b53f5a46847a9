/// People, their passwords and the cohorts they belong to. The desks (database/desks.h) decide who may call what.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "database/connection.h"
#include "database/passwords.h"
#include "database/records/person.h"

namespace hallux::database {

/// errors  DatabaseError: BadInput for a login against the rules, one that is taken, or a weak password
PersonId create_person(Database& database, const NewPerson& person, const SecretText& password,
                       const PasswordCost& cost = {});

/// By login.
std::vector<Person> list_people(Database& database);
bool has_people(Database& database);

/// errors  DatabaseError NotFound naming the login
Person find_person(Database& database, std::string_view login);
/// errors  DatabaseError NotFound
Person load_person(Database& database, PersonId id);

/// The person whose login and password these are; nothing where the login is unknown, the password wrong, or the person
/// disabled, after the same work. A hash of another cost is made anew.
std::optional<Person> verify_person(Database& database, std::string_view login,
                                    const SecretText& password, const PasswordCost& cost = {});

/// errors  DatabaseError BadInput for a weak password
void set_password(Database& database, PersonId id, const SecretText& password,
                  const PasswordCost& cost = {});

/// errors  DatabaseError Refused where no enabled administrator would remain
void set_disabled(Database& database, PersonId id, bool is_disabled);

/// errors  DatabaseError BadInput where the name is empty or taken
CohortId create_cohort(Database& database, const std::string& name);
/// Puts a person into a cohort, or changes what they are there.
/// errors  DatabaseError NotFound
void enrol(Database& database, CohortId cohort, PersonId person, CohortRole role);
/// By number.
std::vector<CohortId> cohorts_taught_by(Database& database, PersonId person);
/// Nothing where the person is not in the cohort.
std::optional<CohortRole> role_in(Database& database, CohortId cohort, PersonId person);

}  // namespace hallux::database

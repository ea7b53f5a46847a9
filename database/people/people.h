/// People and their passwords. The desks (database/desks/desks.h) decide who may call what.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "database/people/passwords.h"
#include "database/records/person.h"
#include "database/store/connection.h"

namespace hallux::database {

/// errors  DatabaseError: BadInput for a login against the rules, one that is taken, or a weak
///         password
PersonId create_person(Database& database, const NewPerson& person, const SecretText& password,
                       const PasswordCost& cost = {});

/// errors  DatabaseError BadInput for a login against the rules or one that is taken
PersonId create_person_without_password(Database& database, const NewPerson& person);

/// By login; without the nameless people of imported attempts.
std::vector<Person> list_people(Database& database);
bool has_people(Database& database);

/// Nothing where there is nobody of that login.
std::optional<Person> known_person(Database& database, std::string_view login);
/// errors  DatabaseError NotFound naming the login
Person find_person(Database& database, std::string_view login);
/// errors  DatabaseError NotFound
Person load_person(Database& database, PersonId id);

/// The person whose login and password these are; nothing where the login is unknown, the password
/// wrong, or the person disabled, after the same work. A hash of another cost is made anew.
std::optional<Person> verify_person(Database& database, std::string_view login,
                                    const SecretText& password, const PasswordCost& cost = {});

/// errors  DatabaseError BadInput for a weak password
void set_password(Database& database, PersonId id, const SecretText& password,
                  const PasswordCost& cost = {});

/// How the person is called from now on; their login where `name` is empty. Returns the name
/// before.
/// errors  DatabaseError BadInput for a name against the rules, and where it is theirs already
std::string set_display_name(Database& database, PersonId id, const std::string& name);

/// errors  DatabaseError Refused where no administrator who can sign in would remain
void set_disabled(Database& database, PersonId id, bool is_disabled);

/// errors  DatabaseError Refused where no administrator who can sign in would remain
void set_administrator(Database& database, PersonId id, bool is_administrator);

/// Nobody can sign in as them until a one-time code was redeemed
/// (database/people/one_time_codes.h).
/// errors  DatabaseError Refused where no administrator who can sign in would remain
void remove_password(Database& database, PersonId id);

}  // namespace hallux::database

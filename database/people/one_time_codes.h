/// One-time codes, with which new and reset people choose a password; only a hash is stored.
/// Inside this room only.
///
/// A code has 60 random bits in three groups of four letters and digits that cannot be taken for
/// each other ("7QK2-M9XD-3VTA"); case, spaces and dashes do not matter, and O, I, L read as 0, 1,
/// 1.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "database/people/passwords.h"
#include "database/records/person.h"
#include "database/store/connection.h"

namespace hallux::database {

inline constexpr int one_time_code_days = 7;

struct IssuedCode {
  /// Shown once; nobody can read it again.
  SecretText code;
  std::string expires_utc;
};

/// A new one, as it is shown.
SecretText random_code();

/// Takes the place of an earlier code of that person.
/// errors  DatabaseError NotFound
IssuedCode issue_code(Database& database, PersonId person, PersonId issued_by,
                      const PasswordCost& cost = {});

/// Whose code this is; nothing where the login is unknown, the code wrong or expired, or the person
/// disabled, after the same work.
std::optional<Person> verify_code(Database& database, std::string_view login,
                                  const SecretText& code, const PasswordCost& cost = {});

/// Removes a code that was used, or that an administrator took back.
/// errors  DatabaseError
void remove_code(Database& database, PersonId person);

}  // namespace hallux::database

/// People as they are listed; never a password. Inside this room only.
#pragma once

#include <string>
#include <string_view>

#include "database/records/ids.h"
#include "database/records/names.h"

namespace hallux::database {

enum class CohortRole { Trainee, Instructor };

template <>
inline constexpr std::array<std::string_view, 2> stored_names<CohortRole>{"trainee", "instructor"};

/// Whether a login may be called that: 2 to 64 of a-z 0-9 . _ -, beginning with a letter.
bool is_login(std::string_view login) noexcept;
/// Whether it can become one by typing on: nothing in it is against the rules yet.
bool may_become_login(std::string_view typed) noexcept;

struct NewPerson {
  /// As is_login wants it.
  std::string login;
  /// May be empty: the login is then shown.
  std::string display_name;
  bool is_administrator = false;
};

struct Person {
  PersonId id;
  std::string login;
  std::string display_name;
  bool is_administrator = false;
  bool is_disabled = false;
  std::string created_utc;
  /// "" where there was none.
  std::string last_sign_in_utc;
  /// False: nobody can sign in as them until a code was redeemed.
  bool has_password = true;
  /// Of the one-time code that waits for them; "" for none.
  std::string code_expires_utc;
};

}  // namespace hallux::database

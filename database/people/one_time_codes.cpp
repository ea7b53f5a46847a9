#include "database/people/one_time_codes.h"

#include <sodium.h>

#include <algorithm>
#include <array>

#include "database/people/people.h"
#include "database/records/code_form.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

/// What a person typed, as it is hashed.
SecretText plain_code(const SecretText& typed) {
  std::string text;
  text.reserve(typed.view().size());
  for (const char letter : typed.view()) {
    if (const char plain = plain_code_letter(letter); plain != 0) text.push_back(plain);
  }
  return SecretText::take(text);
}

std::string time_after_days(Database& database, int days) {
  return single<std::string>(database, "SELECT strftime('%Y-%m-%dT%H:%M:%fZ', ?, ?)",
                             utc_now(database), "+" + std::to_string(days) + " days");
}

std::optional<std::string> live_hash(Database& database, PersonId person) {
  return found<std::string>(
      database, "SELECT argon2id FROM one_time_code WHERE person_id = ? AND expires_utc > ?",
      person.number, utc_now(database));
}

}  // namespace

SecretText random_code() {
  std::array<unsigned char, code_length> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  std::string text;
  for (std::size_t i = 0; i < code_length; ++i) {
    if (i == 4 || i == 8) text.push_back('-');
    text.push_back(code_letters[bytes[i] & 31U]);
  }
  sodium_memzero(bytes.data(), bytes.size());
  return SecretText::take(text);
}

IssuedCode issue_code(Database& database, PersonId person, PersonId issued_by,
                      const PasswordCost& cost) {
  SecretText code = random_code();
  const std::string argon2id = hash_password(plain_code(code), cost);
  std::string expires_utc;
  in_transaction_of_caller(database, "issue a one-time code", [&] {
    load_person(database, person);
    expires_utc = time_after_days(database, one_time_code_days);
    execute(database,
            "INSERT OR REPLACE INTO one_time_code (person_id, argon2id, "
            "issued_by_person_id, issued_utc, expires_utc) VALUES (?, ?, ?, ?, ?)",
            person.number, argon2id, issued_by.number, utc_now(database), expires_utc);
  });
  return {std::move(code), std::move(expires_utc)};
}

std::optional<Person> verify_code(Database& database, std::string_view login,
                                  const SecretText& code, const PasswordCost& cost) {
  return translating(database, "check a one-time code", [&]() -> std::optional<Person> {
    std::optional<Person> person = known_person(database, login);
    const auto argon2id = person ? live_hash(database, person->id) : std::nullopt;
    if (!argon2id) {
      spend_same_work(code, cost);
      return std::nullopt;
    }
    if (!is_password(*argon2id, plain_code(code)) || person->is_disabled) return std::nullopt;
    return person;
  });
}

void remove_code(Database& database, PersonId person) {
  in_transaction_of_caller(database, "remove a one-time code", [&] {
    execute(database, "DELETE FROM one_time_code WHERE person_id = ?", person.number);
  });
}

}  // namespace hallux::database

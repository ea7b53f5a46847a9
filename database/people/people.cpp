/// What a person is stands in four tables, so that an erasure can take the name and the password
/// and leave the number that attempts are of. Hashes, which are slow on purpose, are made before a
/// transaction begins: nobody waits for its lock meanwhile. No act may leave a directory without an
/// administrator who can sign in.
#include "database/people/people.h"

#include "database/store/sql.h"
#include "database/text/free_text.h"

namespace hallux::database {

namespace {

constexpr const char* person_columns =
    "SELECT p.person_id, coalesce(d.login, ''), coalesce(d.display_name, ''), p.is_administrator, "
    "p.is_disabled, p.created_utc, "
    "(SELECT max(s.started_utc) FROM session s WHERE s.person_id = p.person_id), "
    "EXISTS (SELECT 1 FROM password w WHERE w.person_id = p.person_id), c.expires_utc "
    "FROM person p LEFT JOIN person_detail d USING (person_id) "
    "LEFT JOIN one_time_code c USING (person_id) ";

Person person_in(SQLite::Statement& row) {
  return {PersonId{row.getColumn(0).getInt64()}, row.getColumn(1).getString(),
          row.getColumn(2).getString(),          row.getColumn(3).getInt() != 0,
          row.getColumn(4).getInt() != 0,        row.getColumn(5).getString(),
          row.getColumn(6).getString(),          row.getColumn(7).getInt() != 0,
          row.getColumn(8).getString()};
}

void check_login_rules(const std::string& login) {
  if (is_login(login)) return;
  throw DatabaseError{
      DatabaseErrorKind::BadInput,
      "the login '" + login +
          "' cannot be used: take 2 to 64 of a-z 0-9 . _ - beginning with a letter"};
}

std::optional<Person> person_named(Database& database, std::string_view login) {
  auto row = prepared(database, std::string{person_columns} + "WHERE d.login = ?", login);
  if (!row.executeStep()) return std::nullopt;
  return person_in(row);
}

void store_hash(Database& database, PersonId id, const std::string& argon2id) {
  execute(database,
          "INSERT INTO password (person_id, argon2id, changed_utc) VALUES (?, ?, ?) "
          "ON CONFLICT (person_id) DO UPDATE SET argon2id = excluded.argon2id, "
          "changed_utc = excluded.changed_utc",
          id.number, argon2id, utc_now(database));
}

PersonId insert_person(Database& database, const NewPerson& person) {
  check_name("the name of " + person.login, person.display_name);
  execute(database, "INSERT INTO person (is_administrator, created_utc) VALUES (?, ?)",
          person.is_administrator ? 1 : 0, utc_now(database));
  const PersonId id{database.connection().getLastInsertRowid()};
  execute(database, "INSERT INTO person_detail (person_id, login, display_name) VALUES (?, ?, ?)",
          id.number, person.login,
          person.display_name.empty() ? person.login : person.display_name);
  return id;
}

/// One who can sign in: a code that nobody redeemed yet may expire.
void check_an_administrator_remains(Database& database, const char* what_cannot_be) {
  if (single<bool>(database,
                   "SELECT EXISTS (SELECT 1 FROM person JOIN password USING (person_id) "
                   "WHERE is_administrator = 1 AND is_disabled = 0)")) {
    return;
  }
  throw DatabaseError{DatabaseErrorKind::Refused, "the last administrator of " +
                                                      database.file().string() +
                                                      " who can sign in " + what_cannot_be +
                                                      "; make another administrator first"};
}

void set_flag(Database& database, const char* tried, const char* sql, PersonId id, bool value,
              const char* what_cannot_be) {
  in_transaction_of_caller(database, tried, [&] {
    load_person(database, id);
    execute(database, sql, value ? 1 : 0, id.number);
    check_an_administrator_remains(database, what_cannot_be);
  });
}

PersonId insert_new_person(Database& database, const NewPerson& person) {
  if (person_named(database, person.login)) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        "the login '" + person.login + "' is taken in " + database.file().string() +
                            "; choose another"};
  }
  return insert_person(database, person);
}

}  // namespace

PersonId create_person(Database& database, const NewPerson& person, const SecretText& password,
                       const PasswordCost& cost) {
  check_login_rules(person.login);
  check_password_rules(password, person.login);
  const std::string argon2id = hash_password(password, cost);
  return in_transaction_of_caller(database, "add a person", [&] {
    const PersonId id = insert_new_person(database, person);
    store_hash(database, id, argon2id);
    return id;
  });
}

PersonId create_person_without_password(Database& database, const NewPerson& person) {
  check_login_rules(person.login);
  return in_transaction_of_caller(database, "add a person",
                                  [&] { return insert_new_person(database, person); });
}

std::vector<Person> list_people(Database& database) {
  return translating(database, "list the people", [&] {
    auto rows = prepared(database, std::string{person_columns} +
                                       "WHERE d.login IS NOT NULL OR NOT EXISTS (SELECT 1 FROM "
                                       "origin_person o WHERE o.person_id = p.person_id) "
                                       "ORDER BY d.login, p.person_id");
    return collected(rows, person_in);
  });
}

bool has_people(Database& database) {
  return translating(database, "look for people", [&] {
    return single<bool>(database, "SELECT EXISTS (SELECT 1 FROM person)");
  });
}

std::optional<Person> known_person(Database& database, std::string_view login) {
  return translating(database, "look for a person", [&] { return person_named(database, login); });
}

Person find_person(Database& database, std::string_view login) {
  return translating(database, "look for a person", [&] {
    if (auto person = person_named(database, login)) return *person;
    throw DatabaseError{DatabaseErrorKind::NotFound, "there is no person '" + std::string{login} +
                                                         "' in " + database.file().string() +
                                                         "; `hallux user list` lists them"};
  });
}

Person load_person(Database& database, PersonId id) {
  return translating(database, "look for a person", [&] {
    auto row = prepared(database, std::string{person_columns} + "WHERE p.person_id = ?", id.number);
    if (row.executeStep()) return person_in(row);
    throw DatabaseError{DatabaseErrorKind::NotFound, "there is no person with number " +
                                                         std::to_string(id.number) + " in " +
                                                         database.file().string()};
  });
}

std::optional<Person> verify_person(Database& database, std::string_view login,
                                    const SecretText& password, const PasswordCost& cost) {
  return translating(database, "check a password", [&]() -> std::optional<Person> {
    std::optional<Person> person = person_named(database, login);
    std::string argon2id;
    if (person) {
      auto row = prepared(database, "SELECT argon2id FROM password WHERE person_id = ?",
                          person->id.number);
      if (row.executeStep()) argon2id = row.getColumn(0).getString();
    }
    if (argon2id.empty()) {
      spend_same_work(password, cost);
      return std::nullopt;
    }
    if (!is_password(argon2id, password) || person->is_disabled) return std::nullopt;
    if (needs_rehash(argon2id, cost)) {
      const std::string renewed = hash_password(password, cost);
      in_transaction_of_caller(database, "renew a password's hash",
                               [&] { store_hash(database, person->id, renewed); });
    }
    return person;
  });
}

void set_password(Database& database, PersonId id, const SecretText& password,
                  const PasswordCost& cost) {
  check_password_rules(password, load_person(database, id).login);
  const std::string argon2id = hash_password(password, cost);
  in_transaction_of_caller(database, "set a password", [&] { store_hash(database, id, argon2id); });
}

std::string set_display_name(Database& database, PersonId id, const std::string& name) {
  return in_transaction_of_caller(database, "correct a name", [&] {
    Person person = load_person(database, id);
    check_name("the name of " + person.login, name);
    const std::string shown = name.empty() ? person.login : name;
    if (shown == person.display_name) {
      throw DatabaseError{DatabaseErrorKind::BadInput,
                          "'" + person.login + "' is called that already; nothing was changed"};
    }
    execute(database, "UPDATE person_detail SET display_name = ? WHERE person_id = ?", shown,
            id.number);
    return std::move(person.display_name);
  });
}

void set_disabled(Database& database, PersonId id, bool is_disabled) {
  set_flag(database, "disable or enable a person",
           "UPDATE person SET is_disabled = ? WHERE person_id = ?", id, is_disabled,
           "cannot be disabled");
}

void set_administrator(Database& database, PersonId id, bool is_administrator) {
  set_flag(database, "change a role", "UPDATE person SET is_administrator = ? WHERE person_id = ?",
           id, is_administrator, "cannot lose the role");
}

void remove_password(Database& database, PersonId id) {
  in_transaction_of_caller(database, "remove a password", [&] {
    execute(database, "DELETE FROM password WHERE person_id = ?", id.number);
    check_an_administrator_remains(database, "cannot lose their password");
  });
}

}  // namespace hallux::database

#include "database/exchange/origins.h"

#include "database/store/sql.h"

namespace hallux::database {

namespace {

bool is_identity(const std::string& text) noexcept {
  return text.size() == 32 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::int64_t number_of(Database& database, const DirectoryId& directory) {
  return found<std::int64_t>(database, "SELECT origin_id FROM origin WHERE directory_uuid = ?",
                             directory.text)
      .value_or(0);
}

PersonId make_nameless_person(Database& database) {
  execute(database,
          "INSERT INTO person (is_administrator, is_disabled, created_utc) "
          "VALUES (0, 1, ?)",
          utc_now(database));
  return {database.connection().getLastInsertRowid()};
}

std::optional<PersonId> known_origin_person(Database& database, std::int64_t origin,
                                            PersonId there) {
  return found<PersonId>(database,
                         "SELECT person_id FROM origin_person WHERE origin_id = ? AND "
                         "number_there = ?",
                         origin, there.number);
}

}  // namespace

std::vector<Origin> list_origins(Database& database) {
  return translating(database, "list the origins", [&] {
    return rows_of(
        prepared(database,
                 "SELECT o.directory_uuid, o.is_accepted, o.imported_utc, "
                 "(SELECT count(*) FROM attempt a WHERE a.origin_id = o.origin_id), "
                 "(SELECT count(*) FROM origin_person p WHERE p.origin_id = o.origin_id) "
                 "FROM origin o ORDER BY o.origin_id"),
        &Origin::directory, &Origin::is_accepted, &Origin::imported_utc, &Origin::attempts,
        &Origin::people);
  });
}

std::int64_t note_origin(Database& database, const DirectoryId& directory) {
  if (!is_identity(directory.text)) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        "an origin is named by 32 hexadecimal digits; this is no export of ours"};
  }
  return in_transaction_of_caller(database, "note an origin", [&] {
    if (const std::int64_t known = number_of(database, directory)) return known;
    execute(database, "INSERT INTO origin (directory_uuid, imported_utc) VALUES (?, ?)",
            directory.text, utc_now(database));
    return static_cast<std::int64_t>(database.connection().getLastInsertRowid());
  });
}

PersonId note_origin_person(Database& database, std::int64_t origin, PersonId there) {
  return in_transaction_of_caller(database, "note a person of an origin", [&] {
    if (const auto known = known_origin_person(database, origin, there)) return *known;
    const PersonId here = make_nameless_person(database);
    execute(database,
            "INSERT INTO origin_person (origin_id, number_there, person_id) "
            "VALUES (?, ?, ?)",
            origin, there.number, here.number);
    return here;
  });
}

void refuse_erased(Database& database, std::int64_t origin, PersonId there) {
  translating(database, "look for an erased person", [&] {
    // Of an export of this very directory the number is that of a person here.
    auto row =
        prepared(database,
                 "SELECT substr(e.erased_utc, 1, 10) FROM erasure e WHERE e.person_id IN "
                 "(SELECT person_id FROM origin_person WHERE origin_id = ?1 AND number_there = ?2) "
                 "OR (e.person_id = ?2 AND EXISTS (SELECT 1 FROM origin JOIN directory ON "
                 "uuid = directory_uuid WHERE origin_id = ?1))",
                 origin, there.number);
    if (!row.executeStep()) return;
    throw DatabaseError{DatabaseErrorKind::Refused,
                        "person " + std::to_string(there.number) +
                            " of that directory was erased in " + database.file().string() + " (" +
                            row.getColumn(0).getString() + "); what was erased does not come back"};
  });
}

void set_accepted(Database& database, const DirectoryId& directory, bool is_accepted) {
  in_transaction_of_caller(database, "accept an origin", [&] {
    if (execute(database, "UPDATE origin SET is_accepted = ? WHERE directory_uuid = ?",
                is_accepted ? 1 : 0, directory.text) == 1)
      return;
    throw DatabaseError{DatabaseErrorKind::NotFound,
                        "nothing was imported into " + database.file().string() + " from '" +
                            directory.text + "'; `hallux origins` lists what was"};
  });
}

}  // namespace hallux::database

/// A row's digest is of its table, and of the names, types and values of its columns, so that
/// another program can compute it. Folding takes SQLite's temporary storage, not memory: a large
/// directory has some hundred thousand accounts.
#include "database/audit/row_accounts.h"

#include <sodium.h>

#include <array>
#include <cstring>

#include "database/audit/audit.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

using Salt = std::array<std::byte, 16>;
constexpr const char* baseline_action = "baseline_taken";

void add_value(Digester& digester, const SQLite::Column& value) {
  digester.add_int(value.getType());
  if (value.isInteger()) {
    digester.add_int(value.getInt64());
  } else if (value.isFloat()) {
    digester.add_double(value.getDouble());
  } else if (!value.isNull()) {
    const auto* const bytes = static_cast<const char*>(value.getBlob());
    digester.add_text({bytes == nullptr ? "" : bytes, static_cast<std::size_t>(value.getBytes())});
  }
}

/// Of the columns of a row from `first` on.
Digest row_digest(const AccountedTable& table, SQLite::Statement& row, int first,
                  std::span<const std::byte> salt) {
  Digester digester;
  digester.add_text(table.name);
  digester.add_bytes(salt);
  for (int i = first; i < row.getColumnCount(); ++i) {
    const SQLite::Column value = row.getColumn(i);
    if (value.getName() == table.left_out) continue;
    digester.add_text(value.getName());
    add_value(digester, value);
  }
  return digester.finish();
}

/// The row's key as it is named, as SQL.
std::string key_sql(const AccountedTable& table) {
  std::string sql = "CAST(";
  for (const char letter : table.keys) {
    if (letter == ',') {
      sql += " AS TEXT) || '/' || CAST(";
    } else if (letter != ' ') {
      sql += letter;
    }
  }
  return sql + " AS TEXT)";
}

std::string name_of_table(const AccountedTable& table) { return std::string{table.name}; }

/// "person_id = ?" and, of two keys, both.
std::string where_sql(const AccountedTable& table) {
  if (table.key_count == 1) return std::string{table.keys} + " = ?";
  return "(" + std::string{table.keys} + ") = (?, ?)";
}

/// Keys of numbers come first, and a text may hold a stroke.
void bind_key(SQLite::Statement& statement, const AccountedTable& table, const std::string& key) {
  if (table.key_count == 1) return statement.bind(1, key);
  const std::size_t stroke = key.find('/');
  statement.bind(1, key.substr(0, stroke));
  statement.bind(2, key.substr(stroke + 1));
}

void drop_salt(Database& database, const RowName& row) {
  execute(database, "DELETE FROM row_salt WHERE table_name = ? AND row_key = ?", row.first,
          row.second);
}

Salt renew_salt(Database& database, const RowName& row) {
  Salt salt{};
  randombytes_buf(salt.data(), salt.size());
  execute(database,
          "INSERT INTO row_salt (table_name, row_key, salt) VALUES (?, ?, ?) "
          "ON CONFLICT (table_name, row_key) DO UPDATE SET salt = excluded.salt",
          row.first, row.second, salt);
  return salt;
}

RowAccount account_of(Database& database, const AccountedTable& table, const RowName& name) {
  RowAccount account{name.first, name.second, std::nullopt};
  SQLite::Statement row{database.connection(),
                        "SELECT * FROM " + name_of_table(table) + " WHERE " + where_sql(table)};
  bind_key(row, table, name.second);
  const bool is_there = row.executeStep();
  if (table.holds_words && !is_there) drop_salt(database, name);
  if (!is_there) return account;
  if (!table.holds_words) {
    account.digest = row_digest(table, row, 0, {});
  } else {
    const Salt salt = renew_salt(database, name);
    account.digest = row_digest(table, row, 0, salt);
  }
  return account;
}

std::set<RowName> all_rows(Database& database) {
  std::set<RowName> rows;
  for (const AccountedTable& table : accounted_tables) {
    for (std::string& key : all_of<std::string>(
             database, "SELECT " + key_sql(table) + " FROM " + name_of_table(table))) {
      rows.emplace(table.name, std::move(key));
    }
  }
  return rows;
}

}  // namespace

std::vector<RowAccount> account_for(Database& database, const std::set<RowName>& rows) {
  std::vector<RowAccount> accounts;
  for (const RowName& row : rows) {
    const AccountedTable* const table = accounted_table(row.first);
    if (table != nullptr) accounts.push_back(account_of(database, *table, row));
  }
  return accounts;
}

RowAccount account_of_text(std::int64_t act, std::span<const std::byte> salt,
                           const std::string& text) {
  Digester digester;
  const auto add = [&digester](const char* name, int type) {
    digester.add_text(name);
    digester.add_int(type);
  };
  digester.add_text("audit_text");
  add("audit_id", SQLite::INTEGER);
  digester.add_int(act);
  add("salt", SQLite::BLOB);
  digester.add_text({reinterpret_cast<const char*>(salt.data()), salt.size()});
  add("text", SQLite::TEXT);
  digester.add_text(text);
  return {"audit_text", std::to_string(act), digester.finish()};
}

Digest digest_of_accounts(const std::vector<RowAccount>& accounts) {
  Digester digester;
  for (const RowAccount& account : accounts) {
    digester.add_text(account.table);
    digester.add_text(account.key);
    digester.add_int(account.digest ? 1 : 0);
    digester.add_digest(account.digest.value_or(Digest{}));
  }
  return digester.finish();
}

void store_accounts(Database& database, std::int64_t act, const std::vector<RowAccount>& accounts) {
  auto insert = prepared(database,
                         "INSERT INTO audit_row (audit_id, place, table_name, row_key, row_digest) "
                         "VALUES (?, ?, ?, ?, ?)");
  std::int64_t place = 0;
  for (const RowAccount& account : accounts) {
    run_again(insert, act, place++, account.table, account.key, account.digest);
  }
}

std::vector<std::pair<std::int64_t, RowAccount>> load_accounts(Database& database,
                                                               std::int64_t first,
                                                               std::int64_t last) {
  auto rows = prepared(database,
                       "SELECT audit_id, table_name, row_key, row_digest FROM audit_row "
                       "WHERE audit_id BETWEEN ? AND ? ORDER BY audit_id, place",
                       first, last);
  return collected(rows, [](SQLite::Statement& row) {
    std::pair<std::int64_t, RowAccount> found;
    read_columns(row, 0, found.first, found.second.table, found.second.key, found.second.digest);
    return found;
  });
}

std::optional<Baseline> first_baseline(Database& database) {
  auto row = prepared(database,
                      "SELECT audit_id, at_utc FROM audit WHERE action = ? "
                      "ORDER BY audit_id LIMIT 1",
                      baseline_action);
  if (!row.executeStep()) return std::nullopt;
  Baseline baseline;
  read_columns(row, 0, baseline.act, baseline.at_utc);
  return baseline;
}

std::optional<Unaccounted> first_unaccounted(Database& database, const AccountedTable& table) {
  const std::string name = name_of_table(table);
  const auto unaccounted = [&](const std::string& key, const char* how) {
    return Unaccounted{name + " " + key, how};
  };
  const SQLite::Transaction moment{database.connection()};
  SQLite::Database& connection = database.connection();
  connection.exec(
      "CREATE TEMP TABLE IF NOT EXISTS folded (row_key TEXT PRIMARY KEY, row_digest BLOB, "
      "seen INTEGER NOT NULL DEFAULT 0) WITHOUT ROWID");
  connection.exec("DELETE FROM temp.folded");
  execute(database,
          "INSERT INTO temp.folded (row_key, row_digest) SELECT row_key, row_digest FROM "
          "main.audit_row WHERE table_name = ? ORDER BY audit_id, place "
          "ON CONFLICT (row_key) DO UPDATE SET row_digest = excluded.row_digest",
          name);
  SQLite::Statement rows{connection,
                         "SELECT " + key_sql(table) +
                             " AS row_name, f.row_digest, f.row_key IS NOT NULL, s.salt, t.* "
                             "FROM main." +
                             name +
                             " t LEFT JOIN temp.folded f ON f.row_key = row_name "
                             "LEFT JOIN main.row_salt s ON s.table_name = '" +
                             name + "' AND s.row_key = row_name"};
  auto mark = prepared(database, "UPDATE temp.folded SET seen = 1 WHERE row_key = ?");
  constexpr int columns_before = 4;
  while (rows.executeStep()) {
    const std::string key = rows.getColumn(0).getString();
    const std::optional<Digest> expected = digest_in(rows.getColumn(1));
    if (!expected) return unaccounted(key, "is there without an act");
    const SQLite::Column salt = rows.getColumn(3);
    const auto* const bytes = static_cast<const std::byte*>(salt.getBlob());
    const std::span<const std::byte> kept{
        bytes, table.holds_words ? static_cast<std::size_t>(salt.getBytes()) : 0};
    if (row_digest(table, rows, columns_before, kept) != *expected) {
      return unaccounted(key, "is not as the audit says");
    }
    run_again(mark, key);
  }
  const auto missing = found<std::string>(
      database,
      "SELECT row_key FROM temp.folded WHERE seen = 0 AND row_digest IS NOT NULL LIMIT 1");
  if (missing) return unaccounted(*missing, "is missing");
  return std::nullopt;
}

void settle_changes(Database& database) {
  if (database.changes() == nullptr || database.changes()->is_empty()) return;
  append_audit(database, {std::nullopt, "rows_changed", "database", ""});
}

void take_baseline(Database& database) {
  if (first_baseline(database)) return;
  append_baseline(database, {std::nullopt, baseline_action, "database", ""},
                  account_for(database, all_rows(database)));
}

}  // namespace hallux::database

#include "database/store/changed_rows.h"

#include <sqlite3.h>

#include <algorithm>

namespace hallux::database {

/// SQLite's calls back. What they are told lives for the call only, and they may ask the connection
/// nothing.
struct ChangeHooks {
  using ReadValue = int (*)(sqlite3*, int, sqlite3_value**);

  static std::string key_of(sqlite3* connection, int key_count, ReadValue read) {
    std::string key;
    for (int i = 0; i < key_count; ++i) {
      sqlite3_value* value = nullptr;
      read(connection, i, &value);
      const auto* const text =
          value == nullptr ? nullptr : static_cast<const void*>(sqlite3_value_text(value));
      key += (i > 0 ? "/" : "");
      key += text == nullptr ? "" : static_cast<const char*>(text);
    }
    return key;
  }

  static void before_change(void* self, sqlite3* connection, int change, const char*,
                            const char* table, sqlite3_int64, sqlite3_int64) {
    const AccountedTable* const accounted = accounted_table(table);
    if (accounted == nullptr) return;
    auto& rows = static_cast<ChangedRows*>(self)->rows_;
    const auto note = [&](ReadValue read) {
      rows.emplace(table, key_of(connection, accounted->key_count, read));
    };
    if (change != SQLITE_INSERT) note(sqlite3_preupdate_old);
    if (change != SQLITE_DELETE) note(sqlite3_preupdate_new);
  }

  /// Not zero turns the commit into a rollback.
  static int before_commit(void* self) {
    return static_cast<const ChangedRows*>(self)->is_empty() ? 0 : 1;
  }

  static void after_rollback(void* self) { static_cast<ChangedRows*>(self)->rows_.clear(); }
};

const AccountedTable* accounted_table(std::string_view name) noexcept {
  const auto* const found = std::ranges::find(accounted_tables, name, &AccountedTable::name);
  return found == accounted_tables.end() ? nullptr : found;
}

ChangedRows::ChangedRows(sqlite3* connection) : connection_(connection) {
  sqlite3_preupdate_hook(connection_, &ChangeHooks::before_change, this);
  sqlite3_commit_hook(connection_, &ChangeHooks::before_commit, this);
  sqlite3_rollback_hook(connection_, &ChangeHooks::after_rollback, this);
}

ChangedRows::~ChangedRows() {
  sqlite3_preupdate_hook(connection_, nullptr, nullptr);
  sqlite3_commit_hook(connection_, nullptr, nullptr);
  sqlite3_rollback_hook(connection_, nullptr, nullptr);
}

std::set<RowName> ChangedRows::take() { return std::exchange(rows_, {}); }

}  // namespace hallux::database

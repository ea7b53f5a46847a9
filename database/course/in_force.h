/// Of an attempt's rows of one kind (scores, decisions) at most one is in force; the others name
/// what came after them. Inside this corner only.
#pragma once

#include <string>

#include "database/store/sql.h"

namespace hallux::database {

/// Runs `insert`, which stores a row of `table` and answers with its number; the row in force until
/// then names it. Meanwhile that row names itself: the schema refuses two in force.
template <typename Insert>
std::int64_t put_in_force(Database& database, const std::string& table, const AttemptId& attempt,
                          Insert insert) {
  const std::string key = table + "_id";
  const auto before = found<std::int64_t>(
      database,
      "SELECT " + key + " FROM " + table +
          " JOIN attempt USING (attempt_id) WHERE uuid = ? AND superseded_by IS NULL",
      attempt);
  const auto supersede = [&](std::int64_t by) {
    if (!before) return;
    execute(database, "UPDATE " + table + " SET superseded_by = ? WHERE " + key + " = ?", by,
            *before);
  };
  if (before) supersede(*before);
  const std::int64_t number = insert();
  supersede(number);
  return number;
}

}  // namespace hallux::database

/// SQL statements: errors translated once, transactions, digests as blobs. Inside this room only.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "database/store/connection.h"
#include "simulator/base/digest.h"

namespace hallux::database {

/// The sentence "could not `tried` in FILE: reason; what to do" with its kind.
DatabaseError translated(const SQLite::Exception& error, std::string_view tried,
                         const std::filesystem::path& file);

/// Runs `work`; what SQLite throws becomes a DatabaseError about what was `tried`.
template <typename Work>
decltype(auto) translating(const Database& database, std::string_view tried, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const SQLite::Exception& error) {
    throw translated(error, tried, database.file());
  }
}

bool is_in_transaction(Database& database) noexcept;

/// The bytes of all pages of the file, its log not counted.
std::int64_t page_bytes(Database& database);

/// Runs `work` in one IMMEDIATE transaction: committed where it returns, undone where it throws.
template <typename Work>
auto in_transaction(Database& database, std::string_view tried, Work&& work) {
  return translating(database, tried, [&] {
    SQLite::Transaction transaction{database.connection(), SQLite::TransactionBehavior::IMMEDIATE};
    if constexpr (std::is_void_v<std::invoke_result_t<Work>>) {
      std::forward<Work>(work)();
      transaction.commit();
    } else {
      auto result = std::forward<Work>(work)();
      transaction.commit();
      return result;
    }
  });
}

/// Runs `work` inside the transaction the caller has begun, or in one of its own where there is
/// none.
template <typename Work>
auto in_transaction_of_caller(Database& database, std::string_view tried, Work&& work) {
  if (is_in_transaction(database)) return translating(database, tried, std::forward<Work>(work));
  return in_transaction(database, tried, std::forward<Work>(work));
}

/// The time now as every row keeps it: ISO 8601, milliseconds, UTC.
std::string utc_now(Database& database);

/// needs   `digest` lives until the statement was stepped
void bind_digest(SQLite::Statement& statement, int index, const Digest& digest);
void bind_text(SQLite::Statement& statement, int index, std::string_view text);
/// Nothing where the column is not 32 bytes.
std::optional<Digest> digest_in(const SQLite::Column& column);

}  // namespace hallux::database

/// SQL statements: errors translated once, transactions, digests as blobs. Inside this room only.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "database/records/names.h"
#include "database/store/changed_rows.h"
#include "database/store/connection.h"
#include "database/store/idle_statements.h"
#include "simulator/base/digest.h"

namespace hallux::database {

/// The sentence "could not `tried` in FILE: reason; what to do" with its kind.
/// needs   called where the error was caught, while what the operating system answered is known
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
/// What it changed and accounted for in no act is accounted for in one of the program's own.
template <typename Work>
auto in_transaction(Database& database, std::string_view tried, Work&& work) {
  return translating(database, tried, [&] {
    SQLite::Transaction transaction{database.connection(), SQLite::TransactionBehavior::IMMEDIATE};
    if constexpr (std::is_void_v<std::invoke_result_t<Work>>) {
      std::forward<Work>(work)();
      settle_changes(database);
      transaction.commit();
    } else {
      auto result = std::forward<Work>(work)();
      settle_changes(database);
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

void bind_text(SQLite::Statement& statement, int index, std::string_view text);
/// Nothing where the column is not 32 bytes.
std::optional<Digest> digest_in(const SQLite::Column& column);

/// Binds a number, a text, an id, a digest, bytes or an enumerator's stored name to the parameter
/// after `index`, the parts of a tuple to as many; of an optional that holds nothing, NULL.
template <typename Value>
void bind_next(SQLite::Statement& statement, int& index, const Value& value) {
  if constexpr (requires { value.number; }) {
    statement.bind(++index, value.number);
  } else if constexpr (requires { value.text; }) {
    statement.bind(++index, value.text);
  } else if constexpr (Named<Value>) {
    bind_text(statement, ++index, name_of(value));
  } else if constexpr (std::is_same_v<Value, Digest>) {
    bind_next(statement, index, std::span{value.bytes});
  } else if constexpr (requires { value.has_value(); }) {
    if (value) return bind_next(statement, index, *value);
    statement.bind(++index);
  } else if constexpr (std::is_convertible_v<const Value&, std::string_view>) {
    bind_text(statement, ++index, value);
  } else if constexpr (requires { std::as_bytes(std::span{value}); }) {
    static_assert(sizeof(*value.data()) == 1, "bytes");
    statement.bind(++index, value.data(), static_cast<int>(value.size()));
  } else if constexpr (requires { std::tuple_size<Value>::value; }) {
    std::apply([&](const auto&... parts) { (bind_next(statement, index, parts), ...); }, value);
  } else {
    statement.bind(++index, value);
  }
}

/// Binds copies of `values` in their order.
template <typename... Values>
void bind_all(SQLite::Statement& statement, const Values&... values) {
  [[maybe_unused]] int index = 0;
  (bind_next(statement, index, values), ...);
}

/// Runs a statement that may have run before, with other values.
template <typename... Values>
void run_again(SQLite::Statement& statement, const Values&... values) {
  bind_all(statement, values...);
  statement.exec();
  statement.reset();
}

/// A statement with copies of `values` bound in their order.
/// needs   it names its columns: one that was prepared before a migration does not see new ones
template <typename... Values>
PreparedStatement prepared(Database& database, const std::string& sql, const Values&... values) {
  PreparedStatement statement{database.idle_statements(), sql};
  bind_all(statement, values...);
  return statement;
}

/// Runs a statement that answers with no row; how many rows it changed.
template <typename... Values>
int execute(Database& database, const std::string& sql, const Values&... values) {
  return prepared(database, sql, values...).exec();
}

/// Reads a number, a truth, a text, an id, a digest or an enumerator by its stored name; NULL as
/// nothing where `value` is an optional. A digest that is none is one of zeros, or nothing; a name
/// that is none leaves `value` as it was, or nothing.
template <typename Value>
void read_column(const SQLite::Column& column, Value& value) {
  if constexpr (requires { value.number; }) {
    read_column(column, value.number);
  } else if constexpr (requires { value.text; }) {
    read_column(column, value.text);
  } else if constexpr (std::is_same_v<Value, Digest>) {
    value = digest_in(column).value_or(Digest{});
  } else if constexpr (std::is_same_v<Value, std::optional<Digest>>) {
    value = digest_in(column);
  } else if constexpr (Named<Value>) {
    value = named<Value>(column.getString()).value_or(value);
  } else if constexpr (requires { requires Named<typename Value::value_type>; }) {
    value = named<typename Value::value_type>(column.getString());
  } else if constexpr (requires { value.has_value(); }) {
    value.reset();
    if (!column.isNull()) read_column(column, value.emplace());
  } else if constexpr (std::is_same_v<Value, bool>) {
    value = column.getInt() != 0;
  } else if constexpr (std::is_same_v<Value, std::string>) {
    value = column.getString();
  } else if constexpr (std::is_floating_point_v<Value>) {
    value = column.getDouble();
  } else {
    value = static_cast<Value>(column.getInt64());
  }
}

/// Reads the columns from `first` on into `values`, in their order.
template <typename... Values>
void read_columns(SQLite::Statement& row, int first, Values&... values) {
  (read_column(row.getColumn(first++), values), ...);
}

/// The one value that a statement answers with.
template <typename Value, typename... Values>
Value single(Database& database, const std::string& sql, const Values&... values) {
  auto row = prepared(database, sql, values...);
  row.executeStep();
  Value value{};
  read_column(row.getColumn(0), value);
  return value;
}

/// The one value that a statement answers with; nothing where it answers with no row.
template <typename Value, typename... Values>
std::optional<Value> found(Database& database, const std::string& sql, const Values&... values) {
  auto row = prepared(database, sql, values...);
  if (!row.executeStep()) return std::nullopt;
  Value value{};
  read_column(row.getColumn(0), value);
  return value;
}

/// The first column of all rows.
template <typename Value, typename... Values>
std::vector<Value> all_of(Database& database, const std::string& sql, const Values&... values) {
  auto rows = prepared(database, sql, values...);
  std::vector<Value> read;
  while (rows.executeStep()) read_column(rows.getColumn(0), read.emplace_back());
  return read;
}

/// Of each row its columns as the members of a `Row`, in their order.
template <typename Row, typename... Members>
std::vector<Row> rows_of(SQLite::Statement&& rows, Members Row::*... members) {
  std::vector<Row> found;
  while (rows.executeStep()) {
    Row& row = found.emplace_back();
    read_columns(rows, 0, row.*members...);
  }
  return found;
}

/// What `read` makes of each row.
template <typename Read>
auto collected(SQLite::Statement& rows, Read read) {
  std::vector<std::invoke_result_t<Read, SQLite::Statement&>> found;
  while (rows.executeStep()) found.push_back(read(rows));
  return found;
}

}  // namespace hallux::database

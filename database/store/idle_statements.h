/// Statements of one connection that nobody runs at the moment, kept by their text: to prepare one
/// costs more than to run it, where it looks for one row. Inside this corner only.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>
#include <unordered_map>
#include <utility>

namespace hallux::database {

class IdleStatements {
 public:
  /// needs   the connection outlives it
  explicit IdleStatements(SQLite::Database& connection) : connection_(connection) {}

  /// An idle one of that text, or a new one; nothing is bound to it.
  /// errors  SQLite::Exception
  SQLite::Statement take(const std::string& sql);
  /// Ends its run, unbinds it and keeps it, where there is room.
  void give_back(SQLite::Statement&& statement) noexcept;

 private:
  SQLite::Database& connection_;
  std::unordered_map<std::string, SQLite::Statement> statements_;
};

/// A statement out of these, given back when its owner has done with it.
class PreparedStatement : public SQLite::Statement {
 public:
  PreparedStatement(IdleStatements& home, const std::string& sql)
      : SQLite::Statement(home.take(sql)), home_(&home) {}
  PreparedStatement(PreparedStatement&& other) noexcept
      : SQLite::Statement(std::move(other)), home_(std::exchange(other.home_, nullptr)) {}
  PreparedStatement& operator=(PreparedStatement&&) = delete;
  ~PreparedStatement() {
    if (home_ != nullptr) home_->give_back(std::move(*this));
  }

 private:
  IdleStatements* home_;
};

}  // namespace hallux::database

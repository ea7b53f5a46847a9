#include "database/store/idle_statements.h"

namespace hallux::database {

namespace {

/// More than any job asks in turn.
constexpr std::size_t kept_most = 128;

}  // namespace

SQLite::Statement IdleStatements::take(const std::string& sql) {
  const auto idle = statements_.find(sql);
  if (idle == statements_.end()) return {connection_, sql};
  SQLite::Statement statement = std::move(idle->second);
  statements_.erase(idle);
  return statement;
}

void IdleStatements::give_back(SQLite::Statement&& statement) noexcept {
  try {
    // What a run that failed answers is known already.
    statement.tryReset();
    statement.clearBindings();
    if (statements_.size() >= kept_most) return;
    std::string sql = statement.getQuery();
    statements_.try_emplace(std::move(sql), std::move(statement));
  } catch (const std::exception&) {
    return;  // it is prepared anew
  }
}

}  // namespace hallux::database

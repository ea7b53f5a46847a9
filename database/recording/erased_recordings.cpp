#include "database/recording/erased_recordings.h"

#include "database/audit/audit.h"
#include "database/content/cached_bytes.h"
#include "database/recording/attempts.h"
#include "database/recording/display_facts.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

struct Chain {
  std::optional<Digest> last_link;
  std::int64_t windows = 0, bytes = 0;
};

Chain chain_of(Database& database, std::int64_t attempt) {
  auto sums = prepared(database,
                       "SELECT count(DISTINCT seq), coalesce(sum(length(bytes)), 0) FROM chunk "
                       "WHERE attempt_id = ?",
                       attempt);
  sums.executeStep();
  Chain chain;
  read_columns(sums, 0, chain.windows, chain.bytes);
  chain.last_link = found<Digest>(
      database,
      "SELECT link FROM chunk WHERE attempt_id = ? ORDER BY seq DESC, stream DESC LIMIT 1",
      attempt);
  return chain;
}

void store_erasure(Database& database, std::int64_t attempt, const Chain& chain) {
  execute(database,
          "INSERT INTO erased_recording (attempt_id, last_link, windows, erased_utc) "
          "VALUES (?, ?, ?, ?)",
          attempt, chain.last_link.value_or(Digest{}), chain.windows, utc_now(database));
  execute(database, "DELETE FROM chunk WHERE attempt_id = ?", attempt);
  erase_display_facts(database, attempt);
}

}  // namespace

std::optional<ErasedRecording> erased_recording(Database& database, const AttemptId& id) {
  return translating(database, "look for an erased recording", [&] {
    auto row = prepared(database,
                        "SELECT e.last_link, e.windows, e.erased_utc FROM erased_recording e "
                        "JOIN attempt a USING (attempt_id) WHERE a.uuid = ?",
                        id.text);
    auto erased = rows_of(std::move(row), &ErasedRecording::last_link, &ErasedRecording::windows,
                          &ErasedRecording::erased_utc);
    return erased.empty() ? std::nullopt : std::optional{erased.front()};
  });
}

std::int64_t erase_recording(Database& database, const AttemptId& id,
                             std::optional<PersonId> actor) {
  const AttemptHeader header = load_header(database, id);
  const std::int64_t bytes = in_transaction_of_caller(database, "erase a recording", [&] {
    const AttemptHeader now = load_header(database, header.id);
    if (now.state == AttemptState::Recording) {
      throw DatabaseError{
          DatabaseErrorKind::Refused,
          "attempt " + now.id.text + " is being recorded; erase its recording when it has ended"};
    }
    if (erased_recording(database, now.id)) return std::int64_t{0};
    const Chain chain = chain_of(database, now.order);
    store_erasure(database, now.order, chain);
    append_audit(database, {actor, "recording_erased", "attempt", now.id.text});
    return chain.bytes;
  });
  drop_cached(database.directory(), header.id.text + ".fields");
  return bytes;
}

}  // namespace hallux::database

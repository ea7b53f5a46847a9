#include "database/maintenance/verify.h"

#include <vector>

#include "database/content/assets.h"
#include "database/course/decisions.h"
#include "database/course/standings.h"
#include "database/exchange/import_attempt.h"
#include "database/maintenance/verify_audit.h"
#include "database/maintenance/verify_pages.h"
#include "database/maintenance/verify_progress.h"
#include "database/maintenance/verify_rows.h"
#include "database/maintenance/verify_scores.h"
#include "database/recording/attempts.h"
#include "database/recording/certificate_json.h"
#include "database/recording/recordings.h"
#include "database/store/sql.h"
#include "simulator/base/progress.h"

namespace hallux::database {

namespace {

constexpr std::int64_t attempts_at_once = 256;

std::int64_t count_in(Database& database, const std::string& table) {
  return single<std::int64_t>(database, "SELECT count(*) FROM " + table);
}

void check_contents(Database& database, VerifyProgress& progress, Verification& found) {
  progress.begin("the bones and scenarios", 0.2);
  translating(database, "check the assets and scenarios", [&] {
    const std::int64_t count = count_in(database, "asset");
    SQLite::Statement next{
        database.connection(),
        "SELECT asset_id, digest FROM asset WHERE asset_id > ? ORDER BY asset_id LIMIT 1"};
    for (std::int64_t last = 0;;) {
      next.bind(1, last);
      if (!next.executeStep()) break;
      last = next.getColumn(0).getInt64();
      const auto digest = digest_in(next.getColumn(1));
      next.reset();
      if (!digest) fail_altered(database, "asset " + std::to_string(last));
      get_asset(database, *digest);
      progress.tell(++found.assets, count);
    }
    for (const auto version :
         all_of<ScenarioVersionId>(database, "SELECT scenario_version_id FROM scenario_version")) {
      get_scenario_version(database, version);
    }
  });
}

/// The facts that lists and limits go by must be those that were sealed.
void check_standing_of(const Database& database, const AttemptHeader& header) {
  const bool is_sealed = header.seal.has_value();
  const bool has_fitting_state =
      header.state == AttemptState::Void || is_sealed == (header.state == AttemptState::Closed);
  if (!has_fitting_state) fail_altered(database, "the state of attempt " + header.id.text);
  const std::optional<bool> expected =
      is_sealed ? std::optional{is_valid_by(header.quality_json)} : std::nullopt;
  if (header.is_valid != expected) {
    fail_altered(database, "whether attempt " + header.id.text + " is valid");
  }
}

using NumberedAttempt = std::pair<std::int64_t, AttemptId>;

std::vector<NumberedAttempt> attempts_after(Database& database, std::int64_t last) {
  auto rows = prepared(database,
                       "SELECT attempt_id, uuid FROM attempt WHERE attempt_id > ? "
                       "ORDER BY attempt_id LIMIT ?",
                       last, attempts_at_once);
  return rows_of(std::move(rows), &NumberedAttempt::first, &NumberedAttempt::second);
}

/// A row under a name that no program gives was not written by one.
AttemptHeader header_of(Database& database, const AttemptId& id) {
  try {
    return load_header(database, id);
  } catch (const DatabaseError& error) {
    if (error.kind() != DatabaseErrorKind::NotFound) throw;
    fail_altered(database, "the uuid of attempt " + id.text);
  }
}

void check_attempts(Database& database, VerifyProgress& progress, Verification& found) {
  progress.begin("the attempts", 0.8);
  const auto next = [&database](std::int64_t last) {
    return translating(database, "list the attempts",
                       [&] { return attempts_after(database, last); });
  };
  const std::int64_t count =
      translating(database, "count the attempts", [&] { return count_in(database, "attempt"); });
  RecordingCheck recordings{database};
  for (auto some = next(0); !some.empty(); some = next(some.back().first)) {
    for (const auto& [order, id] : some) {
      const AttemptHeader header = header_of(database, id);
      found.chunks += recordings.check(header);
      check_standing_of(database, header);
      progress.tell(++found.attempts, count);
    }
  }
}

}  // namespace

Verification verify(Database& database, const Progress& progress) {
  Verification found;
  VerifyProgress told{progress};
  try {
    check_pages(database, told);
    check_contents(database, told, found);
    check_attempts(database, told, found);
    check_scores(database, told, found);
    check_measurements(database, told);
    check_decisions_are_whole(database);
    check_audit(database, told, found);
    check_standings(database);
    check_schema(database);
    check_rows(database, told, found);
  } catch (const DatabaseError& error) {
    if (error.kind() != DatabaseErrorKind::Damaged) throw;
    found.first_damage = error.what();
  }
  return found;
}

}  // namespace hallux::database

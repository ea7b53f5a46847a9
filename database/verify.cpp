#include "database/verify.h"

#include <vector>

#include "database/assets.h"
#include "database/attempts.h"
#include "database/audit.h"
#include "database/chain.h"
#include "database/decisions.h"
#include "database/recordings.h"
#include "database/sql.h"

namespace hallux::database {

namespace {

[[noreturn]] void fail_altered(const Database& database, const std::string& row) {
  throw DatabaseError{DatabaseErrorKind::Damaged,
                      row + " in " + database.file().string() + " was altered; restore a backup"};
}

void check_pages(Database& database) {
  translating(database, "check the pages", [&] {
    SQLite::Statement pages{database.connection(), "PRAGMA integrity_check(1)"};
    pages.executeStep();
    const std::string answer = pages.getColumn(0).getString();
    if (answer != "ok") fail_altered(database, "a page (" + answer + ")");
    SQLite::Statement keys{database.connection(), "PRAGMA foreign_key_check"};
    if (!keys.executeStep()) return;
    fail_altered(database, "row " + std::to_string(keys.getColumn(1).getInt64()) + " of table " +
                               keys.getColumn(0).getString() + ", which names a missing row,");
  });
}

std::optional<std::string> text_in(Database& database, const char* query, const std::string& key) {
  SQLite::Statement row{database.connection(), query};
  row.bind(1, key);
  if (!row.executeStep()) return std::nullopt;
  return row.getColumn(0).getString();
}

/// What the audit says was stored must still be so.
void check_against_audit(Database& database, const AuditRow& row) {
  const AuditEntry& entry = row.entry;
  if (entry.action == "score_stored") {
    const auto json =
        text_in(database, "SELECT card_json FROM score WHERE score_id = ?", entry.subject_id);
    if (!json || digest_of(std::as_bytes(std::span{json->data(), json->size()})) != entry.detail) {
      fail_altered(database, "score " + entry.subject_id);
    }
  }
  if (entry.subject_kind == "decision") check_decision(database, entry);
  if (entry.subject_kind != "attempt") return;
  const auto attempt = [&] {
    try {
      return load_header(database, {entry.subject_id});
    } catch (const DatabaseError&) {
      fail_altered(database, "attempt " + entry.subject_id + ", which is missing,");
    }
  }();
  if (entry.action == "attempt_sealed" && attempt.seal != entry.detail) {
    fail_altered(database, "the seal of attempt " + entry.subject_id);
  }
  if (entry.action == "attempt_begun" && attempt.begun.person != entry.actor) {
    fail_altered(database, "the person of attempt " + entry.subject_id);
  }
  if (entry.action == "attempt_begun" &&
      purpose_digest(attempt.begun.kind, attempt.is_simulated, attempt.begun.guidance) !=
          entry.detail.value_or(
              purpose_digest(AttemptKind::Practice, false, simulator::Guidance::None))) {
    fail_altered(database, "what attempt " + entry.subject_id + " was for");
  }
}

void check_scores(Database& database, Verification& found) {
  translating(database, "check the scores", [&] {
    SQLite::Statement rows{database.connection(),
                           "SELECT score_id, score_milli <> json_extract(card_json, "
                           "'$.score_milli') FROM score ORDER BY score_id"};
    while (rows.executeStep()) {
      if (rows.getColumn(1).getInt() != 0) {
        fail_altered(database, "score " + rows.getColumn(0).getString());
      }
      ++found.scores;
    }
  });
}

void check_contents(Database& database, Verification& found) {
  translating(database, "check the assets and scenarios", [&] {
    SQLite::Statement assets{database.connection(), "SELECT asset_id, digest FROM asset"};
    while (assets.executeStep()) {
      const auto digest = digest_in(assets.getColumn(1));
      if (!digest) fail_altered(database, "asset " + assets.getColumn(0).getString());
      get_asset(database, *digest);
      ++found.assets;
    }
    SQLite::Statement versions{database.connection(),
                               "SELECT scenario_version_id FROM scenario_version"};
    while (versions.executeStep()) {
      get_scenario_version(database, {versions.getColumn(0).getInt64()});
    }
  });
}

void check_attempts(Database& database, const std::function<bool(double)>& progress,
                    Verification& found) {
  const std::vector<AttemptHeader> headers = list_attempts(database);
  for (const AttemptHeader& header : headers) {
    found.chunks += check_recording(database, header.id);
    ++found.attempts;
    const double part = static_cast<double>(found.attempts) / static_cast<double>(headers.size());
    if (progress && !progress(part)) {
      throw VerificationStopped{"the check was stopped after attempt " + header.id.text +
                                "; no damage was found up to there"};
    }
  }
}

}  // namespace

Verification verify(Database& database, const std::function<bool(double)>& progress) {
  Verification found;
  try {
    check_pages(database);
    check_contents(database, found);
    check_attempts(database, progress, found);
    check_scores(database, found);
    check_decisions_are_whole(database);
    for (const AuditRow& row : read_audit(database)) {
      check_against_audit(database, row);
      ++found.audit_rows;
    }
  } catch (const DatabaseError& error) {
    if (error.kind() != DatabaseErrorKind::Damaged) throw;
    found.first_damage = error.what();
  }
  return found;
}

}  // namespace hallux::database

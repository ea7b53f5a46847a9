#include "database/maintenance/verify_audit.h"

#include "database/audit/audit.h"
#include "database/course/decisions.h"
#include "database/course/scores.h"
#include "database/exchange/import_attempt.h"
#include "database/recording/attempts.h"
#include "database/recording/chain.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

/// Rows of before this moment were written by a program that told the audit less.
std::string schema_4_since(Database& database) {
  if (auto since = found<std::string>(database, "SELECT made_utc FROM directory")) return *since;
  fail_altered(database, "the identity of the directory, which is missing,");
}

void check_score(Database& database, const AuditRow& row, const std::string& since) {
  const AuditEntry& entry = row.entry;
  auto score = prepared(database,
                        "SELECT s.card_json, a.uuid FROM score s JOIN attempt a "
                        "USING (attempt_id) WHERE s.score_id = ?",
                        entry.subject_id);
  if (!score.executeStep()) {
    fail_altered(database, "score " + entry.subject_id + ", which is missing,");
  }
  const std::string json = score.getColumn(0).getString();
  const bool is_older = row.at_utc < since;
  const bool is_same =
      score_digest(json, {score.getColumn(1).getString()}) == entry.detail ||
      (is_older && digest_of(std::as_bytes(std::span{json.data(), json.size()})) == entry.detail);
  if (!is_same) fail_altered(database, "score " + entry.subject_id);
}

void check_attempt(Database& database, const AuditEntry& entry) {
  const auto attempt = [&] {
    try {
      return load_header(database, {entry.subject_id});
    } catch (const DatabaseError& error) {
      if (error.kind() != DatabaseErrorKind::NotFound) throw;
      fail_altered(database, "attempt " + entry.subject_id + ", which is missing,");
    }
  }();
  if (entry.action == "attempt_imported") check_imported(database, entry);
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

/// What the audit says was stored must still be so.
void check_against_audit(Database& database, const AuditRow& row, const std::string& since) {
  const AuditEntry& entry = row.entry;
  if (entry.was_refused) return;
  if (entry.action == "score_stored") check_score(database, row, since);
  if (entry.subject_kind == "decision") check_decision(database, entry);
  if (entry.action == "attempt_imported") check_imported(database, entry);
  if (entry.subject_kind == "attempt") check_attempt(database, entry);
}

/// A query that answers with a row only where somebody wrote past the audit; `is_named` says which
/// row it is.
struct Unexplained {
  const char* sql;
  const char* is_named;
};

/// Each in one statement, so that whoever works meanwhile is seen with the audit row or without
/// both, and with lists that are made once: the audit has no index by subject. An imported attempt
/// was begun and sealed elsewhere.
constexpr Unexplained unexplained[] = {
    {"SELECT uuid FROM attempt WHERE origin_id IS NULL AND uuid NOT IN "
     "(SELECT subject_id FROM audit WHERE action = 'attempt_begun' AND outcome = 'done') LIMIT 1",
     "the beginning of attempt "},
    {"SELECT uuid FROM attempt WHERE origin_id IS NULL AND seal IS NOT NULL AND uuid NOT IN "
     "(SELECT subject_id FROM audit WHERE action = 'attempt_sealed' AND outcome = 'done') LIMIT 1",
     "the sealing of attempt "},
    {"SELECT uuid FROM attempt WHERE origin_id IS NOT NULL AND uuid NOT IN (SELECT subject_id FROM "
     "audit WHERE action = 'attempt_imported' AND outcome = 'done') LIMIT 1",
     "the import of attempt "},
    {"SELECT uuid FROM erased_recording JOIN attempt USING (attempt_id) WHERE uuid NOT IN (SELECT "
     "subject_id FROM audit WHERE action = 'recording_erased' AND outcome = 'done') LIMIT 1",
     "the erasing of the recording of attempt "},
    {"SELECT score_id FROM score WHERE CAST(score_id AS TEXT) NOT IN "
     "(SELECT subject_id FROM audit WHERE action = 'score_stored' AND outcome = 'done') LIMIT 1",
     "the list of scores with score "},
    {"SELECT p.person_id FROM person p CROSS JOIN directory d LEFT JOIN "
     "(SELECT CAST(subject_id AS INTEGER) AS person_id, action, at_utc, max(audit_id) FROM audit "
     "WHERE subject_kind = 'person' AND outcome = 'done' AND action IN "
     "('first_administrator_added', 'administrator_made', 'administrator_unmade', 'person_added') "
     "GROUP BY subject_id) u ON u.person_id = p.person_id "
     "WHERE p.is_administrator <> (coalesce(u.action, '') IN "
     "('first_administrator_added', 'administrator_made')) "
     // An older program did not tell whether somebody was added as an administrator.
     "AND NOT (coalesce(u.action, 'person_added') = 'person_added' "
     "AND coalesce(u.at_utc, p.created_utc) < d.made_utc) LIMIT 1",
     "whether somebody is an administrator, of person "}};

void check_nothing_is_unexplained(Database& database) {
  for (const Unexplained& kind : unexplained) {
    const auto name = found<std::string>(database, kind.sql);
    if (name) fail_altered(database, kind.is_named + *name);
  }
}

}  // namespace

void check_audit(Database& database, VerifyProgress& progress, Verification& found) {
  progress.begin("the audit", 0.95);
  std::string since;
  std::int64_t all = 0;
  translating(database, "look at the audit", [&] {
    since = schema_4_since(database);
    all = single<std::int64_t>(database, "SELECT coalesce(max(audit_id), 0) FROM audit");
  });
  walk_audit(database, [&](const AuditRow& row) {
    check_against_audit(database, row, since);
    ++found.audit_rows;
    if (found.audit_rows % 256 == 0) progress.tell(found.audit_rows, all);
  });
  translating(database, "compare with the audit", [&] { check_nothing_is_unexplained(database); });
  progress.tell(1, 1);
}

}  // namespace hallux::database

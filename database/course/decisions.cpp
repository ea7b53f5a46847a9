#include "database/course/decisions.h"

#include "database/course/in_force.h"
#include "database/recording/attempts.h"
#include "database/store/sql.h"
#include "database/text/free_text.h"

namespace hallux::database {

namespace {

constexpr std::int64_t score_milli_max = 100'000;

/// The numbers of a decision as its audit row names them.
constexpr const char* numbers_of_decision =
    "r.decision_id || '/' || a.uuid || '/' || coalesce(r.score_id, 0) || '/' || "
    "coalesce(r.score_milli, -1)";

[[noreturn]] void refuse(const std::string& sentence) {
  throw DatabaseError{DatabaseErrorKind::BadInput, sentence};
}

[[noreturn]] void fail_altered(const Database& database, const std::string& row) {
  throw DatabaseError{DatabaseErrorKind::Damaged,
                      row + " in " + database.file().string() + " was altered; restore a backup"};
}

void check_decidable(const AttemptHeader& header, const NewDecision& decision) {
  check_free_text("the reason", decision.reason);
  if (header.state == AttemptState::Recording) {
    refuse("attempt " + header.id.text + " is still being recorded; decide when it has ended");
  }
  if (decision.kind == DecisionKind::Voided) return;
  if (!header.seal || !header.score_milli) {
    refuse("attempt " + header.id.text +
           " was interrupted or has no score; it can only be voided, or scored first");
  }
  if (decision.kind == DecisionKind::Overridden &&
      (decision.score_milli < 0 || decision.score_milli > score_milli_max)) {
    refuse("a score lies between 0 and 100; choose one in between");
  }
}

std::int64_t insert_decision(Database& database, const AttemptHeader& header,
                             const NewDecision& decision, PersonId by) {
  std::optional<std::int64_t> score_milli;
  if (decision.kind == DecisionKind::Confirmed) score_milli = header.score_milli.value();
  if (decision.kind == DecisionKind::Overridden) score_milli = decision.score_milli;
  execute(
      database,
      "INSERT INTO decision (attempt_id, kind, score_id, score_milli, reason, "
      "decided_by_person_id, decided_utc) SELECT a.attempt_id, ?, s.score_id, ?, ?, ?, ? "
      "FROM attempt a LEFT JOIN score s ON s.attempt_id = a.attempt_id AND s.superseded_by IS NULL "
      "WHERE a.uuid = ?",
      name_of(decision.kind), score_milli, decision.reason, by, utc_now(database), header.id);
  return database.connection().getLastInsertRowid();
}

void set_state(Database& database, const AttemptHeader& header, DecisionKind kind) {
  const AttemptState unvoided = header.seal ? AttemptState::Closed : AttemptState::Interrupted;
  execute(database, "UPDATE attempt SET state = ? WHERE uuid = ?",
          name_of(kind == DecisionKind::Voided ? AttemptState::Void : unvoided), header.id.text);
}

std::string audit_subject(Database& database, DecisionId id) {
  return single<std::string>(database,
                             std::string{"SELECT "} + numbers_of_decision +
                                 " FROM decision r JOIN attempt a USING (attempt_id) "
                                 "WHERE r.decision_id = ?",
                             id.number);
}

}  // namespace

DecisionId decide(Database& database, const NewDecision& decision, PersonId by) {
  return in_transaction_of_caller(database, "decide about a result", [&] {
    const AttemptHeader header = load_header(database, decision.attempt);
    check_decidable(header, decision);
    const DecisionId id{put_in_force(database, "decision", header.id, [&] {
      return insert_decision(database, header, decision, by);
    })};
    set_state(database, header, decision.kind);
    const std::string action = "result_" + std::string{name_of(decision.kind)};
    append_audit(database, {by, action, "decision", audit_subject(database, id), false,
                            std::nullopt, decision.reason});
    return id;
  });
}

std::vector<Decision> load_decisions(Database& database, const AttemptId& attempt) {
  return translating(database, "read the decisions about attempt " + attempt.text, [&] {
    auto rows = prepared(
        database,
        "SELECT r.decision_id, a.uuid, r.kind, r.score_id, r.score_milli, r.reason, "
        "coalesce(d.display_name, ''), r.decided_utc, r.superseded_by IS NULL FROM decision r "
        "JOIN attempt a USING (attempt_id) "
        "LEFT JOIN person_detail d ON d.person_id = r.decided_by_person_id "
        "WHERE a.uuid = ? ORDER BY r.decision_id DESC",
        attempt.text);
    return rows_of(std::move(rows), &Decision::id, &Decision::attempt, &Decision::kind,
                   &Decision::about, &Decision::score_milli, &Decision::reason,
                   &Decision::decided_by, &Decision::decided_utc, &Decision::is_in_force);
  });
}

void check_decision(Database& database, const AuditEntry& entry) {
  const std::string number = entry.subject_id.substr(0, entry.subject_id.find('/'));
  auto row = prepared(database,
                      std::string{"SELECT "} + numbers_of_decision +
                          ", 'result_' || r.kind, r.reason, r.decided_by_person_id "
                          "FROM decision r JOIN attempt a USING (attempt_id) "
                          "WHERE r.decision_id = ?",
                      number);
  const bool is_same = row.executeStep() && row.getColumn(0).getString() == entry.subject_id &&
                       row.getColumn(1).getString() == entry.action &&
                       (entry.text.empty() || row.getColumn(2).getString() == entry.text) &&
                       entry.actor == PersonId{row.getColumn(3).getInt64()};
  if (!is_same) fail_altered(database, "decision " + number);
}

void check_decisions_are_whole(Database& database) {
  translating(database, "check the decisions", [&] {
    auto rows = prepared(
        database,
        "SELECT r.decision_id FROM decision r JOIN attempt a USING (attempt_id) WHERE "
        "(r.superseded_by IS NULL) <> (r.decision_id = (SELECT max(decision_id) FROM decision o "
        "WHERE o.attempt_id = r.attempt_id)) "
        "OR (r.superseded_by IS NULL AND (r.kind = 'voided') <> (a.state = 'void')) LIMIT 1");
    if (rows.executeStep()) fail_altered(database, "decision " + rows.getColumn(0).getString());
    // Each row of the audit is checked against the decision it names; as many of both leave none
    // without.
    if (single<bool>(database,
                     "SELECT (SELECT count(*) FROM decision) <> (SELECT count(*) FROM audit "
                     "WHERE subject_kind = 'decision')")) {
      fail_altered(database, "the list of decisions");
    }
    const auto undecided =
        found<std::string>(database,
                           "SELECT uuid FROM attempt a WHERE state = 'void' AND NOT EXISTS "
                           "(SELECT 1 FROM decision r WHERE r.attempt_id = a.attempt_id) LIMIT 1");
    if (undecided) fail_altered(database, "the state of attempt " + *undecided);
  });
}

}  // namespace hallux::database

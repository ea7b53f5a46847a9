#include "database/course/scores.h"

#include "database/audit/audit.h"
#include "database/course/in_force.h"
#include "database/course/score_json.h"
#include "database/recording/attempts.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

std::int64_t insert_score(Database& database, const AttemptId& attempt, const ScoreCard& card,
                          const std::string& json) {
  // Kept beside the card, so that whether a result passes is known without reading it.
  const PassFacts facts = pass_facts_of(card);
  execute(database,
          "INSERT INTO score (attempt_id, scenario_version, rubric_version, engine_version, "
          "score_milli, measured_weight_milli, card_json, stored_utc, rubric_milli, is_gated, "
          "safety_measured_milli, safety_earned_milli) "
          "SELECT attempt_id, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ? FROM attempt WHERE uuid = ?",
          card.scenario_version, card.rubric_version, card.engine, card.score_milli,
          card.measured_milli, json, utc_now(database), facts.rubric_milli, facts.is_gated,
          facts.safety_measured_milli, facts.safety_earned_milli, attempt);
  return database.connection().getLastInsertRowid();
}

/// In the caller's transaction.
ScoreId put_score(Database& database, const AttemptId& attempt, const ScoreCard& card,
                  std::optional<PersonId> actor) {
  const std::string json = json_from_card(card);
  const std::int64_t number = put_in_force(
      database, "score", attempt, [&] { return insert_score(database, attempt, card, json); });
  append_audit(database, {actor, "score_stored", "score", std::to_string(number), false,
                          score_digest(json, attempt), ""});
  return ScoreId{number};
}

/// Stores the card unless the one in force is `as_good`.
template <typename IsAsGood>
ScoreId store_unless(Database& database, const AttemptId& attempt, const ScoreCard& card,
                     std::optional<PersonId> actor, IsAsGood is_as_good) {
  const AttemptHeader header = load_header(database, attempt);
  return in_transaction_of_caller(database, "store the score of attempt " + header.id.text, [&] {
    const std::optional<StoredScore> in_force = load_score(database, header.id);
    if (in_force && is_as_good(in_force->card)) return in_force->id;
    return put_score(database, header.id, card, actor);
  });
}

}  // namespace

Digest score_digest(std::string_view card_json, const AttemptId& attempt) noexcept {
  Digester digester;
  digester.add_text(card_json);
  digester.add_text(attempt.text);
  return digester.finish();
}

ScoreId store_score(Database& database, const AttemptId& attempt, const ScoreCard& card,
                    std::optional<PersonId> actor) {
  return store_unless(database, attempt, card, actor,
                      [&](const ScoreCard& in_force) { return is_same_score(in_force, card); });
}

ScoreId store_score_as_it_was(Database& database, const AttemptId& attempt, const ScoreCard& card,
                              std::optional<PersonId> actor) {
  return store_unless(database, attempt, card, actor, [&](const ScoreCard& in_force) {
    return json_from_card(in_force) == json_from_card(card);
  });
}

std::optional<StoredScore> load_score(Database& database, const AttemptId& attempt) {
  const AttemptHeader header = load_header(database, attempt);
  return translating(database, "read the score of attempt " + header.id.text,
                     [&]() -> std::optional<StoredScore> {
                       auto row = prepared(database,
                                           "SELECT score_id, stored_utc, card_json FROM score JOIN "
                                           "attempt USING (attempt_id) WHERE uuid = ? AND "
                                           "superseded_by IS NULL",
                                           header.id.text);
                       if (!row.executeStep()) return std::nullopt;
                       StoredScore score;
                       std::string json;
                       read_columns(row, 0, score.id, score.stored_utc, json);
                       score.card = card_from_json(json);
                       return score;
                     });
}

}  // namespace hallux::database

#include "database/maintenance/verify_scores.h"

#include <vector>

#include "database/course/measurements.h"
#include "database/course/score_json.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr std::int64_t scores_at_once = 500;

struct ScoreRow {
  std::int64_t number = 0;
  std::vector<std::int64_t> columns;
  std::string card_json;
};

std::vector<ScoreRow> scores_after(Database& database, std::int64_t last) {
  auto rows =
      prepared(database,
               "SELECT score_id, card_json, score_milli, measured_weight_milli, scenario_version, "
               "rubric_version, engine_version, rubric_milli, is_gated, safety_measured_milli, "
               "safety_earned_milli FROM score WHERE score_id > ? ORDER BY score_id LIMIT ?",
               last, scores_at_once);
  std::vector<ScoreRow> found;
  while (rows.executeStep()) {
    ScoreRow row{rows.getColumn(0).getInt64(), {}, rows.getColumn(1).getString()};
    for (int i = 2; i < rows.getColumnCount(); ++i) {
      row.columns.push_back(rows.getColumn(i).getInt64());
    }
    found.push_back(std::move(row));
  }
  return found;
}

/// What stands beside a card, in the order of the columns above.
std::vector<std::int64_t> columns_of(const ScoreCard& card) {
  const PassFacts facts = pass_facts_of(card);
  return {card.score_milli,
          card.measured_milli,
          card.scenario_version,
          card.rubric_version,
          card.engine,
          facts.rubric_milli,
          facts.is_gated ? 1 : 0,
          facts.safety_measured_milli,
          facts.safety_earned_milli};
}

bool is_as_its_card(const ScoreRow& row) {
  try {
    return columns_of(card_from_json(row.card_json)) == row.columns;
  } catch (const DatabaseError&) {
    return false;
  }
}

struct StoredSet {
  std::int64_t number = 0;
  MeasurementKey key;
  Digest digest;
};

std::vector<StoredSet> sets_after(Database& database, std::int64_t last) {
  auto rows = prepared(database,
                       "SELECT m.measurement_set_id, a.uuid, m.seal, m.plan_digest, "
                       "m.metrics_version, m.digest FROM measurement_set m JOIN attempt a "
                       "USING (attempt_id) WHERE m.measurement_set_id > ? "
                       "ORDER BY m.measurement_set_id LIMIT ?",
                       last, scores_at_once);
  return collected(rows, [](SQLite::Statement& row) {
    StoredSet set;
    read_columns(row, 0, set.number, set.key.attempt, set.key.seal, set.key.by.plan,
                 set.key.by.metrics_version, set.digest);
    return set;
  });
}

/// A row that is none, and lines that do not count up from 0, are no rows of a program.
bool has_rows_of(Database& database, const StoredSet& set) {
  const auto is_counted = single<bool>(
      database,
      "SELECT coalesce(max(line) + 1, 0) = count(*) FROM measurement WHERE measurement_set_id = ?",
      set.number);
  try {
    return is_counted &&
           measurements_digest(set.key, load_measurement_rows(database, set.number)) == set.digest;
  } catch (const DatabaseError& error) {
    if (error.kind() != DatabaseErrorKind::Damaged) throw;
    return false;
  }
}

}  // namespace

void check_measurements(Database& database, VerifyProgress& progress) {
  progress.begin("the measurements", 0.92);
  translating(database, "check the measurements", [&] {
    const auto all = single<std::int64_t>(database, "SELECT count(*) FROM measurement_set");
    std::int64_t done = 0;
    for (auto some = sets_after(database, 0); !some.empty();
         some = sets_after(database, some.back().number)) {
      for (const StoredSet& set : some) {
        if (!has_rows_of(database, set))
          fail_altered(database, "a measurement of set " + std::to_string(set.number));
        progress.tell(++done, all);
      }
    }
    const auto stray = all_of<std::string>(
        database,
        "SELECT measurement_set_id FROM measurement WHERE measurement_set_id NOT IN "
        "(SELECT measurement_set_id FROM measurement_set) LIMIT 1");
    if (!stray.empty()) fail_altered(database, "a measurement of set " + stray.front());
  });
}

void check_scores(Database& database, VerifyProgress& progress, Verification& found) {
  progress.begin("the scores", 0.9);
  translating(database, "check the scores", [&] {
    const auto all = single<std::int64_t>(database, "SELECT count(*) FROM score");
    for (auto some = scores_after(database, 0); !some.empty();
         some = scores_after(database, some.back().number)) {
      for (const ScoreRow& row : some) {
        if (!is_as_its_card(row)) fail_altered(database, "score " + std::to_string(row.number));
      }
      found.scores += static_cast<std::int64_t>(some.size());
      progress.tell(found.scores, all);
    }
    const auto out_of_turn = all_of<std::string>(
        database,
        "SELECT score_id FROM score s WHERE (superseded_by IS NULL) <> (score_id = "
        "(SELECT max(score_id) FROM score o WHERE o.attempt_id = s.attempt_id)) LIMIT 1");
    if (!out_of_turn.empty()) {
      fail_altered(database, "the order of score " + out_of_turn.front());
    }
  });
}

}  // namespace hallux::database

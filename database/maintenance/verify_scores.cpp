#include "database/maintenance/verify_scores.h"

#include <vector>

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

}  // namespace

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

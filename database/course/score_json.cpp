#include "database/course/score_json.h"

#include "database/store/database_error.h"
#include "database/text/json_record.h"

namespace hallux::database {

template <>
inline constexpr std::tuple fields_of<LedgerLine>{
    Field{"kind", &LedgerLine::kind},
    Field{"item", &LedgerLine::item},
    Field{"metric", &LedgerLine::metric},
    Field{"group", &LedgerLine::group},
    Field{"unit", &LedgerLine::unit},
    Field{"value", &LedgerLine::value},
    Field{"is_measured", &LedgerLine::is_measured},
    Field{"target", &LedgerLine::target},
    Field{"weight_milli", &LedgerLine::weight_milli},
    Field{"points_lost_milli", &LedgerLine::points_lost_milli},
    Field{"start_us", &LedgerLine::start_us},
    Field{"end_us", &LedgerLine::end_us},
    Field{"place_in_bone_mm", &LedgerLine::place_in_bone_mm},
    Field{"text", &LedgerLine::text}};

template <>
inline constexpr std::tuple fields_of<GroupScore>{
    Field{"name", &GroupScore::name}, Field{"weight_milli", &GroupScore::weight_milli},
    Field{"measured_milli", &GroupScore::measured_milli},
    Field{"earned_milli", &GroupScore::earned_milli}};

template <>
inline constexpr std::tuple fields_of<GateResult>{Field{"name", &GateResult::name},
                                                  Field{"cap_milli", &GateResult::cap_milli},
                                                  Field{"is_triggered", &GateResult::is_triggered},
                                                  Field{"value", &GateResult::value},
                                                  Field{"limit", &GateResult::limit},
                                                  Field{"unit", &GateResult::unit},
                                                  Field{"text", &GateResult::text}};

template <>
inline constexpr std::tuple fields_of<ScoreCard>{
    Field{"score_milli", &ScoreCard::score_milli},
    Field{"earned_milli", &ScoreCard::earned_milli},
    Field{"measured_milli", &ScoreCard::measured_milli},
    Field{"rubric_milli", &ScoreCard::rubric_milli},
    Field{"groups", &ScoreCard::groups},
    Field{"gates", &ScoreCard::gates},
    Field{"ledger", &ScoreCard::ledger},
    Field{"shown_losses_milli", &ScoreCard::shown_losses_milli},
    Field{"sentences", &ScoreCard::sentences},
    Field{"scenario", &ScoreCard::scenario},
    Field{"scenario_version", &ScoreCard::scenario_version},
    Field{"rubric_version", &ScoreCard::rubric_version},
    Field{"engine", &ScoreCard::engine},
    Field{"is_reviewed", &ScoreCard::is_reviewed}};

std::string json_from_card(const ScoreCard& card) { return json_of(card).dump(); }

namespace {

ScoreCard without_words(ScoreCard card) {
  for (LedgerLine& line : card.ledger) line.text.clear();
  for (GateResult& gate : card.gates) gate.text.clear();
  card.sentences.clear();
  card.is_reviewed = false;
  return card;
}

}  // namespace

bool is_same_score(const ScoreCard& one, const ScoreCard& other) {
  return json_from_card(without_words(one)) == json_from_card(without_words(other));
}

ScoreCard card_from_json(std::string_view json) {
  /// A card of the greatest shipped rubric has 20 KB.
  constexpr JsonBounds bounds{std::size_t{4} << 20U, 6};
  try {
    ScoreCard card;
    read_json(parse_json("it", json, bounds), "it", card);
    return card;
  } catch (const DatabaseError& error) {
    throw DatabaseError{DatabaseErrorKind::Damaged,
                        std::string{"a score card cannot be read: "} + error.what()};
  }
}

}  // namespace hallux::database

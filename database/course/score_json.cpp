#include "database/course/score_json.h"

#include <algorithm>

#include "database/course/detail_json.h"
#include "database/store/database_error.h"
#include "database/text/json_record.h"

namespace hallux::database {

template <>
inline constexpr std::tuple fields_of<LineFacts>{Field{"title", &LineFacts::title},
                                                 Field{"subject", &LineFacts::subject},
                                                 Field{"target", &LineFacts::target},
                                                 Field{"target_low", &LineFacts::target_low},
                                                 Field{"target_high", &LineFacts::target_high},
                                                 Field{"absence", &LineFacts::absence},
                                                 Field{"done_fraction", &LineFacts::done_fraction},
                                                 Field{"direction", &LineFacts::direction},
                                                 Field{"detail", &LineFacts::detail},
                                                 Field{"remark", &LineFacts::remark}};

template <>
inline constexpr std::tuple fields_of<Message>{
    Field{"kind", &Message::kind}, Field{"line", &Message::line},
    Field{"subject", &Message::subject}, Field{"done_fraction", &Message::done_fraction},
    Field{"lost_milli", &Message::lost_milli}};

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
    Field{"facts", &LedgerLine::facts},
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
                                                  Field{"title", &GateResult::title},
                                                  Field{"metric", &GateResult::metric},
                                                  Field{"is_measured", &GateResult::is_measured},
                                                  Field{"is_at_least", &GateResult::is_at_least},
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
    Field{"messages", &ScoreCard::messages},
    Field{"sentences", &ScoreCard::sentences},
    Field{"scenario", &ScoreCard::scenario},
    Field{"scenario_version", &ScoreCard::scenario_version},
    Field{"rubric_version", &ScoreCard::rubric_version},
    Field{"engine", &ScoreCard::engine},
    Field{"is_reviewed", &ScoreCard::is_reviewed},
    Field{"form", &ScoreCard::form}};

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// What a card has in one of its forms and not in the other, with what stands for it there.
struct FormFields {
  json of_card, of_line, of_gate;
};

FormFields fields_only_in(CardForm form) {
  if (form == CardForm::Words)
    return {{{"sentences", json::array()}}, {{"text", ""}}, {{"text", ""}}};
  return {{{"messages", json::array()}, {"form", name_of(CardForm::Words)}},
          {{"facts", json::parse(json_of(LineFacts{}).dump())}},
          {{"title", ""}, {"metric", ""}, {"is_measured", false}, {"is_at_least", false}}};
}

/// Shows the card, each line and each gate with the fields that are theirs.
template <typename Json, typename Visit>
void visit_parts(Json& card, const FormFields& fields, Visit visit) {
  visit(card, fields.of_card);
  for (auto& line : card["ledger"]) visit(line, fields.of_line);
  for (auto& gate : card["gates"]) visit(gate, fields.of_gate);
}

/// Whether the parts can be walked; what is wrong with others is said as they are read.
bool has_parts(const json& card) {
  const auto is_list = [&](const char* key) {
    return card.contains(key) && card[key].is_array() &&
           std::ranges::all_of(card[key], [](const json& each) { return each.is_object(); });
  };
  return card.is_object() && is_list("ledger") && is_list("gates");
}

CardForm other_than(CardForm form) {
  return form == CardForm::Words ? CardForm::Facts : CardForm::Words;
}

}  // namespace

std::string json_from_card(const ScoreCard& card) {
  ordered_json json = json_of(card);
  visit_parts(json, fields_only_in(other_than(card.form)),
              [](ordered_json& part, const auto& absent) {
                for (const auto& [key, value] : absent.items()) part.erase(key);
              });
  return json.dump();
}

namespace {

/// Without what sentences are, or are made from.
ScoreCard numbers_of(ScoreCard card) {
  for (LedgerLine& line : card.ledger) {
    line.text.clear();
    line.facts = {};
  }
  for (GateResult& gate : card.gates) {
    gate.text.clear();
    gate.title.clear();
    gate.metric.clear();
    gate.is_measured = gate.is_at_least = false;
  }
  card.sentences.clear();
  card.messages.clear();
  card.is_reviewed = false;
  card.form = CardForm::Words;
  return card;
}

/// Far more than any rubric has.
constexpr std::int64_t milli_max = 1'000'000'000;

bool is_amount(std::int64_t milli) noexcept { return milli >= 0 && milli <= milli_max; }

/// Whoever brings a card may write anything into it: what shows it may trust these.
void check_balance(const ScoreCard& card) {
  std::int64_t lost_milli = 0;
  bool is_whole = is_amount(card.measured_milli) && is_amount(card.earned_milli) &&
                  is_amount(card.rubric_milli) && is_amount(card.score_milli) &&
                  card.shown_losses_milli.size() == card.ledger.size();
  for (const GroupScore& group : card.groups)
    is_whole = is_whole && is_amount(group.weight_milli) && is_amount(group.measured_milli) &&
               is_amount(group.earned_milli);
  for (const LedgerLine& line : card.ledger) {
    is_whole = is_whole && is_amount(line.weight_milli) && is_amount(line.points_lost_milli);
    lost_milli += is_whole ? line.points_lost_milli : 0;
  }
  if (!is_whole || lost_milli > card.measured_milli)
    refuse_json("a score card", "one whose points add up");
}

/// The text with the fields of the form that it has not.
json with_both_forms(json card) {
  if (!has_parts(card)) return card;
  const CardForm form = card.contains("form") ? CardForm::Facts : CardForm::Words;
  if (form == CardForm::Facts && card["form"] != name_of(CardForm::Facts))
    refuse_json("form", "a form of a card");
  visit_parts(card, fields_only_in(other_than(form)), [](json& part, const json& absent) {
    for (const auto& [key, value] : absent.items()) part[key] = value;
  });
  return card;
}

}  // namespace

bool is_same_score(const ScoreCard& one, const ScoreCard& other) {
  return json_from_card(numbers_of(one)) == json_from_card(numbers_of(other));
}

ScoreCard card_from_json(std::string_view text) {
  /// A card of the greatest shipped rubric has 20 KB.
  constexpr JsonBounds bounds{std::size_t{4} << 20U, 6};
  try {
    ScoreCard card;
    read_json(with_both_forms(parse_json("it", text, bounds)), "it", card);
    check_balance(card);
    return card;
  } catch (const DatabaseError& error) {
    throw DatabaseError{DatabaseErrorKind::Damaged,
                        std::string{"a score card cannot be read: "} + error.what()};
  }
}

}  // namespace hallux::database

#include "database/course/score_json.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "database/store/database_error.h"
#include "database/store/json_fields.h"

namespace hallux::database {

namespace {

using Json = nlohmann::ordered_json;

/// Far more than any rubric has; a card of the greatest shipped one has 20 KB.
constexpr std::size_t lines_max = 10'000, card_bytes_max = std::size_t{4} << 20U;
constexpr int card_depth_max = 6;

constexpr std::array<std::string_view, 3> ledger_kinds{"metric", "damping", "gate"};

Json json_from(const LedgerLine& line) {
  return {{"kind", ledger_kinds.at(static_cast<std::size_t>(line.kind))},
          {"item", line.item},
          {"metric", line.metric},
          {"group", line.group},
          {"unit", line.unit},
          {"value", line.value},
          {"is_measured", line.is_measured},
          {"target", line.target},
          {"weight_milli", line.weight_milli},
          {"points_lost_milli", line.points_lost_milli},
          {"start_us", line.start_us},
          {"end_us", line.end_us},
          {"place_in_bone_mm", line.place_in_bone_mm},
          {"text", line.text}};
}

Json json_from(const GroupScore& group) {
  return {{"name", group.name},
          {"weight_milli", group.weight_milli},
          {"measured_milli", group.measured_milli},
          {"earned_milli", group.earned_milli}};
}

Json json_from(const GateResult& gate) {
  return {{"name", gate.name},   {"cap_milli", gate.cap_milli}, {"is_triggered", gate.is_triggered},
          {"value", gate.value}, {"limit", gate.limit},         {"unit", gate.unit},
          {"text", gate.text}};
}

template <typename Part>
Json list_from(const std::vector<Part>& parts) {
  Json list = Json::array();
  for (const Part& part : parts) list.push_back(json_from(part));
  return list;
}

LedgerKind ledger_kind_in(const std::string& name) {
  for (std::size_t i = 0; i < ledger_kinds.size(); ++i) {
    if (ledger_kinds[i] == name) return static_cast<LedgerKind>(i);
  }
  throw DatabaseError{DatabaseErrorKind::Damaged, "a line has a kind that is not known"};
}

LedgerLine ledger_line_in(const nlohmann::json& json) {
  LedgerLine line;
  line.kind = ledger_kind_in(text_in(json, "kind"));
  line.item = text_in(json, "item");
  line.metric = text_in(json, "metric");
  line.group = text_in(json, "group");
  line.unit = text_in(json, "unit");
  line.value = number_in(json, "value");
  line.is_measured = flag_in(json, "is_measured");
  line.target = number_in(json, "target");
  line.weight_milli = integer_in(json, "weight_milli");
  line.points_lost_milli = integer_in(json, "points_lost_milli");
  line.start_us = integer_in(json, "start_us");
  line.end_us = integer_in(json, "end_us");
  const nlohmann::json& place = list_in(json, "place_in_bone_mm", 3);
  if (place.size() != 3) {
    throw DatabaseError{DatabaseErrorKind::Damaged, "a place has not three numbers"};
  }
  for (std::size_t i = 0; i < 3; ++i) line.place_in_bone_mm[i] = number_of(place[i], "place");
  line.text = text_in(json, "text");
  return line;
}

GroupScore group_in(const nlohmann::json& json) {
  return {text_in(json, "name"), integer_in(json, "weight_milli"),
          integer_in(json, "measured_milli"), integer_in(json, "earned_milli")};
}

GateResult gate_in(const nlohmann::json& json) {
  GateResult gate;
  gate.name = text_in(json, "name");
  gate.cap_milli = integer_in(json, "cap_milli");
  gate.is_triggered = flag_in(json, "is_triggered");
  gate.value = number_in(json, "value");
  gate.limit = number_in(json, "limit");
  gate.unit = text_in(json, "unit");
  gate.text = text_in(json, "text");
  return gate;
}

std::int32_t version_in(const nlohmann::json& json, const char* key) {
  return static_cast<std::int32_t>(
      integer_in(json, key, 0, std::numeric_limits<std::int32_t>::max()));
}

ScoreCard card_in(const nlohmann::json& json) {
  ScoreCard card;
  card.score_milli = integer_in(json, "score_milli");
  card.earned_milli = integer_in(json, "earned_milli");
  card.measured_milli = integer_in(json, "measured_milli");
  card.rubric_milli = integer_in(json, "rubric_milli");
  for (const auto& group : list_in(json, "groups", lines_max))
    card.groups.push_back(group_in(group));
  for (const auto& gate : list_in(json, "gates", lines_max)) card.gates.push_back(gate_in(gate));
  for (const auto& line : list_in(json, "ledger", lines_max)) {
    card.ledger.push_back(ledger_line_in(line));
  }
  for (const auto& loss : list_in(json, "shown_losses_milli", lines_max)) {
    card.shown_losses_milli.push_back(integer_of(loss, "shown_losses_milli"));
  }
  for (const auto& sentence : list_in(json, "sentences", lines_max)) {
    if (!sentence.is_string()) {
      throw DatabaseError{DatabaseErrorKind::Damaged, "a sentence is no text"};
    }
    card.sentences.push_back(sentence.get<std::string>());
  }
  card.scenario = text_in(json, "scenario");
  card.scenario_version = version_in(json, "scenario_version");
  card.rubric_version = version_in(json, "rubric_version");
  card.engine = version_in(json, "engine");
  card.is_reviewed = flag_in(json, "is_reviewed");
  return card;
}

}  // namespace

std::string json_from_card(const ScoreCard& card) {
  const Json json{{"score_milli", card.score_milli},
                  {"earned_milli", card.earned_milli},
                  {"measured_milli", card.measured_milli},
                  {"rubric_milli", card.rubric_milli},
                  {"groups", list_from(card.groups)},
                  {"gates", list_from(card.gates)},
                  {"ledger", list_from(card.ledger)},
                  {"shown_losses_milli", card.shown_losses_milli},
                  {"sentences", card.sentences},
                  {"scenario", card.scenario},
                  {"scenario_version", card.scenario_version},
                  {"rubric_version", card.rubric_version},
                  {"engine", card.engine},
                  {"is_reviewed", card.is_reviewed}};
  return json.dump();
}

ScoreCard card_from_json(std::string_view json) {
  try {
    return card_in(parse_json("it", json, {card_bytes_max, card_depth_max}));
  } catch (const DatabaseError& error) {
    throw DatabaseError{DatabaseErrorKind::Damaged,
                        std::string{"a score card cannot be read: "} + error.what()};
  }
}

}  // namespace hallux::database

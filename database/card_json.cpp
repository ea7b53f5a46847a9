#include "database/card_json.h"

#include <nlohmann/json.hpp>

#include "database/database_error.h"

namespace hallux::database {

namespace {

using Json = nlohmann::ordered_json;

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

double number_in(const Json& json) { return json.is_null() ? 0.0 : json.get<double>(); }

LedgerKind ledger_kind_in(const Json& json) {
  const auto name = json.get<std::string>();
  for (std::size_t i = 0; i < ledger_kinds.size(); ++i) {
    if (ledger_kinds[i] == name) return static_cast<LedgerKind>(i);
  }
  throw DatabaseError{DatabaseErrorKind::Damaged, "a score card has a line of kind '" + name + "'"};
}

LedgerLine ledger_line_in(const Json& json) {
  LedgerLine line;
  line.kind = ledger_kind_in(json.at("kind"));
  json.at("item").get_to(line.item);
  json.at("metric").get_to(line.metric);
  json.at("group").get_to(line.group);
  json.at("unit").get_to(line.unit);
  line.value = number_in(json.at("value"));
  json.at("is_measured").get_to(line.is_measured);
  line.target = number_in(json.at("target"));
  json.at("weight_milli").get_to(line.weight_milli);
  json.at("points_lost_milli").get_to(line.points_lost_milli);
  json.at("start_us").get_to(line.start_us);
  json.at("end_us").get_to(line.end_us);
  for (std::size_t i = 0; i < line.place_in_bone_mm.size(); ++i) {
    line.place_in_bone_mm[i] = number_in(json.at("place_in_bone_mm").at(i));
  }
  json.at("text").get_to(line.text);
  return line;
}

GroupScore group_in(const Json& json) {
  return {json.at("name").get<std::string>(), json.at("weight_milli").get<std::int64_t>(),
          json.at("measured_milli").get<std::int64_t>(),
          json.at("earned_milli").get<std::int64_t>()};
}

GateResult gate_in(const Json& json) {
  GateResult gate;
  json.at("name").get_to(gate.name);
  json.at("cap_milli").get_to(gate.cap_milli);
  json.at("is_triggered").get_to(gate.is_triggered);
  gate.value = number_in(json.at("value"));
  gate.limit = number_in(json.at("limit"));
  json.at("unit").get_to(gate.unit);
  json.at("text").get_to(gate.text);
  return gate;
}

ScoreCard card_in(const Json& json) {
  ScoreCard card;
  json.at("score_milli").get_to(card.score_milli);
  json.at("earned_milli").get_to(card.earned_milli);
  json.at("measured_milli").get_to(card.measured_milli);
  json.at("rubric_milli").get_to(card.rubric_milli);
  for (const Json& group : json.at("groups")) card.groups.push_back(group_in(group));
  for (const Json& gate : json.at("gates")) card.gates.push_back(gate_in(gate));
  for (const Json& line : json.at("ledger")) card.ledger.push_back(ledger_line_in(line));
  json.at("shown_losses_milli").get_to(card.shown_losses_milli);
  json.at("sentences").get_to(card.sentences);
  json.at("scenario").get_to(card.scenario);
  json.at("scenario_version").get_to(card.scenario_version);
  json.at("rubric_version").get_to(card.rubric_version);
  json.at("engine").get_to(card.engine);
  json.at("is_reviewed").get_to(card.is_reviewed);
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
    return card_in(Json::parse(json));
  } catch (const Json::exception& error) {
    throw DatabaseError{DatabaseErrorKind::Damaged,
                        std::string{"a score card cannot be read: "} + error.what()};
  }
}

}  // namespace hallux::database

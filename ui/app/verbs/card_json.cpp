#include "ui/app/verbs/card_json.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;

double points(std::int64_t milli) { return static_cast<double>(milli) / 1000.0; }

}  // namespace

ordered_json card_summary_json(const database::ScoreCard& card, bool is_confirmed) {
  ordered_json groups = ordered_json::array();
  for (const database::GroupScore& group : card.groups) {
    groups.push_back({{"name", group.name},
                      {"weight", points(group.weight_milli)},
                      {"measured_weight", points(group.measured_milli)},
                      {"earned", points(group.earned_milli)}});
  }
  ordered_json gates = ordered_json::array();
  for (const database::GateResult& gate : card.gates) {
    gates.push_back({{"name", gate.name},
                     {"triggered", gate.is_triggered},
                     {"cap", points(gate.cap_milli)},
                     {"value", gate.value},
                     {"limit", gate.limit},
                     {"unit", gate.unit},
                     {"text", gate.text}});
  }
  return {{"score", points(card.score_milli)},
          {"measured_weight", points(card.measured_milli)},
          {"partial", card.measured_milli < card.rubric_milli},
          {"confirmed", is_confirmed},
          {"reviewed", card.is_reviewed},
          {"scenario_version", card.scenario_version},
          {"rubric_version", card.rubric_version},
          {"engine", card.engine},
          {"groups", std::move(groups)},
          {"gates", std::move(gates)},
          {"sentences", card.sentences}};
}

ordered_json ledger_json(const database::ScoreCard& card) {
  ordered_json ledger = ordered_json::array();
  for (std::size_t i = 0; i < card.ledger.size(); ++i) {
    const database::LedgerLine& line = card.ledger[i];
    ordered_json row = {{"kind", database::name_of(line.kind)},
                        {"item", line.item},
                        {"metric", line.metric},
                        {"group", line.group},
                        {"value", line.is_measured ? ordered_json(line.value) : ordered_json()},
                        {"target", line.target},
                        {"unit", line.unit},
                        {"points_lost", points(card.shown_losses_milli.at(i))},
                        {"rubric_points_lost", points(line.points_lost_milli)},
                        {"rubric_weight", points(line.weight_milli)},
                        {"start_us", line.start_us},
                        {"end_us", line.end_us},
                        {"place_in_bone_mm", line.place_in_bone_mm},
                        {"text", line.text}};
    ledger.push_back(std::move(row));
  }
  return ledger;
}

}  // namespace hallux::ui

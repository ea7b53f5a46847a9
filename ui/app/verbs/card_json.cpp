#include "ui/app/verbs/card_json.h"

#include "scenarios/metric_names.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;

ordered_json named_or_null(std::string_view name) {
  return name.empty() ? ordered_json() : ordered_json(name);
}

}  // namespace

double points_from(std::int64_t milli) noexcept { return static_cast<double>(milli) / 1000.0; }

ordered_json card_summary_json(const database::ScoreCard& card, bool is_confirmed) {
  ordered_json groups = ordered_json::array();
  for (const database::GroupScore& group : card.groups) {
    groups.push_back({{"name", group.name},
                      {"weight", points_from(group.weight_milli)},
                      {"measured_weight", points_from(group.measured_milli)},
                      {"earned", points_from(group.earned_milli)}});
  }
  ordered_json gates = ordered_json::array();
  for (const database::GateResult& gate : card.gates) {
    gates.push_back({{"name", gate.name},
                     {"triggered", gate.is_triggered},
                     {"cap", points_from(gate.cap_milli)},
                     {"value", gate.value},
                     {"limit", gate.limit},
                     {"unit", gate.unit},
                     {"text", gate.text}});
  }
  return {{"score", points_from(card.score_milli)},
          {"measured_weight", points_from(card.measured_milli)},
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
                        {"points_lost", points_from(card.shown_losses_milli.at(i))},
                        {"rubric_points_lost", points_from(line.points_lost_milli)},
                        {"rubric_weight", points_from(line.weight_milli)},
                        {"start_us", line.start_us},
                        {"end_us", line.end_us},
                        {"place_in_bone_mm", line.place_in_bone_mm},
                        {"text", line.text}};
    ledger.push_back(std::move(row));
  }
  return ledger;
}

ordered_json measurements_json(std::span<const assessment::Measurement> measurements) {
  ordered_json list = ordered_json::array();
  for (const assessment::Measurement& each : measurements) {
    const scenarios::MetricName* metric = scenarios::find_metric(each.metric);
    const bool is_measured = each.is_measured();
    const Vec3& place = each.place_in_bone_mm;
    ordered_json row = {
        {"metric", each.metric},
        {"cut", named_or_null(each.cut)},
        {"hinge", named_or_null(each.hinge)},
        {"zone", named_or_null(each.zone)},
        {"fragment", named_or_null(each.fragment)},
        {"implant", named_or_null(each.implant)},
        {"value", is_measured ? ordered_json(each.value) : ordered_json()},
        {"unit", metric == nullptr ? "" : metric->unit},
        {"bound", is_measured ? ordered_json(each.bound) : ordered_json()},
        {"done_fraction", each.done_fraction},
        {"start_us", each.start_us},
        {"end_us", each.end_us},
        {"place_in_bone_mm", {place.x, place.y, place.z}},
        {"not_measured_because", named_or_null(assessment::reason_of(each.absence))}};
    list.push_back(std::move(row));
  }
  return list;
}

}  // namespace hallux::ui

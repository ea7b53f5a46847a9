// Words of a result: titles, values, targets, losses and marks. An attempt outlives its scenario's
// wording: where this version cannot read the scenario, the names that the stored card holds stand
// in for titles. A value is said as the card measured it, nothing is computed here; points are
// those of 100 that assessment has rounded so that they add up.
#include "ui/screens/result/result_text.h"

#include <algorithm>
#include <numeric>

#include "assessment/number_text.h"
#include "scenarios/metric_names.h"
#include "ui/report/measured_text.h"
#include "ui/screens/parts/value_text.h"

namespace hallux::ui {

namespace {

using database::AttemptState;
using database::DecisionKind;
using database::LedgerKind;
using database::LedgerLine;
using scenarios::RubricItem;
using scenarios::Scenario;

constexpr const char* minus = "\xE2\x88\x92";
constexpr const char* dash = "\xE2\x80\x93";
constexpr const char* at_most = "\xE2\x89\xA4 ";
constexpr const char* at_least = "\xE2\x89\xA5 ";

std::string percent(double share) { return assessment::number_text(100.0 * share, 0) + " %"; }

const RubricItem* find_item(const LedgerLine& line, const Scenario* scenario) {
  if (scenario == nullptr || line.kind != LedgerKind::Metric) return nullptr;
  const auto found = std::find_if(scenario->rubric.items.begin(), scenario->rubric.items.end(),
                                  [&](const RubricItem& item) { return item.id == line.item; });
  return found == scenario->rubric.items.end() ? nullptr : &*found;
}

/// Of a gate that asks for a least.
bool is_at_least(const LedgerLine& line, const Scenario* scenario) {
  if (scenario == nullptr || line.kind != LedgerKind::Gate) return false;
  const auto found = std::ranges::find(scenario->rubric.gates, line.item, &scenarios::Gate::name);
  return found != scenario->rubric.gates.end() && found->is_at_least;
}

ScoreMark state_mark(const Texts& texts, const ResultFacts& facts) {
  const auto mark = [&](const char* id, Meaning meaning, bool has_shape) {
    return ScoreMark{std::string(texts.text(id)), meaning, has_shape};
  };
  const database::Decision* decision = facts.decision();
  if (facts.header.state == AttemptState::Void) return mark("result.mark.void", Meaning::Bad, true);
  if (decision == nullptr) return mark("result.mark.advisory", Meaning::Neutral, false);
  if (!facts.header.decision_is_of_score_in_force)
    return mark("result.mark.signed_before", Meaning::Warn, true);
  return decision->kind == DecisionKind::Overridden
             ? mark("result.mark.overridden", Meaning::Info, true)
             : mark("result.mark.confirmed", Meaning::Good, true);
}

}  // namespace

std::string target_text(const LedgerLine& line, const Scenario* scenario) {
  const auto number = [](double value) {
    return with_true_minus(assessment::short_number_text(value));
  };
  if (line.kind == LedgerKind::Damping) return at_least + percent(line.target);
  const RubricItem* item = find_item(line, scenario);
  if (scenarios::is_claim(line.metric)) return item != nullptr && item->full > 0.5 ? "yes" : "no";
  if (item != nullptr && item->is_band)
    return assessment::with_unit(number(item->full_low) + dash + number(item->full_high),
                                 line.unit);
  const bool is_least = item != nullptr ? item->full > item->zero : is_at_least(line, scenario);
  std::string target = assessment::with_unit(number(line.target), line.unit);
  if (!is_least && line.target == 0.0) return target;
  return (is_least ? at_least : at_most) + target;
}

std::string item_title(const LedgerLine& line, const Scenario* scenario) {
  if (const RubricItem* item = find_item(line, scenario)) return item->title;
  if (scenario != nullptr && line.kind == LedgerKind::Gate) {
    for (const scenarios::Gate& gate : scenario->rubric.gates)
      if (gate.name == line.item) return gate.title;
  }
  if (line.kind == LedgerKind::Damping) return "Efficiency, by accuracy";
  return line.item.empty() ? line.metric : line.item;
}

std::string group_title(const database::GroupScore& group, const Scenario* scenario) {
  if (scenario != nullptr) {
    for (const scenarios::RubricGroup& each : scenario->rubric.groups)
      if (each.name == group.name) return each.title;
  }
  return group.name;
}

std::string loss_text(const LedgerLine& line, const assessment::ShownLine& shown) {
  if (shown.lost_milli > 0) return minus + points_text(shown.lost_milli);
  return line.points_lost_milli > 0 ? "< 0.1" : "0";
}

std::string possible_text(const assessment::ShownGroup& shown) {
  return assessment::points_text(shown.possible_milli);
}

std::string decider_text(const Texts& texts, const database::Decision& decision) {
  return decision.decided_by.empty() ? std::string(texts.text("result.decision.nobody"))
                                     : decision.decided_by;
}

std::optional<std::size_t> cut_of(const LedgerLine& line, const Scenario* scenario) {
  const RubricItem* item = find_item(line, scenario);
  if (item == nullptr) return std::nullopt;
  for (std::size_t cut = 0; cut < scenario->cuts.size(); ++cut)
    if (scenario->cuts[cut].name == item->cut) return cut;
  return std::nullopt;
}

std::vector<std::size_t> lines_by_loss(const database::ScoreCard& card) {
  std::vector<std::size_t> order(card.ledger.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return card.ledger[a].points_lost_milli > card.ledger[b].points_lost_milli;
  });
  return order;
}

std::optional<std::size_t> line_of_sentence(const database::ScoreCard& card,
                                            std::string_view sentence) {
  for (std::size_t line = 0; line < card.ledger.size(); ++line)
    if (card.ledger[line].text == sentence) return line;
  return std::nullopt;
}

std::vector<ScoreMark> score_marks(const Texts& texts, const ResultFacts& facts) {
  std::vector<ScoreMark> marks;
  const auto add = [&](const char* id, Meaning meaning, bool has_shape = true) {
    marks.push_back({std::string(texts.text(id)), meaning, has_shape});
  };
  const database::AttemptHeader& header = facts.header;
  const std::optional<database::StoredScore>& score = facts.score;
  if (score || header.state == AttemptState::Void) marks.push_back(state_mark(texts, facts));
  if (score && score->card.measured_milli < score->card.rubric_milli)
    add("result.mark.partial", Meaning::Warn);
  if (header.state == AttemptState::Interrupted) add("result.mark.interrupted", Meaning::Warn);
  if (header.state == AttemptState::Recording) add("result.mark.recording", Meaning::Info);
  if (header.is_valid == false) add("result.mark.not_valid", Meaning::Warn);
  if (facts.scenario ? !facts.scenario->is_reviewed : score && !score->card.is_reviewed)
    add("result.mark.not_reviewed", Meaning::Warn);
  if (header.is_simulated) add("result.mark.simulated", Meaning::Info);
  if (!header.begun.person) add("result.mark.robot", Meaning::Neutral, false);
  add(header.begun.kind == database::AttemptKind::Assessment ? "result.mark.assessment"
                                                             : "result.mark.practice",
      Meaning::Neutral, false);
  if (header.begun.guidance == simulator::Guidance::Soft)
    add("result.mark.soft_guide", Meaning::Info);
  if (header.begun.guidance == simulator::Guidance::Slot)
    add("result.mark.slot_guide", Meaning::Info);
  return marks;
}

}  // namespace hallux::ui

#include "ui/jobs/prove_scenario.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <set>
#include <sstream>

#include "assessment/number_text.h"
#include "scenarios/hands/hand_fault.h"
#include "ui/jobs/made_attempt.h"

namespace hallux::ui {

namespace {

using assessment::points_text;
using database::LedgerKind;
using database::LedgerLine;
using database::ScoreCard;
using scenarios::ProofFault;
using scenarios::Rubric;
using scenarios::RubricItem;

/// Of its weight, what a group may lose or gain that a fault is not about: the hand goes another
/// way.
constexpr std::int64_t spared_percent = 5;

/// "offset:one=2 offset:other=2": several are one performance.
std::vector<std::string> faults_in(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

ScoreCard card_of(const scenarios::Scenario& scenario, const std::vector<std::string>& faults,
                  const StageProgress& progress) {
  ScriptedAttempt attempt;
  attempt.scenario = scenario;
  attempt.hand = "perfect";
  attempt.faults = scenarios::parse_hand_faults(faults, scenario);
  return make_attempt(attempt, progress).card;
}

const LedgerLine* line_of(const ScoreCard& card, const std::string& item) {
  const auto found = std::ranges::find_if(card.ledger, [&](const LedgerLine& line) {
    return line.kind == LedgerKind::Metric && line.item == item;
  });
  return found == card.ledger.end() ? nullptr : &*found;
}

std::int64_t lost_milli(const ScoreCard& card, const std::string& item) {
  const LedgerLine* line = line_of(card, item);
  return line == nullptr ? 0 : line->points_lost_milli;
}

std::vector<LostPoints> losses_of(const ScoreCard& card) {
  std::vector<LostPoints> lost;
  for (std::size_t index = 0; index < card.ledger.size(); ++index) {
    const LedgerLine& line = card.ledger[index];
    if (line.points_lost_milli > 0)
      lost.push_back({line.item, card.shown_losses_milli[index], line.text});
  }
  return lost;
}

ProvedPerformance performance_of(std::string name, const ScoreCard& card) {
  ProvedPerformance performance;
  performance.name = std::move(name);
  performance.score_milli = card.score_milli;
  performance.lost = losses_of(card);
  return performance;
}

void check_perfect(ProvedPerformance& perfect) {
  if (perfect.score_milli < perfect_milli) {
    perfect.differences.push_back("The perfect hand scores " + points_text(perfect.score_milli) +
                                  ", less than " + points_text(perfect_milli) + ".");
  }
  for (const LostPoints& lost : perfect.lost) {
    if (lost.text.empty())
      perfect.differences.push_back("Nothing says why " + lost.item + " loses points.");
  }
}

void check_items(ProvedPerformance& performance, const ProofFault& fault, const Rubric& rubric,
                 const ScoreCard& card) {
  for (const std::string& id : fault.items) {
    const RubricItem& item = *std::ranges::find(rubric.items, id, &RubricItem::id);
    const std::int64_t lost = lost_milli(card, id);
    if (2 * lost >= item.weight_milli) continue;
    performance.differences.push_back(id + " loses " + points_text(lost) + " of " +
                                      points_text(item.weight_milli) +
                                      " rubric points, less than half.");
  }
}

void check_gates(ProvedPerformance& performance, const ProofFault& fault, const ScoreCard& card) {
  for (const database::GateResult& gate : card.gates) {
    const bool is_expected = std::ranges::find(fault.gates, gate.name) != fault.gates.end();
    if (gate.is_triggered == is_expected) continue;
    performance.differences.push_back("The gate " + gate.name +
                                      (is_expected ? " is not triggered." : " is triggered."));
  }
}

/// The groups in which the fault is to cost something: those of its items, and of the items that
/// ask what its gates ask.
std::set<std::string> groups_meant(const ProofFault& fault, const Rubric& rubric) {
  std::set<std::string> meant;
  for (const std::string& id : fault.items)
    meant.insert(std::ranges::find(rubric.items, id, &RubricItem::id)->group);
  for (const std::string& name : fault.gates) {
    const auto gate = std::ranges::find(rubric.gates, name, &scenarios::Gate::name);
    for (const RubricItem& item : rubric.items)
      if (item.metric == gate->metric) meant.insert(item.group);
  }
  return meant;
}

void check_spared_groups(ProvedPerformance& performance, const ProofFault& fault,
                         const Rubric& rubric, const ScoreCard& perfect, const ScoreCard& card) {
  const std::set<std::string> meant = groups_meant(fault, rubric);
  for (const scenarios::RubricGroup& group : rubric.groups) {
    if (meant.contains(group.name)) continue;
    std::int64_t more_milli = 0;
    for (const RubricItem& item : rubric.items) {
      if (item.group == group.name)
        more_milli += lost_milli(card, item.id) - lost_milli(perfect, item.id);
    }
    if (100 * std::abs(more_milli) <= spared_percent * group.weight_milli) continue;
    performance.differences.push_back(
        "The group " + group.name + (more_milli > 0 ? " loses " : " gains ") +
        points_text(std::abs(more_milli)) + " of " + points_text(group.weight_milli) +
        " rubric points, and the fault is not about it.");
  }
  if (card.score_milli > perfect.score_milli)
    performance.differences.push_back("The score rises by the fault.");
}

/// The stages of one of several performances, named in front.
StageProgress stages_of(const StageProgress& progress, const std::string& name) {
  return [&progress, name](const std::string& stage) { return progress(name + ": " + stage); };
}

}  // namespace

bool ScenarioProof::has_passed() const noexcept {
  return perfect.is_ok() &&
         std::ranges::all_of(faults, [](const ProvedPerformance& each) { return each.is_ok(); });
}

ScenarioProof prove_scenario(const scenarios::Scenario& scenario, const StageProgress& progress) {
  // A fault that is none is refused before the long work.
  for (const ProofFault& fault : scenario.proof)
    scenarios::parse_hand_faults(faults_in(fault.fault), scenario);
  const ScoreCard perfect = card_of(scenario, {}, stages_of(progress, "perfect"));
  ScenarioProof proof;
  proof.perfect = performance_of("perfect", perfect);
  check_perfect(proof.perfect);
  for (const ProofFault& fault : scenario.proof) {
    const ScoreCard card =
        card_of(scenario, faults_in(fault.fault), stages_of(progress, fault.fault));
    ProvedPerformance performance = performance_of(fault.fault, card);
    performance.expected = fault.items;
    performance.expected.insert(performance.expected.end(), fault.gates.begin(), fault.gates.end());
    check_items(performance, fault, scenario.rubric, card);
    check_gates(performance, fault, card);
    check_spared_groups(performance, fault, scenario.rubric, perfect, card);
    proof.faults.push_back(std::move(performance));
  }
  return proof;
}

}  // namespace hallux::ui

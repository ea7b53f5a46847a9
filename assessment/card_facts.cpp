/// Only the three that matter most become messages. Whatever an unfinished cut has cost is one
/// loss, told once.
#include "assessment/card_facts.h"

#include <algorithm>
#include <string>
#include <vector>

#include "assessment/ledger.h"
#include "assessment/shown_points.h"

namespace hallux::assessment {

namespace {

using database::GateResult;
using database::LedgerKind;
using database::LedgerLine;
using database::LineFacts;
using database::Message;
using database::MessageKind;
using database::ScoreCard;
using database::TargetKind;
using scenarios::Gate;
using scenarios::RubricItem;
using scenarios::Scenario;

constexpr std::size_t message_limit = 3;

/// With one cut the sentence needs no name; with several each says which it is about.
std::string subject_title(const Scenario& scenario, const RubricItem& item) {
  for (const scenarios::DangerZone& zone : scenario.danger_zones) {
    if (zone.name == item.zone) return zone.title;
  }
  for (const scenarios::Fragment& fragment : scenario.fragments) {
    if (fragment.name == item.fragment) return fragment.title;
  }
  for (const scenarios::Implant& implant : scenario.implants) {
    if (implant.name == item.implant) return implant.title;
  }
  if (scenario.cuts.size() < 2) return "";
  for (const scenarios::ReferenceCut& cut : scenario.cuts) {
    if (cut.name == item.cut) return cut.title;
  }
  for (const scenarios::ReferenceHinge& hinge : scenario.hinges) {
    if (hinge.name == item.hinge) return hinge.title;
  }
  return "";
}

LineFacts facts_of(const Scenario& scenario, const RubricItem& item,
                   const Measurement& measurement) {
  LineFacts facts;
  facts.title = item.title;
  facts.subject = subject_title(scenario, item);
  facts.target_low = facts.target_high = item.full;
  if (item.is_band) {
    facts.target = TargetKind::Between;
    facts.target_low = item.full_low;
    facts.target_high = item.full_high;
  } else if (item.full > item.zero) {
    facts.target = TargetKind::AtLeast;
  }
  facts.absence = measurement.absence;
  facts.done_fraction = measurement.done_fraction;
  facts.direction = measurement.direction;
  facts.detail = measurement.detail;
  facts.remark = measurement.remark;
  return facts;
}

void add_line_facts(LedgerLine& line, const Scenario& scenario,
                    std::span<const Measurement> measurements) {
  for (const RubricItem& item : scenario.rubric.items) {
    if (line.kind != LedgerKind::Metric || item.id != line.item) continue;
    const Measurement* measurement = find_measurement(measurements, item);
    if (measurement != nullptr) line.facts = facts_of(scenario, item, *measurement);
  }
}

void add_gate_facts(GateResult& result, const Gate& gate,
                    std::span<const Measurement> measurements) {
  const Measurement* measurement = find_measurement(measurements, gate);
  result.title = gate.title;
  result.metric = gate.metric;
  result.is_at_least = gate.is_at_least;
  result.is_measured = measurement != nullptr && measurement->is_measured();
}

/// What a sentence may be about: a line of the ledger, or all lines that one unfinished cut has
/// cost.
struct Loss {
  std::int64_t lost_milli = 0;
  Message message;
  /// How much sooner it is told than another that lost as much: a gate, then safety.
  std::int64_t severity = 1;

  std::int64_t urgency() const noexcept { return lost_milli * severity; }
};

std::int64_t severity_of(const LedgerLine& line) noexcept {
  constexpr std::int64_t of_gate = 3, of_safety = 2;
  if (line.kind == LedgerKind::Gate) return of_gate;
  return line.group == "safety" ? of_safety : 1;
}

/// A cut that was left unfinished, or not made at all, with what its lines lost together.
struct UnfinishedCut {
  const scenarios::ReferenceCut* cut = nullptr;
  double done_fraction = 0.0;
  std::int64_t lost_milli = 0, shown_lost_milli = 0;
};

/// How much of a cut was sawn; 0 where it was not made.
double done_fraction_of(const std::string& cut, std::span<const Measurement> measurements) {
  for (const Measurement& measurement : measurements) {
    if (measurement.cut == cut) return measurement.is_measured() ? measurement.done_fraction : 0.0;
  }
  return 0.0;
}

/// Of the operation's cuts the least finished; the first where all are alike.
std::string least_finished_cut(const Scenario& scenario,
                               std::span<const Measurement> measurements) {
  const auto least = std::min_element(
      scenario.cuts.begin(), scenario.cuts.end(), [&](const auto& a, const auto& b) {
        return done_fraction_of(a.name, measurements) < done_fraction_of(b.name, measurements);
      });
  return least->name;
}

/// The unfinished cut that an item's loss is to be laid to: its own, of a hinge's two the less
/// finished, of the whole attempt's the least; null where nothing is unfinished.
const scenarios::ReferenceCut* unfinished_cut_of(const Scenario& scenario, const RubricItem& item,
                                                 std::span<const Measurement> measurements) {
  const Measurement* measurement = find_measurement(measurements, item);
  const bool is_whole = measurement == nullptr || measurement->absence == Absence::NotDone ||
                        (measurement->is_measured() && measurement->done_fraction >= 1.0);
  if (!item.fragment.empty() || !item.implant.empty()) return nullptr;
  if (item.cut.empty() && item.hinge.empty() && is_whole) return nullptr;
  std::string name = item.cut.empty() ? least_finished_cut(scenario, measurements) : item.cut;
  for (const scenarios::ReferenceHinge& hinge : scenario.hinges) {
    if (hinge.name != item.hinge) continue;
    const double first = done_fraction_of(hinge.first_cut, measurements);
    name = first <= done_fraction_of(hinge.second_cut, measurements) ? hinge.first_cut
                                                                     : hinge.second_cut;
  }
  if (done_fraction_of(name, measurements) >= 1.0) return nullptr;
  const auto found = std::find_if(scenario.cuts.begin(), scenario.cuts.end(),
                                  [&](const auto& cut) { return cut.name == name; });
  return found == scenario.cuts.end() ? nullptr : &*found;
}

Message unfinished_message(const Scenario& scenario, const UnfinishedCut& unfinished) {
  Message message;
  message.kind =
      unfinished.done_fraction == 0.0 ? MessageKind::CutNotMade : MessageKind::CutUnfinished;
  if (scenario.cuts.size() > 1) message.subject = unfinished.cut->title;
  message.done_fraction = unfinished.done_fraction;
  message.lost_milli = unfinished.shown_lost_milli;
  return message;
}

/// Gathers lines by the unfinished cut that they are laid to.
class UnfinishedCuts {
 public:
  UnfinishedCuts(const Scenario& scenario, std::span<const Measurement> measurements)
      : scenario_(scenario), measurements_(measurements) {}

  /// False where the line is about something else.
  bool take(const LedgerLine& line, const ShownLine& shown) {
    if (line.kind != LedgerKind::Metric || line.points_lost_milli == 0) return false;
    const scenarios::ReferenceCut* cut = cut_of(line);
    if (cut == nullptr) return false;
    const auto found = std::find_if(cuts_.begin(), cuts_.end(),
                                    [&](const UnfinishedCut& each) { return each.cut == cut; });
    UnfinishedCut& unfinished = found == cuts_.end() ? cuts_.emplace_back() : *found;
    unfinished.cut = cut;
    unfinished.done_fraction = done_fraction_of(cut->name, measurements_);
    unfinished.lost_milli += line.points_lost_milli;
    unfinished.shown_lost_milli += shown.lost_milli;
    return true;
  }
  void add_to(std::vector<Loss>& losses) const {
    for (const UnfinishedCut& each : cuts_)
      losses.push_back({each.lost_milli, unfinished_message(scenario_, each)});
  }

 private:
  const scenarios::ReferenceCut* cut_of(const LedgerLine& line) const {
    for (const RubricItem& item : scenario_.rubric.items) {
      if (item.id == line.item) return unfinished_cut_of(scenario_, item, measurements_);
    }
    return nullptr;
  }

  const Scenario& scenario_;
  std::span<const Measurement> measurements_;
  std::vector<UnfinishedCut> cuts_;
};

Message message_about(std::size_t line, const ShownLine& shown) {
  Message message;
  message.line = static_cast<std::int64_t>(line);
  message.lost_milli = shown.lost_milli;
  return message;
}

std::vector<Loss> losses_of(const ScoreCard& card, const ShownPoints& shown,
                            const Scenario& scenario, std::span<const Measurement> measurements) {
  std::vector<Loss> losses;
  UnfinishedCuts unfinished(scenario, measurements);
  for (std::size_t index = 0; index < card.ledger.size(); ++index) {
    const LedgerLine& line = card.ledger[index];
    if (!unfinished.take(line, shown.lines[index]))
      losses.push_back(
          {line.points_lost_milli, message_about(index, shown.lines[index]), severity_of(line)});
  }
  unfinished.add_to(losses);
  std::stable_sort(losses.begin(), losses.end(),
                   [](const Loss& a, const Loss& b) { return a.urgency() > b.urgency(); });
  return losses;
}

void choose_messages(ScoreCard& card, const Scenario& scenario,
                     std::span<const Measurement> measurements) {
  card.messages.clear();
  if (card.measured_milli == 0) {
    card.messages.emplace_back().kind = MessageKind::NothingMeasured;
    return;
  }
  for (const Loss& loss : losses_of(card, shown_points(card), scenario, measurements)) {
    if (loss.lost_milli == 0 || card.messages.size() == message_limit) break;
    card.messages.push_back(loss.message);
  }
}

}  // namespace

void add_facts(ScoreCard& card, const Scenario& scenario,
               std::span<const Measurement> measurements) {
  card.form = database::CardForm::Facts;
  for (LedgerLine& line : card.ledger) add_line_facts(line, scenario, measurements);
  for (std::size_t index = 0; index < card.gates.size(); ++index)
    add_gate_facts(card.gates[index], scenario.rubric.gates[index], measurements);
  choose_messages(card, scenario, measurements);
}

}  // namespace hallux::assessment

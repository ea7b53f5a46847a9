/// A sentence is put together from clauses: subject, value, which way, full points, loss. The
/// wordings stand with the metric's name (scenarios/metric_names.h), so a new metric brings its
/// own. The number of points comes from shown_points, never from the rubric: a reader adds them up.
#include "assessment/sentences.h"

#include <algorithm>
#include <string>
#include <vector>

#include "assessment/ledger.h"
#include "assessment/number_text.h"
#include "assessment/shown_points.h"
#include "scenarios/metric_names.h"

namespace hallux::assessment {

namespace {

using database::GateResult;
using database::LedgerKind;
using database::LedgerLine;
using database::ScoreCard;
using scenarios::Gate;
using scenarios::MetricWording;
using scenarios::RubricItem;
using scenarios::Scenario;

constexpr std::size_t sentence_limit = 3;

/// A count and a share have no unit.
std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit_text(unit);
}

std::string direction_clause(const MetricWording& wording, const Measurement& measurement) {
  if (measurement.direction.empty() || wording.lean[0] == '\0') return "";
  return wording.lean + measurement.direction + wording.lean_end;
}

std::string metric_clause(const RubricItem& item, const Measurement& measurement, bool is_loss) {
  const std::string value = value_text(measurement.value, item.unit);
  const scenarios::MetricName* metric = scenarios::find_metric(item.metric);
  if (metric == nullptr) return item.title + ": " + value;
  if (metric->is_claim) return item.title + (measurement.value > 0.5 ? ": yes" : ": no");
  const MetricWording& wording = metric->wording;
  const bool is_zero = measurement.value == 0.0 && wording.at_zero[0] != '\0';
  std::string text = is_zero ? wording.at_zero : wording.subject + value + wording.tail;
  // A direction and more numbers help to mend a loss; where nothing was lost they would only sound
  // like one.
  if (!is_loss) return text;
  const std::string detail = measurement.detail.empty() ? "" : ": " + measurement.detail;
  return text + direction_clause(wording, measurement) + detail;
}

/// A line with its points as they are said.
struct SaidLine {
  const LedgerLine& line;
  const ShownLine& shown;
};

std::string loss_clause(const SaidLine& said) {
  const std::string possible = points_text(said.shown.possible_milli);
  if (said.line.points_lost_milli == 0) return "all " + possible + " points";
  return lost_points_text(said.line, said.shown) + " of " + possible + " points lost";
}

/// " (full points to 1 deg)"; of a claim nothing.
std::string target_clause(const RubricItem& item) {
  if (scenarios::is_claim(item.metric)) return "";
  if (item.is_band) {
    return " (full points from " + short_number_text(item.full_low) + " to " +
           with_unit(short_number_text(item.full_high), item.unit) + ")";
  }
  const char* bound = item.full > item.zero ? " (full points from " : " (full points to ";
  return bound + with_unit(short_number_text(item.full), item.unit) + ")";
}

/// With one cut the sentence needs no name; with several each says which it is about.
std::string subject_prefix(const Scenario& scenario, const RubricItem& item) {
  for (const scenarios::DangerZone& zone : scenario.danger_zones) {
    if (zone.name == item.zone) return zone.title + ": ";
  }
  if (scenario.cuts.size() < 2) return "";
  for (const scenarios::ReferenceCut& cut : scenario.cuts) {
    if (cut.name == item.cut) return cut.title + ": ";
  }
  for (const scenarios::ReferenceHinge& hinge : scenario.hinges) {
    if (hinge.name == item.hinge) return hinge.title + ": ";
  }
  return "";
}

/// "Unfinished cut (62 % sawn, so 62 % of the points). ", or nothing.
std::string unfinished_clause(const RubricItem& item, const Measurement& measurement) {
  if (measurement.done_fraction >= 1.0) return "";
  const std::string done = number_text(100.0 * measurement.done_fraction, 0) + " %";
  const char* work = subject_of(item).empty() || !item.zone.empty() ? "work" : "cut";
  return std::string("Unfinished ") + work + " (" + done + " sawn, so " + done +
         " of the points). ";
}

std::string item_sentence(const Scenario& scenario, const RubricItem& item, const SaidLine& said,
                          const Measurement& measurement) {
  const LedgerLine& line = said.line;
  const std::string prefix = subject_prefix(scenario, item);
  if (!line.is_measured)
    return prefix + item.title + " could not be measured because " +
           std::string(reason_of(measurement.absence)) + ": " + loss_clause(said) + ".";
  return prefix + unfinished_clause(item, measurement) +
         metric_clause(item, measurement, line.points_lost_milli > 0) + target_clause(item) + ": " +
         loss_clause(said) + "." + (measurement.note.empty() ? "" : " " + measurement.note);
}

std::string damping_sentence(const SaidLine& said) {
  const LedgerLine& line = said.line;
  const std::string reached = number_text(100.0 * line.value, 0) + " %";
  const std::string needed = number_text(100.0 * line.target, 0) + " %";
  if (line.points_lost_milli == 0) {
    return "Accuracy reached " + reached + " of its points (" + needed +
           " needed), so efficiency counts in full.";
  }
  return "Accuracy reached " + reached + " of its points; below " + needed +
         " efficiency counts less: " + loss_clause(said) + ".";
}

/// "Title: 1.50 mm (limit 1 mm)", or of a claim the title alone.
std::string gate_finding(const Gate& gate, double value) {
  if (scenarios::is_claim(gate.metric)) return gate.title;
  return gate.title + ": " + value_text(value, gate.unit) +
         (gate.is_at_least ? " (at least " : " (limit ") +
         with_unit(short_number_text(gate.limit), gate.unit) + ")";
}

std::string gate_sentence(const Gate& gate, const SaidLine& said) {
  const LedgerLine& line = said.line;
  const std::string head =
      gate_finding(gate, line.value) + ", so the score is capped at " + points_text(gate.cap_milli);
  if (line.points_lost_milli == 0) return head + "; it was not above that.";
  return head + ": " + lost_points_text(line, said.shown) + " points lost.";
}

std::string gate_text(const GateResult& result, const Gate& gate, bool is_measured) {
  const std::string cap = "the score is capped at " + points_text(gate.cap_milli);
  if (!is_measured) return gate.title + ": not measured.";
  if (scenarios::is_claim(gate.metric))
    return gate.title + (result.is_triggered ? ": yes; " + cap : ": no") + ".";
  const std::string limit = with_unit(short_number_text(gate.limit), gate.unit);
  const std::string value = gate.title + ": " + value_text(result.value, gate.unit);
  if (gate.is_at_least)
    return value + (result.is_triggered ? ", less than the " + limit + " asked for; " + cap + "."
                                        : ", no less than the " + limit + " asked for.");
  if (result.is_triggered) return value + ", above the limit of " + limit + "; " + cap + ".";
  return value + ", within the limit of " + limit + ".";
}

void explain_line(LedgerLine& line, const ShownLine& shown, const Scenario& scenario,
                  std::span<const Measurement> measurements) {
  const SaidLine said{line, shown};
  if (line.kind == LedgerKind::Damping) {
    line.text = damping_sentence(said);
    return;
  }
  for (const Gate& gate : scenario.rubric.gates) {
    if (line.kind == LedgerKind::Gate && gate.name == line.item) {
      line.text = gate_sentence(gate, said);
    }
  }
  for (const RubricItem& item : scenario.rubric.items) {
    if (line.kind != LedgerKind::Metric || item.id != line.item) continue;
    const Measurement* measurement = find_measurement(measurements, item);
    if (measurement != nullptr) line.text = item_sentence(scenario, item, said, *measurement);
  }
}

/// What a sentence may be about: a line of the ledger, or all lines that one unfinished cut has
/// cost.
struct Loss {
  std::int64_t lost_milli = 0;
  std::string text;
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

std::string unfinished_sentence(const Scenario& scenario, const UnfinishedCut& unfinished) {
  const std::string lost = points_text(unfinished.shown_lost_milli) + " points lost.";
  const std::string subject = scenario.cuts.size() < 2 ? "" : unfinished.cut->title + ": ";
  if (unfinished.done_fraction == 0.0) return subject + "The cut was not made: " + lost;
  const std::string done = number_text(100.0 * unfinished.done_fraction, 0) + " %";
  return subject + "Unfinished cut: " + done + " was sawn, so what it is worth counts " + done +
         ". With its other losses that is " + lost;
}

/// Gathers lines by the unfinished cut that they are laid to.
class UnfinishedCuts {
 public:
  UnfinishedCuts(const Scenario& scenario, std::span<const Measurement> measurements)
      : scenario_(scenario), measurements_(measurements) {}

  /// False where the line is about something else.
  bool take(const SaidLine& said) {
    if (said.line.kind != LedgerKind::Metric || said.line.points_lost_milli == 0) return false;
    const scenarios::ReferenceCut* cut = cut_of(said.line);
    if (cut == nullptr) return false;
    const auto found = std::find_if(cuts_.begin(), cuts_.end(),
                                    [&](const UnfinishedCut& each) { return each.cut == cut; });
    UnfinishedCut& unfinished = found == cuts_.end() ? cuts_.emplace_back() : *found;
    unfinished.cut = cut;
    unfinished.done_fraction = done_fraction_of(cut->name, measurements_);
    unfinished.lost_milli += said.line.points_lost_milli;
    unfinished.shown_lost_milli += said.shown.lost_milli;
    return true;
  }
  void add_to(std::vector<Loss>& losses) const {
    for (const UnfinishedCut& each : cuts_)
      losses.push_back({each.lost_milli, unfinished_sentence(scenario_, each)});
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

void choose_sentences(ScoreCard& card, const ShownPoints& shown, const Scenario& scenario,
                      std::span<const Measurement> measurements) {
  card.sentences.clear();
  if (card.measured_milli == 0) {
    card.sentences.push_back("Nothing of this attempt could be measured, so its score is 0.");
    return;
  }
  std::vector<Loss> losses;
  UnfinishedCuts unfinished(scenario, measurements);
  for (std::size_t index = 0; index < card.ledger.size(); ++index) {
    const LedgerLine& line = card.ledger[index];
    if (!unfinished.take({line, shown.lines[index]}))
      losses.push_back({line.points_lost_milli, line.text, severity_of(line)});
  }
  unfinished.add_to(losses);
  std::stable_sort(losses.begin(), losses.end(),
                   [](const Loss& a, const Loss& b) { return a.urgency() > b.urgency(); });
  for (const Loss& loss : losses) {
    if (loss.lost_milli == 0 || card.sentences.size() == sentence_limit) break;
    card.sentences.push_back(loss.text);
  }
}

}  // namespace

void explain(ScoreCard& card, const Scenario& scenario, std::span<const Measurement> measurements) {
  const ShownPoints shown = shown_points(card);
  for (std::size_t line = 0; line < card.ledger.size(); ++line)
    explain_line(card.ledger[line], shown.lines[line], scenario, measurements);
  for (std::size_t index = 0; index < card.gates.size(); ++index) {
    const Gate& gate = scenario.rubric.gates[index];
    const Measurement* measurement = find_measurement(measurements, gate);
    const bool is_measured = measurement != nullptr && measurement->is_measured();
    card.gates[index].text = gate_text(card.gates[index], gate, is_measured);
  }
  choose_sentences(card, shown, scenario, measurements);
}

}  // namespace hallux::assessment

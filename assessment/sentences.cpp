/// A sentence is put together from clauses: subject, value, which way, full points, loss. The
/// wordings stand with the metric's name (scenarios/metric_names.h), so a new metric brings its
/// own. The number of points comes from shown_points, never from the rubric: a reader adds them up.
#include "assessment/sentences.h"

#include <algorithm>
#include <numeric>
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

/// A claim has no unit: its value is 1 where it holds.
bool is_claim(const std::string& unit) noexcept { return unit.empty(); }

std::string direction_clause(const MetricWording& wording, const Measurement& measurement) {
  if (measurement.direction.empty() || wording.lean[0] == '\0') return "";
  return wording.lean + measurement.direction + wording.lean_end;
}

std::string metric_clause(const RubricItem& item, const Measurement& measurement, bool is_loss) {
  const std::string value = value_text(measurement.value, item.unit);
  const scenarios::MetricName* metric = scenarios::find_metric(item.metric);
  if (metric == nullptr || metric->unit.empty()) return item.title + ": " + value;
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

std::string target_clause(const RubricItem& item) {
  if (item.is_band) {
    return "(full points from " + short_number_text(item.full_low) + " to " +
           short_number_text(item.full_high) + " " + item.unit + ")";
  }
  return "(full points to " + short_number_text(item.full) + " " + item.unit + ")";
}

/// With one cut the sentence needs no name; with several each says which it is about.
std::string subject_prefix(const Scenario& scenario, const RubricItem& item) {
  if (scenario.cuts.size() < 2) return "";
  for (const scenarios::ReferenceCut& cut : scenario.cuts) {
    if (cut.name == item.cut) return cut.title + ": ";
  }
  for (const scenarios::ReferenceHinge& hinge : scenario.hinges) {
    if (hinge.name == item.hinge) return hinge.title + ": ";
  }
  return "";
}

std::string item_sentence(const Scenario& scenario, const RubricItem& item, const SaidLine& said,
                          const Measurement& measurement) {
  const LedgerLine& line = said.line;
  const std::string prefix = subject_prefix(scenario, item);
  if (!line.is_measured) {
    return prefix + item.title +
           " could not be measured because the cut was not made: " + loss_clause(said) + ".";
  }
  const bool is_unfinished = measurement.done_fraction < 1.0;
  const std::string done = number_text(100.0 * measurement.done_fraction, 0) + " %";
  const std::string unfinished =
      is_unfinished ? "Unfinished cut (" + done + " sawn, so " + done + " of the points). " : "";
  return prefix + unfinished + metric_clause(item, measurement, line.points_lost_milli > 0) + " " +
         target_clause(item) + ": " + loss_clause(said) + ".";
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
  if (is_claim(gate.unit)) return gate.title;
  return gate.title + ": " + value_text(value, gate.unit) + " (limit " +
         short_number_text(gate.limit) + " " + gate.unit + ")";
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
  if (is_claim(gate.unit))
    return gate.title + (result.is_triggered ? ": yes; " + cap : ": no") + ".";
  const std::string limit = short_number_text(gate.limit) + " " + gate.unit;
  const std::string value = gate.title + ": " + value_text(result.value, gate.unit);
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

void choose_sentences(ScoreCard& card) {
  card.sentences.clear();
  if (card.measured_milli == 0) {
    card.sentences.push_back("Nothing of this attempt could be measured, so its score is 0.");
    return;
  }
  std::vector<std::size_t> order(card.ledger.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return card.ledger[a].points_lost_milli > card.ledger[b].points_lost_milli;
  });
  for (const std::size_t index : order) {
    const LedgerLine& line = card.ledger[index];
    if (line.points_lost_milli == 0 || card.sentences.size() == sentence_limit) break;
    card.sentences.push_back(line.text);
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
    const bool is_measured = measurement != nullptr && measurement->is_measured;
    card.gates[index].text = gate_text(card.gates[index], gate, is_measured);
  }
  choose_sentences(card);
}

}  // namespace hallux::assessment

#include "assessment/sentences.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "assessment/ledger.h"
#include "assessment/number_text.h"

namespace hallux::assessment {

namespace {

using database::GateResult;
using database::LedgerKind;
using database::LedgerLine;
using database::ScoreCard;
using scenarios::Gate;
using scenarios::RubricItem;
using scenarios::Scenario;

constexpr std::size_t sentence_limit = 3;

/// How a metric is said: `subject` + value + `tail` (+ direction after `lean`).
struct Wording {
  const char* metric;
  const char* subject;
  const char* tail;
  const char* lean;
};

constexpr Wording wordings[] = {
    {"angle_deg", "The face is tilted ", "", ", deepest at its "},
    {"location_mm", "The face lies up to ", " from the plan", ", there too far "},
    {"depth_mm", "At the depth landmark the face is ", " from the planned depth", ", too far "},
    {"step_mm", "At the exit the face is ", " off the planned one", ", too far "},
    {"notch_mm", "At the exit the face runs ", " into the bone that is kept", ""},
    {"past_landmark_mm", "The face passes ", " beyond the landmark", ""},
    {"flatness_mm", "The blade wandered ", " out of its plane", ""},
    {"wedge_angle_deg", "The wedge is ", " from the planned angle", ""},
    {"sagittal_wedge_deg", "The wedge leans ", " in the sagittal plane", ""},
    {"hinge_mm", "The hinge is ", " thick", ""},
};

const Wording* wording_of(const std::string& metric) noexcept {
  for (const Wording& wording : wordings) {
    if (metric == wording.metric) return &wording;
  }
  return nullptr;
}

std::string metric_clause(const std::string& metric, const std::string& title,
                          const Measurement& measurement, const std::string& unit, bool is_loss) {
  const std::string value = value_text(measurement.value, unit);
  const Wording* wording = wording_of(metric);
  if (wording == nullptr) return title + ": " + value;
  std::string text = wording->subject + value + wording->tail;
  // A direction helps to mend a loss; where nothing was lost it would only sound like one.
  const bool has_direction = is_loss && !measurement.direction.empty() && wording->lean[0] != '\0';
  if (!has_direction) return text;
  text += wording->lean + measurement.direction;
  return metric == "angle_deg" ? text + " edge" : text;
}

std::string loss_clause(const LedgerLine& line) {
  if (line.points_lost_milli == 0) return "all " + points_text(line.weight_milli) + " points";
  return points_text(line.points_lost_milli) + " of " + points_text(line.weight_milli) +
         " points lost";
}

std::string target_clause(const RubricItem& item) {
  if (item.is_band) {
    return "(full points from " + short_number_text(item.full_low) + " to " +
           short_number_text(item.full_high) + " " + item.unit + ")";
  }
  return "(full points to " + short_number_text(item.full) + " " + item.unit + ")";
}

/// With one cut the sentence needs no name; with several each says which it is about.
std::string cut_prefix(const Scenario& scenario, const std::string& cut_name) {
  if (scenario.cuts.size() < 2) return "";
  for (const scenarios::ReferenceCut& cut : scenario.cuts) {
    if (cut.name == cut_name) return cut.title + ": ";
  }
  return "";
}

std::string item_sentence(const Scenario& scenario, const RubricItem& item, const LedgerLine& line,
                          const Measurement& measurement) {
  const std::string prefix = cut_prefix(scenario, item.cut);
  if (!line.is_measured) {
    return prefix + item.title +
           " could not be measured because the cut was not made: " + loss_clause(line) + ".";
  }
  const bool is_unfinished = measurement.done_fraction < 1.0;
  const std::string done = number_text(100.0 * measurement.done_fraction, 0) + " %";
  const std::string unfinished =
      is_unfinished ? "Unfinished cut (" + done + " sawn, so " + done + " of the points). " : "";
  return prefix + unfinished +
         metric_clause(item.metric, item.title, measurement, item.unit,
                       line.points_lost_milli > 0) +
         " " + target_clause(item) + ": " + loss_clause(line) + ".";
}

std::string damping_sentence(const LedgerLine& line) {
  const std::string reached = number_text(100.0 * line.value, 0) + " %";
  const std::string needed = number_text(100.0 * line.target, 0) + " %";
  if (line.points_lost_milli == 0) {
    return "Accuracy reached " + reached + " of its points (" + needed +
           " needed), so efficiency counts in full.";
  }
  return "Accuracy reached " + reached + " of its points; below " + needed +
         " efficiency counts less: " + points_text(line.points_lost_milli) + " of " +
         points_text(line.weight_milli) + " points lost.";
}

std::string gate_sentence(const Gate& gate, const LedgerLine& line) {
  const std::string head = gate.title + ": " + value_text(line.value, gate.unit) + " (limit " +
                           short_number_text(gate.limit) + " " + gate.unit +
                           "), so the score is capped at " + points_text(gate.cap_milli);
  if (line.points_lost_milli == 0) return head + "; it was not above that.";
  return head + ": " + points_text(line.points_lost_milli) + " points lost.";
}

std::string gate_text(const GateResult& result, const Gate& gate, bool is_measured) {
  const std::string cap = "the score is capped at " + points_text(gate.cap_milli);
  const std::string limit = short_number_text(gate.limit) + " " + gate.unit;
  if (!is_measured) return gate.title + ": not measured.";
  const std::string value = gate.title + ": " + value_text(result.value, gate.unit);
  if (result.is_triggered) return value + ", above the limit of " + limit + "; " + cap + ".";
  return value + ", within the limit of " + limit + ".";
}

void explain_line(LedgerLine& line, const Scenario& scenario,
                  std::span<const Measurement> measurements) {
  if (line.kind == LedgerKind::Damping) {
    line.text = damping_sentence(line);
    return;
  }
  for (const Gate& gate : scenario.rubric.gates) {
    if (line.kind == LedgerKind::Gate && gate.name == line.item) {
      line.text = gate_sentence(gate, line);
    }
  }
  for (const RubricItem& item : scenario.rubric.items) {
    if (line.kind != LedgerKind::Metric || item.id != line.item) continue;
    const Measurement* measurement = find_measurement(measurements, item.metric, item.cut);
    if (measurement != nullptr) line.text = item_sentence(scenario, item, line, *measurement);
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
  for (LedgerLine& line : card.ledger) explain_line(line, scenario, measurements);
  for (std::size_t index = 0; index < card.gates.size(); ++index) {
    const Gate& gate = scenario.rubric.gates[index];
    const Measurement* measurement = find_measurement(measurements, gate.metric, gate.cut);
    const bool is_measured = measurement != nullptr && measurement->is_measured;
    card.gates[index].text = gate_text(card.gates[index], gate, is_measured);
  }
  choose_sentences(card);
}

}  // namespace hallux::assessment

/// A sentence is put together from clauses: subject, value, which way, full points, loss. The
/// wordings stand with the metric's name (scenarios/metric_names.h), so a new metric brings its
/// own. The number of points comes from shown_points, never from the rubric: a reader adds them up.
#include "assessment/sentences.h"

#include <algorithm>
#include <string>

#include "assessment/measurement.h"
#include "assessment/number_text.h"
#include "assessment/shown_points.h"
#include "scenarios/metric_names.h"

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
using scenarios::MetricWording;

std::string share_text(double fraction) { return number_text(100.0 * fraction, 0) + " %"; }

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// Values and words of a detail; what a card lacks is empty.
double value_of(const Detail& detail, std::size_t index) {
  return index < detail.values.size() ? detail.values[index] : 0.0;
}
std::string word_of(const Detail& detail, std::size_t index) {
  return index < detail.words.size() ? detail.words[index] : "";
}

std::string edges_text(const Detail& detail) {
  // Half of what two decimals show.
  constexpr double as_planned_mm = 0.005;
  const auto said = [&](std::size_t edge) {
    const double off_mm = value_of(detail, edge);
    if (off_mm < as_planned_mm) return std::string("as planned");
    return value_text(off_mm, "mm") + " too far " + word_of(detail, edge);
  };
  return "there " + said(0) + ", opposite " + said(1);
}

std::string wedge_text(const Detail& detail) {
  return value_text(value_of(detail, 0), "deg") + " were taken out, the plan was " +
         value_text(value_of(detail, 1), "deg") + "; the base is " +
         value_text(value_of(detail, 2), "mm") + " wide, the plan was " +
         value_text(value_of(detail, 3), "mm");
}

std::string detail_text(const Detail& detail) {
  switch (detail.kind) {
    case DetailKind::EdgesOff:
      return edges_text(detail);
    case DetailKind::NearestJoint:
      return "nearest to the " + word_of(detail, 0);
    case DetailKind::Zones:
      return joined(detail.words);
    case DetailKind::Hottest:
      return "the hottest reached " + value_text(value_of(detail, 0), "degrees Celsius");
    case DetailKind::WedgeTaken:
      return wedge_text(detail);
    case DetailKind::TipsToe:
      return "closing it tips the toe";
    case DetailKind::FeltThrough:
      return "the hand felt " + value_text(value_of(detail, 0), "N") + " as it broke through";
    case DetailKind::None:
      break;
  }
  return "";
}

/// A sentence that closes its line, with a blank before it; or nothing.
std::string remark_text(Remark remark) {
  switch (remark) {
    case Remark::SawnAfterDone:
      return " Some of this cut was sawn after Done; it counts as well.";
    case Remark::Assumed:
      return " Assumed, not measured.";
    case Remark::None:
      break;
  }
  return "";
}

std::string direction_clause(const MetricWording& wording, const LineFacts& facts) {
  if (facts.direction.empty() || wording.lean[0] == '\0') return "";
  return wording.lean + facts.direction + wording.lean_end;
}

std::string metric_clause(const LedgerLine& line) {
  const LineFacts& facts = line.facts;
  const std::string value = value_text(line.value, line.unit);
  const scenarios::MetricName* metric = scenarios::find_metric(line.metric);
  if (metric == nullptr) return facts.title + ": " + value;
  if (metric->is_claim) return facts.title + (line.value > 0.5 ? ": yes" : ": no");
  const MetricWording& wording = metric->wording;
  const bool is_zero = line.value == 0.0 && wording.at_zero[0] != '\0';
  std::string text = is_zero ? wording.at_zero : wording.subject + value + wording.tail;
  // A direction and more numbers help to mend a loss; where nothing was lost they would only sound
  // like one.
  if (line.points_lost_milli == 0) return text;
  const std::string detail = detail_text(facts.detail);
  return text + direction_clause(wording, facts) + (detail.empty() ? "" : ": " + detail);
}

std::string loss_clause(const LedgerLine& line, const ShownLine& shown) {
  const std::string possible = points_text(shown.possible_milli);
  if (line.points_lost_milli == 0) return "all " + possible + " points";
  return lost_points_text(line, shown) + " of " + possible + " points lost";
}

/// " (full points to 1°)"; of a claim nothing.
std::string target_clause(const LedgerLine& line) {
  if (scenarios::is_claim(line.metric)) return "";
  const LineFacts& facts = line.facts;
  const std::string high = with_unit(short_number_text(facts.target_high), line.unit);
  switch (facts.target) {
    case TargetKind::Between:
      return " (full points from " + short_number_text(facts.target_low) + " to " + high + ")";
    case TargetKind::AtLeast:
      return " (full points from " + high + ")";
    case TargetKind::AtMost:
      break;
  }
  return " (full points to " + high + ")";
}

/// "Unfinished cut (62 % sawn, so 62 % of the points). ", or nothing.
std::string unfinished_clause(const LedgerLine& line) {
  if (line.facts.done_fraction >= 1.0) return "";
  const std::string done = share_text(line.facts.done_fraction);
  const scenarios::MetricName* metric = scenarios::find_metric(line.metric);
  const bool is_of_work =
      metric != nullptr && (metric->subject == scenarios::MetricSubject::Attempt ||
                            metric->subject == scenarios::MetricSubject::Zone);
  return std::string("Unfinished ") + (is_of_work ? "work" : "cut") + " (" + done + " sawn, so " +
         done + " of the points). ";
}

std::string item_sentence(const LedgerLine& line, const ShownLine& shown) {
  const LineFacts& facts = line.facts;
  const std::string prefix = facts.subject.empty() ? "" : facts.subject + ": ";
  if (!line.is_measured)
    return prefix + facts.title + " could not be measured because " +
           std::string(reason_of(facts.absence)) + ": " + loss_clause(line, shown) + ".";
  return prefix + unfinished_clause(line) + metric_clause(line) + target_clause(line) + ": " +
         loss_clause(line, shown) + "." + remark_text(facts.remark);
}

std::string damping_sentence(const LedgerLine& line, const ShownLine& shown) {
  const std::string reached = share_text(line.value), needed = share_text(line.target);
  if (line.points_lost_milli == 0) {
    return "Accuracy reached " + reached + " of its points (" + needed +
           " needed), so efficiency counts in full.";
  }
  return "Accuracy reached " + reached + " of its points; below " + needed +
         " efficiency counts less: " + loss_clause(line, shown) + ".";
}

/// "Title: 1.50 mm (limit 1 mm)", or of a claim the title alone.
std::string gate_finding(const GateResult& gate) {
  if (scenarios::is_claim(gate.metric)) return gate.title;
  return gate.title + ": " + value_text(gate.value, gate.unit) +
         (gate.is_at_least ? " (at least " : " (limit ") +
         with_unit(short_number_text(gate.limit), gate.unit) + ")";
}

std::string gate_sentence(const GateResult& gate, const LedgerLine& line, const ShownLine& shown) {
  const std::string head =
      gate_finding(gate) + ", so the score is capped at " + points_text(gate.cap_milli);
  if (line.points_lost_milli == 0) return head + "; it was not above that.";
  return head + ": " + lost_points_text(line, shown) + " points lost.";
}

std::string gate_text(const GateResult& gate) {
  const std::string cap = "the score is capped at " + points_text(gate.cap_milli);
  if (!gate.is_measured) return gate.title + ": not measured.";
  if (scenarios::is_claim(gate.metric))
    return gate.title + (gate.is_triggered ? ": yes; " + cap : ": no") + ".";
  const std::string limit = with_unit(short_number_text(gate.limit), gate.unit);
  const std::string value = gate.title + ": " + value_text(gate.value, gate.unit);
  if (gate.is_at_least)
    return value + (gate.is_triggered ? ", less than the " + limit + " asked for; " + cap + "."
                                      : ", no less than the " + limit + " asked for.");
  if (gate.is_triggered) return value + ", above the limit of " + limit + "; " + cap + ".";
  return value + ", within the limit of " + limit + ".";
}

std::string line_sentence(const ScoreCard& card, const LedgerLine& line, const ShownLine& shown) {
  switch (line.kind) {
    case LedgerKind::Damping:
      return damping_sentence(line, shown);
    case LedgerKind::Gate: {
      const auto gate = std::ranges::find(card.gates, line.item, &GateResult::name);
      return gate == card.gates.end() ? "" : gate_sentence(*gate, line, shown);
    }
    case LedgerKind::Metric:
      break;
  }
  return item_sentence(line, shown);
}

std::string message_text(const ScoreCard& card, const Message& message) {
  const std::string lost = points_text(message.lost_milli) + " points lost.";
  const std::string subject = message.subject.empty() ? "" : message.subject + ": ";
  const std::string done = share_text(message.done_fraction);
  switch (message.kind) {
    case MessageKind::CutNotMade:
      return subject + "The cut was not made: " + lost;
    case MessageKind::CutUnfinished:
      return subject + "Unfinished cut: " + done + " was sawn, so what it is worth counts " + done +
             ". With its other losses that is " + lost;
    case MessageKind::NothingMeasured:
      return "Nothing of this attempt could be measured, so its score is 0.";
    case MessageKind::Line:
      break;
  }
  const auto line = static_cast<std::size_t>(message.line);
  return line < card.ledger.size() ? card.ledger[line].text : "";
}

}  // namespace

void say(ScoreCard& card) {
  if (card.form == database::CardForm::Words) return;
  const ShownPoints shown = shown_points(card);
  for (std::size_t line = 0; line < card.ledger.size(); ++line)
    card.ledger[line].text = line_sentence(card, card.ledger[line], shown.lines[line]);
  for (GateResult& gate : card.gates) gate.text = gate_text(gate);
  card.sentences.clear();
  for (const Message& message : card.messages)
    card.sentences.push_back(message_text(card, message));
}

}  // namespace hallux::assessment

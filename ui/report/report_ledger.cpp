#include "ui/report/report_ledger.h"

#include "assessment/number_text.h"
#include "ui/report/html_text.h"

namespace hallux::ui {

namespace {

using assessment::points_text;
using database::GateResult;
using database::GroupScore;
using database::LedgerKind;
using database::LedgerLine;
using database::ScoreCard;

constexpr const char* minus_sign = "\xE2\x88\x92";

std::string title_of(const std::vector<std::string>& titles, std::size_t index,
                     const std::string& name) {
  return index < titles.size() && !titles[index].empty() ? titles[index] : name;
}

std::string percent(std::int64_t part, std::int64_t whole) {
  const double fraction = static_cast<double>(part) / static_cast<double>(whole);
  return assessment::number_text(100.0 * fraction, 2) + "%";
}

std::string group_row(const GroupScore& group, const std::string& title) {
  const bool is_measured = group.measured_milli > 0;
  std::string row = "<div class=\"group\"><span class=\"name\">" + escaped(title) + "</span>";
  row += is_measured ? "<span class=\"bar\"><i style=\"width:" +
                           percent(group.earned_milli, group.measured_milli) + "\"></i></span>"
                     : "<span class=\"bar none\"></span>";
  row += "<span class=\"number\">";
  row += is_measured ? "<b>" + points_text(group.earned_milli) + "</b> of " +
                           points_text(group.measured_milli)
                     : "not measured yet (" + points_text(group.weight_milli) + ")";
  return row + "</span></div>";
}

/// Shape goes with every colour: what is right has a tick, what is wrong a cross, what is unknown a ring.
std::string gate_row(const GateResult& gate, const std::string& title) {
  const bool is_known = gate.text.find("not measured") == std::string::npos;
  const char* state = gate.is_triggered ? "bad" : (is_known ? "good" : "unknown");
  const char* shape =
      gate.is_triggered ? "\xE2\x9C\x95" : (is_known ? "\xE2\x9C\x93" : "\xE2\x97\x8B");
  const std::string text = gate.text.empty() ? title : gate.text;
  return "<li class=\"" + std::string(state) + "\"><span class=\"shape\">" + shape + "</span>" +
         escaped(text) + "</li>";
}

std::string moment_cell(const LedgerLine& line) {
  if (!line.is_measured || line.end_us == 0) return "\xE2\x80\x93";
  std::string start = assessment::moment_text(line.start_us);
  // A single tick is a moment; anything longer is a stretch of the attempt.
  if (line.end_us - line.start_us <= 1000) return start;
  return start + " \xE2\x80\x93 " + assessment::moment_text(line.end_us);
}

std::string value_cell(const LedgerLine& line) {
  if (!line.is_measured) return "\xE2\x80\x93";
  if (line.kind == LedgerKind::Damping)
    return assessment::number_text(100.0 * line.value, 0) + " %";
  return assessment::value_text(line.value, line.unit);
}

std::string loss_cell(std::int64_t loss_milli) {
  return loss_milli == 0 ? "0" : minus_sign + points_text(loss_milli);
}

std::string ledger_row(const LedgerLine& line, std::int64_t shown_milli) {
  const bool is_gate = line.kind == LedgerKind::Gate;
  std::string row = line.points_lost_milli > 0 ? "<tr class=\"lost\">" : "<tr>";
  row += "<td class=\"item\">" + escaped(is_gate ? "Gate" : line.item) + "</td>";
  row += "<td class=\"text\">" + escaped(line.text) + "</td>";
  row += "<td class=\"number\">" + escaped(value_cell(line)) + "</td>";
  row += "<td class=\"number moment\">" + moment_cell(line) + "</td>";
  row += "<td class=\"number\">" + loss_cell(line.points_lost_milli) + "</td>";
  return row + "<td class=\"number\">" + loss_cell(shown_milli) + "</td></tr>";
}

std::string sum_row(const ScoreCard& card) {
  std::int64_t lost_milli = 0, shown_milli = 0;
  for (const LedgerLine& line : card.ledger) lost_milli += line.points_lost_milli;
  for (const std::int64_t shown : card.shown_losses_milli) shown_milli += shown;
  return "<tr class=\"sum\"><td></td><td class=\"text\">Earned " + points_text(card.earned_milli) +
         " of the " + points_text(card.measured_milli) + " points that were measured; score " +
         points_text(card.score_milli) + "</td><td></td><td></td><td class=\"number\">" +
         loss_cell(lost_milli) + "</td><td class=\"number\">" + loss_cell(shown_milli) +
         "</td></tr>";
}

}  // namespace

std::string groups_html(const ReportMaterial& material) {
  std::string html = "<div class=\"groups\">";
  for (std::size_t index = 0; index < material.card.groups.size(); ++index) {
    const GroupScore& group = material.card.groups[index];
    html += group_row(group, title_of(material.group_titles, index, group.name));
  }
  return html + "</div>";
}

std::string gates_html(const ReportMaterial& material) {
  if (material.card.gates.empty()) return "";
  std::string html = "<section><h2>Gates</h2><ul class=\"gates\">";
  for (std::size_t index = 0; index < material.card.gates.size(); ++index) {
    const GateResult& gate = material.card.gates[index];
    html += gate_row(gate, title_of(material.gate_titles, index, gate.name));
  }
  return html + "</ul></section>";
}

std::string ledger_html(const ReportMaterial& material) {
  const ScoreCard& card = material.card;
  std::string html =
      "<section><h2>Where the points went</h2><table><thead><tr><th>Item</th><th>What was found"
      "</th><th class=\"number\">Value</th><th class=\"number\">Moment</th>"
      "<th class=\"number\">Points</th><th class=\"number\">Of 100</th></tr></thead><tbody>";
  for (std::size_t index = 0; index < card.ledger.size(); ++index) {
    const bool is_shown = index < card.shown_losses_milli.size();
    html += ledger_row(card.ledger[index], is_shown ? card.shown_losses_milli[index] : 0);
  }
  return html + sum_row(card) + "</tbody></table></section>";
}

std::string partial_text(const ScoreCard& card) {
  if (card.measured_milli >= card.rubric_milli) return "";
  return "partial: measures " + points_text(card.measured_milli) + " of " +
         points_text(card.rubric_milli) + " points";
}

}  // namespace hallux::ui

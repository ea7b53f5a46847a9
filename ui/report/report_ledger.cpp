#include "ui/report/report_ledger.h"

#include "assessment/number_text.h"
#include "assessment/shown_points.h"
#include "ui/report/html_text.h"
#include "ui/report/measured_text.h"

namespace hallux::ui {

namespace {

using assessment::points_text;
using assessment::ShownGroup;
using assessment::ShownLine;
using assessment::ShownPoints;
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

std::string group_row(const GroupScore& group, const ShownGroup& shown, const std::string& title) {
  const bool is_measured = group.measured_milli > 0;
  std::string row = "<div class=\"group\"><span class=\"name\">" + escaped(title) + "</span>";
  row += is_measured ? "<span class=\"bar\"><i style=\"width:" +
                           percent(shown.earned_milli, shown.possible_milli) + "\"></i></span>"
                     : "<span class=\"bar none\"></span>";
  row += "<span class=\"number\">";
  row += is_measured ? "<b>" + points_text(shown.earned_milli) + "</b> of " +
                           points_text(shown.possible_milli)
                     : "not measured yet";
  return row + "</span></div>";
}

/// Shape goes with every colour: what is right has a tick, what is wrong a cross, what is unknown a
/// ring.
std::string gate_row(const GateResult& gate, const std::string& title) {
  const bool is_known = gate.text.find("not measured") == std::string::npos;
  const char* state = gate.is_triggered ? "bad" : (is_known ? "good" : "unknown");
  const char* shape =
      gate.is_triggered ? "\xE2\x9C\x95" : (is_known ? "\xE2\x9C\x93" : "\xE2\x97\x8B");
  const std::string text = gate.text.empty() ? title : gate.text;
  return "<li class=\"" + std::string(state) + "\"><span class=\"shape\">" + shape + "</span>" +
         escaped(text) + "</li>";
}

/// Only metrics have an id of the rubric's.
std::string item_cell(const LedgerLine& line) {
  if (line.kind == LedgerKind::Gate) return "Gate";
  return line.kind == LedgerKind::Damping ? "\xE2\x80\x93" : line.item;
}

std::string moment_cell(const LedgerLine& line) {
  if (!line.is_measured || line.end_us == 0) return "\xE2\x80\x93";
  std::string start = assessment::moment_text(line.start_us);
  // A single tick is a moment; anything longer is a stretch of the attempt.
  if (line.end_us - line.start_us <= 1000) return start;
  return start + " \xE2\x80\x93 " + assessment::moment_text(line.end_us);
}

std::string loss_cell(const LedgerLine& line, const ShownLine& shown) {
  const std::string loss = assessment::lost_points_text(line, shown);
  return shown.lost_milli == 0 ? loss : minus_sign + loss;
}

std::string ledger_row(const LedgerLine& line, const ShownLine& shown) {
  std::string row = line.points_lost_milli > 0 ? "<tr class=\"lost\">" : "<tr>";
  row += "<td class=\"item\">" + escaped(item_cell(line)) + "</td>";
  row += "<td class=\"text\">" + escaped(line.text) + "</td>";
  row += "<td class=\"number\">" + escaped(measured_text(line)) + "</td>";
  row += "<td class=\"number moment\">" + moment_cell(line) + "</td>";
  return row + "<td class=\"number\">" + loss_cell(line, shown) + "</td></tr>";
}

/// The row that shows that nothing is missing: score and losses are the 100 points.
std::string sum_row(const ShownPoints& shown) {
  std::int64_t lost_milli = 0;
  for (const ShownLine& line : shown.lines) lost_milli += line.lost_milli;
  const std::string lost = points_text(lost_milli);
  return "<tr class=\"sum\"><td></td><td class=\"text\">Score " + points_text(shown.score_milli) +
         " + " + lost + " lost = " + points_text(shown.score_milli + lost_milli) +
         " points</td><td></td><td></td><td class=\"number\">" +
         (lost_milli == 0 ? lost : minus_sign + lost) + "</td></tr>";
}

}  // namespace

std::string groups_html(const ReportMaterial& material) {
  const ShownPoints shown = assessment::shown_points(material.card);
  std::string html = "<div class=\"groups\">";
  for (std::size_t index = 0; index < material.card.groups.size(); ++index) {
    const GroupScore& group = material.card.groups[index];
    html +=
        group_row(group, shown.groups[index], title_of(material.group_titles, index, group.name));
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
  const ShownPoints shown = assessment::shown_points(card);
  std::string html =
      "<section><h2>Where the points went</h2><table><thead><tr><th>Item</th><th>What was found"
      "</th><th class=\"number\">Value</th><th class=\"number\">Moment</th>"
      "<th class=\"number\">Points</th></tr></thead><tbody>";
  for (std::size_t index = 0; index < card.ledger.size(); ++index)
    html += ledger_row(card.ledger[index], shown.lines[index]);
  return html + sum_row(shown) + "</tbody></table></section>";
}

std::string partial_text(const ScoreCard& card) {
  if (card.measured_milli >= card.rubric_milli) return "";
  return "partial: " + assessment::measured_share_text(card) + " of the rubric is measured";
}

}  // namespace hallux::ui

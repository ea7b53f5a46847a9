#include "ui/report/score_sheet.h"

#include <algorithm>

#include "assessment/number_text.h"
#include "assessment/shown_points.h"
#include "ui/report/report_facts.h"
#include "ui/report/report_ledger.h"

namespace hallux::ui {

namespace {

using assessment::points_text;
using assessment::ShownGroup;
using assessment::ShownLine;
using assessment::ShownPoints;
using database::GateResult;
using database::GroupScore;
using database::LedgerLine;
using database::ScoreCard;

constexpr std::size_t columns = 100;
constexpr std::size_t name_columns = 14;
constexpr std::int64_t bar_columns = 30;

/// What a terminal would obey is replaced; the sheet is text only.
std::string printable(const std::string& text) {
  std::string safe = text;
  std::replace_if(
      safe.begin(), safe.end(),
      [](char letter) { return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F; }, ' ');
  return safe;
}

std::string padded(const std::string& text, std::size_t width) {
  return text.size() < width ? text + std::string(width - text.size(), ' ') : text;
}

std::string right_aligned(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string repeated(const std::string& sign, std::int64_t count) {
  std::string text;
  for (std::int64_t index = 0; index < count; ++index) text += sign;
  return text;
}

/// Words broken over lines that begin with `indent` spaces; the first line's indent is the
/// caller's.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::string result;
  std::size_t used = indent, start = 0;
  while (start < text.size()) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::size_t length = end - start;
    if (used > indent && used + 1 + length > columns) {
      result += "\n" + std::string(indent, ' ');
      used = indent;
    } else if (used > indent) {
      result += ' ';
      ++used;
    }
    result += text.substr(start, length);
    used += length;
    start = end + 1;
  }
  return result + "\n";
}

std::string group_row(const GroupScore& group, const ShownGroup& shown, const std::string& title) {
  std::string row = "  " + padded(printable(title), name_columns);
  if (group.measured_milli == 0) {
    return row + repeated("\xC2\xB7", bar_columns) + "  not measured yet\n";
  }
  const std::int64_t full = shown.earned_milli * bar_columns / shown.possible_milli;
  return row + repeated("\xE2\x96\x88", full) + repeated("\xE2\x96\x91", bar_columns - full) +
         "  " + points_text(shown.earned_milli) + " of " + points_text(shown.possible_milli) + "\n";
}

std::string marks_row(const ReportMaterial& material) {
  const ScoreCard& card = material.card;
  std::string row = printable(material.signature);
  if (!card.is_reviewed) row += "; not surgeon-reviewed";
  const std::string partial = partial_text(card);
  return partial.empty() ? row + "\n" : row + "; " + partial + "\n";
}

std::string ledger_rows(const ScoreCard& card, const ShownPoints& shown) {
  std::string rows;
  for (std::size_t index = 0; index < card.ledger.size(); ++index) {
    const LedgerLine& line = card.ledger[index];
    const ShownLine& points = shown.lines[index];
    const std::string lost = points.lost_milli == 0 && line.points_lost_milli > 0
                                 ? "< 0.1"
                                 : points_text(-points.lost_milli);
    rows += right_aligned(lost, 8) + "  " + wrapped(printable(line.text), 10);
  }
  return rows;
}

}  // namespace

std::string score_sheet(const ReportMaterial& material) {
  const ScoreCard& card = material.card;
  const ShownPoints shown = assessment::shown_points(card);
  const double score = static_cast<double>(shown.score_milli) / 1000.0;
  std::string sheet = printable(material.title) + "\n" + marks_row(material) + "\n";
  sheet += "  Score " + assessment::number_text(score, 1) + " of 100\n\n";
  for (std::size_t index = 0; index < card.groups.size(); ++index) {
    const bool has_title = index < material.group_titles.size();
    sheet += group_row(card.groups[index], shown.groups[index],
                       has_title ? material.group_titles[index] : card.groups[index].name);
  }
  if (!card.gates.empty()) sheet += "\n";
  for (const GateResult& gate : card.gates) {
    sheet += std::string("  ") + (gate.is_triggered ? "x " : "- ") +
             wrapped(printable(gate.text.empty() ? gate.name : gate.text), 4);
  }
  if (!card.ledger.empty()) sheet += "\n  of 100\n" + ledger_rows(card, shown);
  if (!material.quality.empty()) sheet += "\n  " + wrapped(printable(material.quality), 2);
  return sheet;
}

std::string score_sheet(const ScoreCard& card, const scenarios::Scenario& scenario,
                        std::string_view signature) {
  ReportMaterial material;
  material.card = card;
  material.signature = signature;
  add_titles(material, scenario);
  return score_sheet(material);
}

}  // namespace hallux::ui

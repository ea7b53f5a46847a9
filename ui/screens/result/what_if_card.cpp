// Rows as those of what to take away, the greatest gain first, and last what they earn together.
// The attempt is examined once more for it: what the page shows is there long before, and the
// bone's solids would else be kept in memory as long as the page.
#include "ui/screens/result/what_if_card.h"

#include <algorithm>
#include <string>
#include <vector>

#include "simulator/base/progress.h"
#include "ui/screens/result/attempt_source.h"
#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

using database::LedgerLine;

/// Shares of the time, as measured: reading, examining, and trying the changes.
constexpr double read_share = 0.05, examined_share = 0.3;
constexpr float title_height = 52.0F, note_gap = 10.0F, working_height = 24.0F,
                unseen_height = 285.0F;

SaidWhatIf worked_out(SignedInSession& signed_in, const database::AttemptId& attempt,
                      const Progress& reached) {
  const AttemptSource source = attempt_source(signed_in, attempt);
  const AttemptMaterial& material = source.attempt;
  report(reached, read_share);
  const auto examining = [&](const std::string&) {
    return part_of(reached, read_share, examined_share);
  };
  const assessment::WhatIf what_if(material.scenario, material.bones, material.recording,
                                   material.header.begun.device_class,
                                   stamped_examination_of(source, examining));
  return said_what_if(what_if.propose(part_of(reached, examined_share, 1.0)), material.scenario,
                      what_if.examination().plan, what_if.examination().card);
}

/// One change, or all together.
struct WhatIfRow {
  std::string head, body, gain, action;
  std::optional<std::size_t> line;

  MessageRow row() const noexcept { return {Meaning::Info, head, body, gain, action}; }
};

/// Of those lines the first that has a moment.
std::optional<std::size_t> line_to_watch(const std::vector<LedgerLine>& ledger,
                                         const std::vector<std::string>& items) {
  for (std::size_t line = 0; line < ledger.size(); ++line) {
    const bool is_of_items = std::ranges::find(items, ledger[line].item) != items.end();
    if (is_of_items && ledger[line].is_measured && ledger[line].end_us > 0) return line;
  }
  return std::nullopt;
}

std::vector<WhatIfRow> rows_of(const Texts& texts, const SaidWhatIf& said,
                               const std::vector<LedgerLine>& ledger) {
  std::vector<WhatIfRow> rows;
  for (const SaidChange& change : said.changes) {
    WhatIfRow row{change.head, change.body, change.gain, {}, line_to_watch(ledger, change.items)};
    if (row.line)
      row.action = texts.say(
          "result.watch",
          {{"moment", clock_text(static_cast<double>(ledger[*row.line].start_us) / 1.0e6)}});
    rows.push_back(std::move(row));
  }
  if (!said.together.empty())
    rows.push_back({said.together, said.together_score, said.together_gain, {}, {}});
  return rows;
}

}  // namespace

void WhatIfCard::work_out(Ui& ui, Shell& shell, const std::shared_ptr<SignedInSession>& signed_in,
                          const database::AttemptId& attempt) {
  if (!said_.is_new()) return;
  said_.start(ui, shell, ui.text("result.what_if.working"),
              [signed_in, attempt, is_left = is_left_](WorkReport& report) {
                return cancelled_as("stopped before it was worked out", [&] {
                  return worked_out(*signed_in, attempt, [&](double share) {
                    return report.reached(share) && !is_left->load();
                  });
                });
              });
}

float WhatIfCard::height(const Ui& ui, const ResultFacts& facts, float width) const {
  if (!said_.has_value()) return title_height + unseen_height + space::card;
  const SaidWhatIf& said = said_.value();
  const float inside = width - 2.0F * space::card;
  float content = note_gap + ui.paragraph_height(Type::Small, what_if_note(), inside);
  if (!said.nothing.empty()) content += ui.paragraph_height(Type::Body, said.nothing, inside);
  for (const WhatIfRow& each : rows_of(ui.texts(), said, facts.score->card.ledger))
    content += message_row_height(ui, each.row(), inside);
  return title_height + content + space::card;
}

std::optional<std::size_t> WhatIfCard::draw(Ui& ui, const Rect& rect, const ResultFacts& facts) {
  Rect rest = card(ui, rect, ui.text("result.what_if"));
  if (!said_.has_value() && (said_.is_new() || said_.is_running()))
    ui.canvas().text_in(take_top(rest, working_height), {Type::Small, ui.theme().text_caption},
                        ui.text("result.what_if.working"), true);
  if (!said_.draw_until_ready(ui, "result.what_if.unseen", rest, 6)) return std::nullopt;
  const SaidWhatIf& said = said_.value();
  if (!said.nothing.empty())
    take_top(rest,
             ui.canvas().paragraph(rest, {Type::Body, ui.theme().text_secondary}, said.nothing));
  const std::vector<WhatIfRow> rows = rows_of(ui.texts(), said, facts.score->card.ledger);
  std::optional<std::size_t> asked;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const MessageRow row = rows[i].row();
    const Rect place = take_top(rest, message_row_height(ui, row, rest.w));
    if (i > 0) ui.canvas().hairline_across(place.x, place.y, place.w, ui.theme().line);
    if (message_row(ui, "result.what_if." + std::to_string(i), place, row)) asked = rows[i].line;
  }
  take_top(rest, note_gap);
  ui.canvas().paragraph(rest, {Type::Small, ui.theme().text_caption}, what_if_note());
  return asked;
}

}  // namespace hallux::ui

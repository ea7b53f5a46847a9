// The reading cards of a result. Height and drawing are two functions over the same rows, since
// cards beside each other end together. What to take away are the sentences of the card, dearest
// first; where something was done well, one of three rows is kept for that.
#include "ui/screens/result/result_cards.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/pass_mark.h"
#include "scenarios/metric_advice.h"
#include "ui/screens/parts/value_text.h"
#include "ui/times/local_time.h"
#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

using database::Decision;
using database::DecisionKind;
using database::GroupScore;
using database::LedgerLine;
using database::ScoreCard;

constexpr float ring_radius = 72.0F, ring_block = 190.0F, bar_step = 26.0F;
constexpr std::size_t rows_wanted = 3;

const scenarios::Scenario* scenario_of(const ResultFacts& facts) noexcept {
  return facts.scenario ? &*facts.scenario : nullptr;
}

float share_of(std::int64_t part, std::int64_t whole) noexcept {
  return whole > 0 ? static_cast<float>(static_cast<double>(part) / static_cast<double>(whole))
                   : 0.0F;
}

/// A name and below it what is so, with a shape.
void draw_fact(Ui& ui, Rect& rest, std::string_view name, Meaning meaning, std::string_view words) {
  Canvas& canvas = ui.canvas();
  const Rect head = take_top(rest, 20.0F);
  canvas.text_in(head, {Type::Small, ui.theme().text_secondary}, name);
  const Rect line = take_top(rest, 22.0F, 10.0F);
  draw_meaning(canvas, ui.theme(), meaning, {line.x + 7.0F, line.mid_y()}, 6.0F);
  canvas.text_in({line.x + 20.0F, line.y, line.w - 20.0F, line.h},
                 {Type::SmallMedium, ui.theme().text}, words);
}

void draw_pass_fact(Ui& ui, Rect& rest, const ResultFacts& facts) {
  using assessment::PassAnswer;
  const std::string name = ui.texts().say(
      "result.pass_mark", {{"points", std::to_string(assessment::pass_milli / 1000)}});
  const PassAnswer answer =
      assessment::pass_answer(facts.score->card, facts.standing_milli().value_or(0));
  if (facts.header.state == database::AttemptState::Void) {
    draw_fact(ui, rest, name, Meaning::Neutral, ui.text("result.pass.void"));
  } else if (answer == PassAnswer::Reached) {
    draw_fact(ui, rest, name, Meaning::Good, ui.text("result.pass.reached"));
  } else if (answer == PassAnswer::NotReached) {
    draw_fact(ui, rest, name, Meaning::Warn, ui.text("result.pass.not_reached"));
  } else {
    draw_fact(ui, rest, name, Meaning::Neutral, ui.text("result.pass.partial"));
  }
}

void draw_gates_fact(Ui& ui, Rect& rest, const ScoreCard& card) {
  const auto triggered = std::count_if(card.gates.begin(), card.gates.end(),
                                       [](const auto& gate) { return gate.is_triggered; });
  if (triggered == 0) {
    draw_fact(ui, rest, ui.text("result.gates"), Meaning::Good, ui.text("result.gates.none"));
    return;
  }
  draw_fact(ui, rest, ui.text("result.gates"), Meaning::Bad,
            ui.texts().say_count("result.gates.triggered", static_cast<long>(triggered)));
}

void draw_facts(Ui& ui, Rect rest, const ResultFacts& facts) {
  draw_pass_fact(ui, rest, facts);
  draw_gates_fact(ui, rest, facts.score->card);
  const ScoreCard& card = facts.score->card;
  if (facts.standing_milli() != card.score_milli) {
    draw_fact(ui, rest, ui.text("result.machine"), Meaning::Info, points_text(card.score_milli));
  } else if (card.measured_milli < card.rubric_milli) {
    draw_fact(ui, rest, ui.text("result.measured"), Meaning::Warn,
              ui.texts().say("result.measured.share",
                             {{"share", assessment::measured_share_text(card)}}));
  }
}

void draw_group(Ui& ui, const Rect& line, const assessment::ShownGroup& group,
                std::string_view title, float name_width) {
  if (group.possible_milli > 0) {
    const std::string value = points_text(group.earned_milli);
    const std::string maximum = "/ " + possible_text(group);
    named_bar(ui, line, {title, value, maximum, share_of(group.earned_milli, group.possible_milli)},
              name_width);
    return;
  }
  Rect rest = line;
  ui.canvas().text_in(take_left(rest, name_width, 16.0F), {Type::Small, ui.theme().text}, title);
  ui.canvas().text_in(rest, {Type::Small, ui.theme().text_caption, Align::Right},
                      ui.text("result.not_measured"));
}

void draw_groups(Ui& ui, Rect rest, const ResultFacts& facts) {
  const scenarios::Scenario* scenario = scenario_of(facts);
  float name_width = 64.0F;
  for (const GroupScore& group : facts.score->card.groups)
    name_width = std::max(name_width, ui.width_of(Type::Small, group_title(group, scenario)));
  name_width = std::min(std::ceil(name_width) + 1.0F, 0.4F * rest.w);
  const assessment::ShownPoints shown = assessment::shown_points(facts.score->card);
  for (std::size_t group = 0; group < shown.groups.size(); ++group) {
    draw_group(ui, take_top(rest, bar_step), shown.groups[group],
               group_title(facts.score->card.groups[group], scenario), name_width);
  }
}

/// One row of what to take away.
struct Takeaway {
  Meaning meaning = Meaning::Warn;
  std::string head, body, right, action;
  std::optional<std::size_t> line;

  MessageRow row() const noexcept { return {meaning, head, body, right, action}; }
};

Takeaway takeaway_of(const Texts& texts, const ResultFacts& facts, std::size_t index) {
  const LedgerLine& line = facts.score->card.ledger[index];
  const bool is_loss = line.points_lost_milli > 0;
  Takeaway taken;
  taken.meaning = line.kind == database::LedgerKind::Gate ? Meaning::Bad
                  : is_loss                               ? Meaning::Warn
                                                          : Meaning::Good;
  taken.head = item_title(line, scenario_of(facts));
  taken.body = line.text;
  const std::string advice = is_loss ? scenarios::advice_text(line.metric) : "";
  if (!advice.empty()) taken.body += " " + advice;
  const assessment::ShownLine shown = assessment::shown_points(facts.score->card).lines[index];
  taken.right = is_loss ? texts.say("result.points_lost",
                                    {{"points", assessment::lost_points_text(line, shown)}})
                        : std::string(texts.text("result.points_kept"));
  if (line.end_us > 0)
    taken.action = texts.say("result.watch",
                             {{"moment", clock_text(static_cast<double>(line.start_us) / 1.0e6)}});
  taken.line = index;
  return taken;
}

/// The lines that lost nothing, what they are worth first.
std::vector<std::size_t> kept_lines(const ScoreCard& card) {
  std::vector<std::size_t> kept;
  for (std::size_t line = 0; line < card.ledger.size(); ++line) {
    const LedgerLine& each = card.ledger[line];
    if (each.points_lost_milli == 0 && each.is_measured && !each.text.empty() &&
        each.kind == database::LedgerKind::Metric)
      kept.push_back(line);
  }
  std::stable_sort(kept.begin(), kept.end(), [&](std::size_t a, std::size_t b) {
    return card.ledger[a].weight_milli > card.ledger[b].weight_milli;
  });
  return kept;
}

/// What cost the most; and wherever something was done well, that too.
std::vector<Takeaway> takeaways_of(const Texts& texts, const ResultFacts& facts) {
  std::vector<Takeaway> taken;
  if (!facts.score) return taken;
  const ScoreCard& card = facts.score->card;
  const std::vector<std::size_t> kept = kept_lines(card);
  const std::size_t losses_wanted = rows_wanted - (kept.empty() ? 0 : 1);
  for (const std::string& sentence : card.sentences) {
    if (taken.size() == losses_wanted) break;
    if (const auto line = line_of_sentence(card, sentence)) {
      taken.push_back(takeaway_of(texts, facts, *line));
    } else {
      taken.push_back(
          {Meaning::Info, std::string(texts.text("result.whole")), sentence, "", "", {}});
    }
  }
  for (const std::size_t line : kept) {
    if (taken.size() == rows_wanted) break;
    taken.push_back(takeaway_of(texts, facts, line));
  }
  return taken;
}

/// In the order of DecisionKind.
constexpr std::array decision_texts{"result.decision.confirmed", "result.decision.overridden",
                                    "result.decision.voided"};

MessageRow decision_row(const Texts& texts, const Decision& decision, const std::string& right) {
  const Meaning meaning = decision.kind == DecisionKind::Voided       ? Meaning::Bad
                          : decision.kind == DecisionKind::Overridden ? Meaning::Info
                                                                      : Meaning::Good;
  return {decision.is_in_force ? meaning : Meaning::Neutral,
          texts.text(decision_texts[static_cast<std::size_t>(decision.kind)]),
          decision.reason,
          right,
          {}};
}

std::string decided_text(const Texts& texts, const Decision& decision) {
  const std::string name = decider_text(texts, decision);
  const std::string when = full_moment_text(decision.decided_utc);
  if (!decision.score_milli)
    return texts.say("result.decision.by", {{"person", name}, {"moment", when}});
  return texts.say(
      "result.decision.by_with",
      {{"person", name}, {"moment", when}, {"points", points_text(*decision.score_milli)}});
}

constexpr float notice_side = 44.0F;

}  // namespace

float score_card_height(const ResultFacts& facts) noexcept {
  const std::size_t groups = facts.score ? facts.score->card.groups.size() : 0;
  return 20.0F + ring_block + 16.0F + bar_step * static_cast<float>(groups) + 20.0F;
}

void draw_score_card(Ui& ui, const Rect& rect, const ResultFacts& facts) {
  Rect rest = card(ui, rect, {}, space::side_card);
  if (!facts.score) {
    const bool is_never = facts.is_unfinished();
    empty_card(ui, "result.unscored", rest,
               {Icon::Ratings, ui.text(is_never ? "result.not_scored" : "result.unscored"),
                ui.text(is_never ? "result.not_scored.sentence" : "result.unscored.sentence")});
    return;
  }
  Rect head = take_top(rest, ring_block);
  const Rect ring = take_left(head, 2.0F * ring_radius + 32.0F, 20.0F);
  const std::int64_t standing = facts.standing_milli().value_or(0);
  const std::string number = points_text(standing);
  ScoreRing score{.id = "result.ring",
                  .number = number,
                  .below = ui.text("result.of_100"),
                  .share = share_of(standing, 100'000),
                  .pass_share = share_of(assessment::pass_milli, 100'000)};
  score_ring(ui, {ring.mid_x(), ring.mid_y() - 4.0F}, ring_radius, score);
  take_top(head, 16.0F);
  draw_facts(ui, head, facts);
  ui.canvas().hairline_across(rest.x, rest.y, rest.w, ui.theme().line);
  take_top(rest, 14.0F);
  draw_groups(ui, rest, facts);
}

float sentences_card_height(const Ui& ui, const ResultFacts& facts, float width) {
  float height = 52.0F + 16.0F;
  for (const Takeaway& taken : takeaways_of(ui.texts(), facts))
    height += message_row_height(ui, taken.row(), width - 2.0F * space::card);
  return height;
}

std::optional<std::size_t> draw_sentences_card(Ui& ui, const Rect& rect, const ResultFacts& facts) {
  Rect rest = card(ui, rect, ui.text("result.takeaways"));
  const std::vector<Takeaway> taken = takeaways_of(ui.texts(), facts);
  if (taken.empty()) {
    ui.canvas().paragraph(
        rest, {Type::Body, ui.theme().text_secondary},
        ui.text(facts.is_unfinished() ? "result.takeaways.not_scored" : "result.takeaways.none"));
    return std::nullopt;
  }
  std::optional<std::size_t> asked;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    const MessageRow row = taken[i].row();
    const Rect place = take_top(rest, message_row_height(ui, row, rest.w));
    if (i > 0) ui.canvas().hairline_across(place.x, place.y, place.w, ui.theme().line);
    if (message_row(ui, "result.take." + std::to_string(i), place, row)) asked = taken[i].line;
  }
  return asked;
}

float decisions_card_height(const Ui& ui, const ResultFacts& facts, float width) {
  float height = 52.0F + 12.0F;
  for (const Decision& decision : facts.decisions) {
    const std::string right = decided_text(ui.texts(), decision);
    height += message_row_height(ui, decision_row(ui.texts(), decision, right),
                                 width - 2.0F * space::card);
  }
  return height;
}

void draw_decisions_card(Ui& ui, const Rect& rect, const ResultFacts& facts) {
  Rect rest = card(ui, rect, ui.text("result.decisions"));
  for (std::size_t i = 0; i < facts.decisions.size(); ++i) {
    const std::string right = decided_text(ui.texts(), facts.decisions[i]);
    const MessageRow row = decision_row(ui.texts(), facts.decisions[i], right);
    const Rect place = take_top(rest, message_row_height(ui, row, rest.w));
    if (i > 0) ui.canvas().hairline_across(place.x, place.y, place.w, ui.theme().line);
    message_row(ui, "result.decision." + std::to_string(i), place, row);
  }
}

float notice_height(const Ui& ui, std::string_view words, float width) {
  return 24.0F + ui.paragraph_height(Type::Small, words, width - notice_side - 20.0F);
}

void draw_notice(Ui& ui, const Rect& rect, Meaning meaning, std::string_view words) {
  Canvas& canvas = ui.canvas();
  canvas.fill(rect, composed(tint_of(ui.theme(), meaning), ui.theme().card), radius::control);
  draw_meaning(canvas, ui.theme(), meaning, {rect.x + 22.0F, rect.y + 22.0F}, 8.0F);
  canvas.paragraph({rect.x + notice_side, rect.y + 12.0F, rect.w - notice_side - 20.0F, rect.h},
                   {Type::Small, ui.theme().text}, words);
}

}  // namespace hallux::ui

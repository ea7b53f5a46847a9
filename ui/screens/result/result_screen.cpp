// One attempt's result on a page whose height follows its cards. What is stored is shown at once;
// plan against cut and the effects of the tool come when the bone was computed again, then what
// would have earned more, and their cards say so meanwhile. A line of the ledger, its place on the
// bone and its moment are chosen together.
#include "ui/screens/result/result_screen.h"

#include <algorithm>

#include "database/course/score_json.h"
#include "simulator/base/units.h"
#include "ui/report/effects_text.h"
#include "ui/report/measured_text.h"
#include "ui/screens/parts/value_text.h"
#include "ui/screens/result/effects_card.h"
#include "ui/screens/result/recording_card.h"
#include "ui/screens/result/result_cards.h"
#include "ui/times/local_time.h"
#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

using database::LedgerLine;

constexpr float two_columns_from = 860.0F, score_card_width = 400.0F, least_plan_width = 370.0F,
                looking_height = 400.0F, foot_height = 66.0F, hint_top = 12.0F, row_height = 36.0F,
                pill_step = 30.0F, loss_bar_width = 48.0F, title_height = 52.0F,
                unseen_effects_height = 220.0F, head_above = 24.0F, head_below = 16.0F,
                fixed_head_from = 480.0F;

constexpr CellStyle item_cell{Type::Body, &Theme::text};

double second_of(std::int64_t time_us) noexcept { return static_cast<double>(time_us) / 1.0e6; }

/// When points were lost, as a way to that moment; true where it was taken.
bool draw_moment(Ui& ui, const LedgerLine& line, const Rect& cell) {
  if (line.end_us == 0 || !line.is_measured) {
    draw_cell_text(ui, cell, Align::Right, caption_cell, "\xE2\x80\x93");
    return false;
  }
  return link(ui, "result.moment." + line.item, {cell.right(), cell.mid_y()},
              clock_text(second_of(line.start_us)), Align::Right, Type::BodyMedium);
}

}  // namespace

void ResultScreen::read(Ui& ui, Shell& shell) {
  if (facts_.is_new()) {
    facts_.start(ui, shell, ui.text("result.reading"),
                 [signed_in = signed_in_, id = attempt_](WorkReport&) {
                   return read_result(*signed_in, id);
                 });
  }
  // One after the other: each takes a processor.
  if (examined_.is_ready() && facts_.is_ready() && shows_what_if())
    what_if_.work_out(ui, shell, signed_in_, facts().header.id);
  if (!facts_.is_ready() || !examined_.is_new()) return;
  examined_.start(ui, shell, ui.text("result.examining"),
                  [signed_in = signed_in_, id = facts().header.id](WorkReport& report) {
                    return examine_attempt(*signed_in, id, report);
                  });
}

void ResultScreen::compare() {
  if (!facts_.has_value() || !facts_.value().score || !examined_.has_value()) return;
  database::StoredScore& stored = *facts_.value().score;
  const ExaminedAttempt* const examined = examined_.value().get();
  if (compared_.score != stored.id.number || compared_.examined != examined)
    compared_ = {stored.id.number, examined, database::is_same_score(stored.card, examined->card)};
  // A card that was read again has its own words again.
  if (compared_.is_same && stored.card.sentences != examined->card.sentences)
    adopt_words(stored.card, examined->card);
}

void ResultScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  compare();
  read(ui, shell);
  // What the store lacked was computed and kept: it is read as all else that is stored.
  const bool is_waiting = facts_.is_ready() && !facts().score;
  if (is_waiting && examined_.is_ready() && examined_.value()->was_stored) facts_.read_again();
  if (!facts_.draw_until_ready(ui, "result.failed", inset(content, space::page), 10)) return;
  Rect view = content;
  const bool has_fixed_head = content.h >= fixed_head_from;
  if (has_fixed_head) {
    Rect head = inset(content, space::page, 0.0F);
    head.y += head_above;
    take_top(view, head_above + draw_head(ui, head) + head_below - 4.0F);
  }
  const float height = std::max(page_height_, view.h);
  const float offset = ui.begin_scroll("result.page", ui.text("result.page"), view, height);
  Rect page = inset(view, space::page, 0.0F);
  page.y -= offset;
  draw_page(ui, page, has_fixed_head, shell);
  ui.end_scroll();
  draw_forms(ui, shell);
}

// Who reads on keeps the way to the replay and to a question: the head stays, but where the window
// is too low for it.
void ResultScreen::draw_page(Ui& ui, Rect page, bool has_fixed_head, Shell& shell) {
  const float top = page.y, view = page.h;
  page.h = 100000.0F;
  if (has_fixed_head) {
    take_top(page, 4.0F);
  } else {
    take_top(page, head_above);
    take_top(page, draw_head(ui, page), head_below);
  }
  take_top(page, draw_notices(ui, page));
  take_top(page, draw_reading_cards(ui, page), space::between_cards);
  const float effects = effects_card_height(ui, page.w);
  // For those who decide; where it may not be graded everybody reads why.
  const bool is_recording_shown = facts().rights.may_decide || facts().header.is_valid == false;
  const float recording = is_recording_shown ? recording_card_height(ui, facts(), page.w) : 0.0F;
  const float what_if = shows_what_if() ? what_if_.height(ui, facts(), page.w) : 0.0F;
  const float below = effects + recording + what_if + 3.0F * space::between_cards;
  const float left = view - (page.y - top) - below - space::page;
  take_top(page, draw_looking_cards(ui, page, std::max(looking_height, left), shell),
           space::between_cards);
  if (shows_what_if()) {
    const Rect rect = take_top(page, what_if, space::between_cards);
    if (const auto line = what_if_.draw(ui, rect, facts())) watch(*line);
  }
  draw_effects_card(ui, take_top(page, effects));
  if (!facts().decisions.empty()) {
    take_top(page, space::between_cards);
    const float height = decisions_card_height(ui, facts(), page.w);
    draw_decisions_card(ui, take_top(page, height), facts());
  }
  if (is_recording_shown) {
    take_top(page, space::between_cards);
    draw_recording_card(ui, take_top(page, recording), facts());
  }
  const float height = page.y - top + space::page;
  if (std::abs(height - page_height_) > 0.5F) ui.want_frame_in_s(0.0);
  page_height_ = height;
}

float ResultScreen::draw_head(Ui& ui, const Rect& place) {
  const database::AttemptHeader& header = facts().header;
  Canvas& canvas = ui.canvas();
  std::string where = scenario() != nullptr ? scenario()->title : header.scenario_name;
  if (header.begun.person != signed_in_->person().id && !header.login.empty())
    where = ui.texts().say("result.of_person", {{"operation", where}, {"person", header.login}});
  std::string when = full_moment_text(header.started_utc);
  if (header.duration_ticks)
    when = ui.texts().say(
        "result.when",
        {{"moment", when}, {"duration", clock_text(second_from_tick(*header.duration_ticks))}});
  Rect rest = place;
  Rect crumb = take_top(rest, 20.0F, 4.0F);
  const float when_width = std::min(ui.width_of(Type::Small, when) + 2.0F, 0.5F * crumb.w);
  canvas.text_in(take_right(crumb, when_width, 16.0F),
                 {Type::Small, ui.theme().text_caption, Align::Right}, when, true);
  canvas.text_in(crumb, {Type::Small, ui.theme().text_caption}, where, true);
  const std::string title =
      ui.texts().say("result.title", {{"number", grouped(static_cast<long>(header.number))}});
  Rect line = take_top(rest, 40.0F, 8.0F);
  const float title_width =
      canvas.text_on_baseline({line.x, line.y + 30.0F}, {Type::Title, ui.theme().text}, title);
  const bool is_narrow = line.w < 620.0F;
  if (is_narrow) {
    draw_actions(ui, take_top(rest, 40.0F, 8.0F));
    return rest.y - place.y + draw_marks(ui, rest);
  }
  line.w -= draw_actions(ui, line) + 16.0F;
  take_left(line, title_width + 20.0F);
  float marks_width = 0.0F;
  for (const ScoreMark& mark : score_marks(ui.texts(), facts()))
    marks_width += pill_width(ui, mark.words, mark.has_shape) + 8.0F;
  if (marks_width > line.w) return rest.y - place.y + draw_marks(ui, rest);
  draw_marks(ui, {line.x, line.mid_y() - 11.0F, line.w, 22.0F});
  return rest.y - place.y;
}

float ResultScreen::draw_actions(Ui& ui, Rect line) {
  const float whole = line.w;
  const auto action = [&](const char* id, const ButtonSpec& spec) {
    const float width = std::min(button_width(ui, spec), line.w);
    const Rect place = take_right(line, width, 8.0F);
    return button(ui, id, {place.x, place.mid_y() - 18.0F, place.w, header_button_height}, spec);
  };
  ButtonSpec replay{ui.text("result.replay"), ButtonLook::Primary, Icon::Play};
  if (action("result.replay", replay)) {
    navigator_.show_replay(facts().header.id, chosen_moment_s().value_or(0.0));
  }
  if (facts().rights.may_ask_for_help &&
      action("result.ask", {ui.text("result.ask"), ButtonLook::Secondary, Icon::Flag}))
    ask_.open();
  if (facts().rights.may_decide &&
      action("result.decide", {ui.text("result.decide"), ButtonLook::Secondary, Icon::Check}))
    decide_.open(facts());
  return whole - line.w;
}

float ResultScreen::draw_marks(Ui& ui, const Rect& place) const {
  Point at{place.x, place.y + 11.0F};
  for (const ScoreMark& mark : score_marks(ui.texts(), facts())) {
    const float width = pill_width(ui, mark.words, mark.has_shape);
    if (at.x > place.x && at.x + width > place.right()) at = {place.x, at.y + pill_step};
    at.x += pill(ui, at, mark.words, mark.meaning, mark.has_shape) + 8.0F;
  }
  return at.y + 11.0F - place.y;
}

std::vector<std::pair<Meaning, std::string>> ResultScreen::notices(const Texts& texts) const {
  std::vector<std::pair<Meaning, std::string>> found;
  const database::Decision* decision = facts().decision();
  const std::string who = decision != nullptr ? decider_text(texts, *decision) : std::string();
  if (decision != nullptr && decision->kind == database::DecisionKind::Voided) {
    found.emplace_back(Meaning::Bad, texts.say("result.notice.void",
                                               {{"person", who}, {"reason", decision->reason}}));
  }
  if (decision != nullptr && decision->kind == database::DecisionKind::Overridden &&
      facts().score) {
    found.emplace_back(Meaning::Info,
                       texts.say("result.notice.overridden",
                                 {{"person", who},
                                  {"points", points_text(facts().score->card.score_milli)},
                                  {"reason", decision->reason}}));
  }
  if (facts().is_unfinished())
    found.emplace_back(Meaning::Info, texts.text("result.notice.interrupted"));
  if (facts().header.state == database::AttemptState::Recording)
    found.emplace_back(Meaning::Info, texts.text("result.notice.recording"));
  if (!examined_.has_value() || !facts().header.seal) return found;
  const database::ScoreCard& now = examined_.value()->card;
  if (!facts().score) {
    found.emplace_back(Meaning::Warn, texts.say("result.notice.not_stored",
                                                {{"points", points_text(now.score_milli)}}));
  } else if (!compared_.is_same) {
    found.emplace_back(Meaning::Warn,
                       texts.say("result.notice.differs",
                                 {{"now", points_text(now.score_milli)},
                                  {"stored", points_text(facts().score->card.score_milli)},
                                  {"engine_now", std::to_string(now.engine)},
                                  {"engine_stored", std::to_string(facts().score->card.engine)}}));
  }
  return found;
}

float ResultScreen::draw_notices(Ui& ui, const Rect& place) const {
  Rect rest = place;
  for (const auto& [meaning, words] : notices(ui.texts())) {
    draw_notice(ui, take_top(rest, notice_height(ui, words, rest.w), 16.0F), meaning, words);
  }
  return rest.y - place.y;
}

float ResultScreen::draw_reading_cards(Ui& ui, const Rect& place) {
  const bool has_columns = place.w >= two_columns_from;
  const float score_width = has_columns ? score_card_width : place.w;
  const float words_width = has_columns ? place.w - score_width - space::between_cards : place.w;
  float score_height = score_card_height(facts()),
        words_height = sentences_card_height(ui, facts(), words_width);
  if (has_columns) score_height = words_height = std::max(score_height, words_height);
  draw_score_card(ui, {place.x, place.y, score_width, score_height}, facts());
  const Rect words{has_columns ? place.right() - words_width : place.x,
                   has_columns ? place.y : place.y + score_height + space::between_cards,
                   words_width, words_height};
  if (const auto line = draw_sentences_card(ui, words, facts())) watch(*line);
  return words.bottom() - place.y;
}

float ResultScreen::draw_looking_cards(Ui& ui, const Rect& place, float height, Shell& shell) {
  const bool has_columns = place.w >= two_columns_from;
  if (has_columns) {
    const float both = place.w - space::between_cards;
    const float width = std::round(std::min(0.62F * both, both - least_plan_width));
    draw_ledger(ui, {place.x, place.y, width, height});
    draw_plan(ui,
              {place.x + width + space::between_cards, place.y,
               place.w - width - space::between_cards, height},
              shell);
    return height;
  }
  draw_ledger(ui, {place.x, place.y, place.w, looking_height});
  const float top = place.y + looking_height + space::between_cards;
  draw_plan(ui, {place.x, top, place.w, looking_height}, shell);
  return top + looking_height - place.y;
}

void ResultScreen::choose_line(std::size_t line) {
  chosen_line_ = line;
  const LedgerLine& chosen = facts().score->card.ledger[line];
  ledger_.chosen = {chosen.item};
  plan_.show_place(chosen.place_in_bone_mm, cut_of(chosen, scenario()));
}

void ResultScreen::watch(std::size_t line) {
  choose_line(line);
  navigator_.show_replay(facts().header.id, second_of(facts().score->card.ledger[line].start_us));
}

std::optional<double> ResultScreen::chosen_moment_s() const {
  if (!chosen_line_) return std::nullopt;
  return second_of(facts().score->card.ledger[*chosen_line_].start_us);
}

void ResultScreen::draw_ledger(Ui& ui, const Rect& rect) {
  std::string title(ui.text("result.ledger"));
  if (facts().score) {
    std::int64_t lost = 0;
    for (const assessment::ShownLine& each : assessment::shown_points(facts().score->card).lines)
      lost += each.lost_milli;
    title = lost == 0 ? std::string(ui.text("result.ledger.kept"))
                      : ui.texts().say("result.ledger.lost", {{"points", points_text(lost)}});
  }
  Rect inside = card(ui, rect, title);
  if (!facts().score || facts().score->card.ledger.empty()) {
    empty_card(ui, "result.ledger.empty", inside,
               {Icon::Ratings, ui.text("result.ledger.empty"),
                ui.text(facts().is_unfinished() ? "result.ledger.not_scored"
                                                : "result.ledger.empty.sentence")});
    return;
  }
  const float hint = ui.paragraph_height(Type::Small, ui.text("result.ledger.hint"), inside.w);
  const Rect foot = take_bottom(inside, std::max(foot_height, hint_top + hint), 8.0F);
  draw_ledger_table(ui, inside);
  draw_ledger_foot(ui, foot);
}

void ResultScreen::draw_ledger_table(Ui& ui, const Rect& rect) {
  const database::ScoreCard& score = facts().score->card;
  const std::vector<std::size_t> order = lines_by_loss(score);
  const assessment::ShownPoints shown = assessment::shown_points(score);
  std::int64_t greatest = 1;
  for (const assessment::ShownLine& each : shown.lines)
    greatest = std::max(greatest, each.lost_milli);
  const bool is_narrow = rect.w < 600.0F;
  std::optional<std::size_t> watched;
  const auto title = [&](std::size_t row) { return item_title(score.ledger[row], scenario()); };
  const auto loss = [&](Ui& own, std::size_t row, const Rect& cell) {
    const assessment::ShownLine& line = shown.lines[row];
    own.canvas().text_in(cell, {Type::BodyStrong, own.theme().text, Align::Right},
                         loss_text(score.ledger[row], line));
    const float share = static_cast<float>(line.lost_milli) / static_cast<float>(greatest);
    const float length = loss_bar_width * share;
    if (!is_narrow && line.lost_milli > 0)
      own.canvas().fill({cell.right() - 52.0F - length, cell.mid_y() - 3.0F, length, 6.0F},
                        own.theme().muted_bar, 3.0F);
  };
  const auto moment = [&](Ui& own, std::size_t row, const Rect& cell) {
    if (draw_moment(own, score.ledger[row], cell)) watched = row;
  };
  RowTable<std::size_t> lines{
      ui.text("result.ledger"),
      [&](std::size_t row) { return score.ledger[row].item; },
      title,
      {{{ui.text("result.ledger.item")}, title, item_cell},
       {{ui.text("result.ledger.yours"), 76.0F, 1.0F, Align::Right},
        [&](std::size_t row) { return measured_text(score.ledger[row]); },
        item_cell},
       {{ui.text("result.ledger.target"), is_narrow ? 76.0F : 88.0F, 1.0F, Align::Right},
        [&](std::size_t row) { return target_text(score.ledger[row], scenario()); },
        caption_cell},
       {{ui.text("result.ledger.loss"), is_narrow ? 52.0F : 108.0F, 1.0F, Align::Right}, loss},
       {{ui.text("result.ledger.moment"), 64.0F, 1.0F, Align::Right}, moment}}};
  lines.row_height = row_height;
  const TableResponse response = table(ui, "result.ledger", rect, lines, order, ledger_);
  if (response.opened) {
    const std::size_t line = order[static_cast<std::size_t>(*response.opened)];
    if (chosen_line_ == line) watched = line;
    choose_line(line);
  }
  if (watched) watch(*watched);
}

void ResultScreen::draw_ledger_foot(Ui& ui, const Rect& rect) {
  Canvas& canvas = ui.canvas();
  canvas.hairline_across(rect.x, rect.y, rect.w, ui.theme().line);
  if (!chosen_line_) {
    canvas.paragraph({rect.x, rect.y + hint_top, rect.w, rect.h - hint_top},
                     {Type::Small, ui.theme().text_caption}, ui.text("result.ledger.hint"));
    return;
  }
  const LedgerLine& line = facts().score->card.ledger[*chosen_line_];
  const float needed = ui.paragraph_height(Type::Small, line.text, rect.w - 16.0F);
  const Rect view{rect.x, rect.y + 8.0F, rect.w, rect.h - 8.0F};
  const float offset =
      ui.begin_scroll("result.ledger.text", ui.text("result.ledger"), view, needed);
  canvas.paragraph({view.x, view.y - offset, view.w - 16.0F, needed},
                   {Type::Small, ui.theme().text_secondary}, line.text);
  ui.end_scroll();
}

void ResultScreen::draw_plan(Ui& ui, const Rect& rect, Shell& shell) {
  draw_card(ui.canvas(), ui.theme(), rect);
  Rect inside = inset(rect, space::card);
  if (!examined_.has_value()) {
    ui.canvas().text_on_baseline({inside.x, rect.y + 36.0F}, {Type::CardTitle, ui.theme().text},
                                 ui.text("result.plan"));
    take_top(inside, 28.0F);
  }
  if (!examined_.draw_until_ready(ui, "result.unseen", inside, 6)) return;
  plan_.draw(ui, shell, inset(rect, 1.0F), *examined_.value());
}

float ResultScreen::effects_card_height(const Ui& ui, float width) const {
  const float inside = width - 2.0F * space::card;
  const bool has_room_for_marks = ui.width_of(Type::CardTitle, ui.text("result.effects")) + 20.0F +
                                      effects_marks_width(ui, are_effects_scored()) <=
                                  inside;
  const float content = examined_.has_value()
                            ? effects_height(ui, examined_.value()->effects, inside, effects_time_)
                            : unseen_effects_height;
  return title_height + (has_room_for_marks ? 0.0F : pill_step) + content + space::card;
}

void ResultScreen::draw_effects_card(Ui& ui, const Rect& rect) {
  Rect inside = card(ui, rect, ui.text("result.effects"));
  const float title_width = ui.width_of(Type::CardTitle, ui.text("result.effects"));
  if (title_width + 20.0F + effects_marks_width(ui, are_effects_scored()) <= inside.w) {
    draw_effects_marks(ui, {inside.x, rect.y + 18.0F, inside.w, 24.0F}, are_effects_scored());
  } else {
    const Rect line = take_top(inside, pill_step);
    draw_effects_marks(ui, {line.x, line.y, effects_marks_width(ui, are_effects_scored()), 22.0F},
                       are_effects_scored());
  }
  if (!examined_.draw_until_ready(ui, "result.effects.unseen", inside, 6)) return;
  const auto asked_s =
      draw_effects(ui, inside, examined_.value()->effects, chosen_moment_s(), effects_time_);
  if (asked_s) navigator_.show_replay(facts().header.id, *asked_s);
}

bool ResultScreen::are_effects_scored() const noexcept {
  return facts().score && ui::are_effects_scored(facts().score->card);
}

bool ResultScreen::shows_what_if() const {
  if (!facts().score) return false;
  if (!examined_.has_value()) return examined_.is_running();
  return compared_.is_same;
}

void ResultScreen::draw_forms(Ui& ui, Shell& shell) {
  if (decide_.draw(ui, shell, facts())) {
    facts_.read_again();
    ui.want_frame_in_s(0.0);
  }
  database::AttemptMoment moment;
  if (chosen_line_) {
    const LedgerLine& line = facts().score->card.ledger[*chosen_line_];
    moment = {line.start_us, database::BonePoint{0, line.place_in_bone_mm}};
  }
  ask_.draw(ui, shell, signed_in_,
            question_form(ui, ui.text("result.ask"), ui.text("result.ask.sentence")),
            [header = facts().header, moment](database::Session& session, const std::string& words,
                                              bool) {
              ask_for_help(session, header, {header.id, moment, words});
            });
}

}  // namespace hallux::ui

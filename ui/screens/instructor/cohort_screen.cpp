// A cohort as a grid of people and operations, with what asks for an answer beside it. One shape in
// each cell says how somebody stands; the rule for it is parts/standing.h alone. With many
// operations the grid turns pages, so that names stay whole; columns of other pages are left out
// and keep their numbers, which a sort goes on naming.
#include "ui/screens/instructor/cohort_screen.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "simulator/base/check.h"
#include "ui/screens/parts/attempt_marks.h"
#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/help_rows.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/parts/person_cell.h"
#include "ui/screens/parts/standing.h"
#include "ui/times/local_time.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/controls/menu.h"
#include "ui/widgets/controls/pager.h"
#include "ui/widgets/controls/tooltip.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

using database::OperationStanding;
using database::TraineeStanding;

constexpr float side_width = 320.0F, stacked_height = 620.0F, grid_row = 46.0F;
constexpr float person_width = 190.0F, least_person = 140.0F, least_cell = 92.0F,
                most_cell = 150.0F, cell_gap = 16.0F, sort_mark = 18.0F, legend_height = 48.0F;
/// So many operations stand beside each other before their names are shown whole.
constexpr int columns_wanted = 3;
constexpr int idle_days = 14;
constexpr float button_gap = 12.0F;
constexpr std::size_t listed_requests = 4;
constexpr std::int32_t listed_attempts = 6;

/// How a trainee stands in one operation.
struct StandingIn {
  const OperationStanding& results;
  const assessment::LearningState& learning;
};

std::optional<StandingIn> standing_in(const TraineeProgress& trainee,
                                      const std::string& operation) {
  const std::vector<OperationStanding>& operations = trainee.standing.operations;
  for (std::size_t index = 0; index < operations.size(); ++index)
    if (operations[index].scenario_name == operation)
      return StandingIn{operations[index], trainee.learning[index]};
  return std::nullopt;
}

std::string row_id(const TraineeStanding& trainee) {
  return trainee.login.empty() ? "erased-" + std::to_string(trainee.id.number) : trainee.login;
}

Rect card_row(Rect& rest, float height, bool is_first, Ui& ui) {
  if (!is_first) ui.canvas().hairline_across(rest.x, rest.y, rest.w, ui.theme().line);
  return take_top(rest, height);
}

/// A row of a side card that leads somewhere, raised under the pointer.
bool row_control(Ui& ui, const std::string& id, std::string_view label, std::string_view group,
                 const Rect& row) {
  Widget widget{.id = std::string(id),
                .label = std::string(label),
                .rect = inset(row, -10.0F, 1.0F),
                .role = Role::Row,
                .group = std::string(group)};
  const Rect ground = widget.rect;
  const Response response = ui.control(std::move(widget));
  ui.canvas().fill(ground, faded(ui.theme().raise, response.hover), radius::row);
  if (response.shows_ring)
    draw_focus_ring(ui.canvas(), ui.theme(), inset(ground, 3.0F, 3.0F), radius::row);
  return response.is_pressed();
}

}  // namespace

CohortScreen::CohortScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator,
                           std::function<void()> open_inbox)
    : signed_in_(std::move(signed_in)),
      navigator_(navigator),
      open_inbox_(std::move(open_inbox)),
      taught_(signed_in_->taught()),
      limits_(signed_in_) {
  CHECK(!taught_.empty());
}

CohortScreen::Glance CohortScreen::look(database::Session& session, database::CohortId cohort) {
  database::InstructorDesk desk = instructor_of(session, cohort);
  Glance glance;
  glance.cohort = desk.cohort();
  glance.trainees = trainees_of(desk);
  glance.open_requests = desk.help_requests(true);
  glance.limits = desk.limits();
  glance.now_utc = utc_now_text();
  std::set<std::string> operations;
  for (const database::Operation& operation : trainee_of(session).operations())
    operations.insert(operation.name);
  for (const TraineeProgress& progress : glance.trainees) {
    for (const OperationStanding& standing : progress.standing.operations) {
      operations.insert(standing.scenario_name);
      glance.attempts += standing.attempts;
    }
  }
  glance.operations.assign(operations.begin(), operations.end());
  for (database::AttemptHeader& attempt : desk.newest_attempts(listed_attempts)) {
    const database::PersonId person = attempt.begun.person.value_or(database::PersonId{});
    const auto trainee = std::find_if(
        glance.trainees.begin(), glance.trainees.end(),
        [&](const TraineeProgress& progress) { return progress.standing.id == person; });
    if (trainee == glance.trainees.end()) continue;  // enrolled in between
    glance.last_attempts.push_back(
        {std::move(attempt),
         shown_name_of(trainee->standing.login, trainee->standing.display_name)});
  }
  return glance;
}

std::string CohortScreen::last_seen(const TraineeStanding& trainee) {
  std::string last;
  for (const OperationStanding& standing : trainee.operations)
    last = std::max(last, standing.last_started_utc);
  return last;
}

bool CohortScreen::is_in(const TraineeProgress& trainee, int filter, std::string_view now_utc) {
  const std::vector<OperationStanding>& operations = trainee.standing.operations;
  if (filter == Asking) return trainee.standing.open_help_requests > 0;
  if (filter == Slipped) {
    for (std::size_t index = 0; index < operations.size(); ++index)
      if (competence_of(operations[index], trainee.learning[index], now_utc) == Competence::Slipped)
        return true;
    return false;
  }
  if (filter == Idle) {
    const std::string last = last_seen(trainee.standing);
    return last.empty() || days_between(last, now_utc) > idle_days;
  }
  return true;
}

void CohortScreen::show(std::size_t cohort) {
  cohort_ = cohort;
  filter_ = All;
  first_column_ = 0;
  table_.sort = {};
  glance_.read_again();
}

void CohortScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  glance_.read(ui, shell, ui.text("cohort.reading"), signed_in_,
               [cohort = taught_[cohort_].cohort](database::Session& session) {
                 return look(session, cohort);
               });
  {
    const bool is_stacked = are_panes_stacked(content.w - 2.0F * page_margin(content));
    const Page scrolled(ui, "cohort", ui.text("place.cohort"), content,
                        is_stacked ? 460.0F + stacked_height : 600.0F);
    Rect page = scrolled.rect();
    draw_head(ui, page);
    draw_pills(ui, page);
    const Panes panes = panes_of(page, side_width, stacked_height);
    const Rect inside = list_card(ui, panes.main);
    if (glance_.draw_until_ready(ui, "cohort.failed", inside, 8)) draw_grid(ui, inside);
    Rect side = panes.side;
    draw_requests(ui,
                  take_top(side, (side.h - space::between_cards) * 0.48F, space::between_cards));
    draw_last_attempts(ui, side);
  }
  draw_cohort_menu(ui);
  limits_.draw(
      ui, shell,
      [cohort = taught_[cohort_].cohort](database::Session& session, const LimitChange& change) {
        database::InstructorDesk desk = instructor_of(session, cohort);
        if (change.attempts_max) {
          desk.set_limit(change.scenario_name, *change.attempts_max);
        } else {
          desk.clear_limit(change.scenario_name);
        }
      },
      [this] { glance_.read_again(); });
}

void CohortScreen::draw_head(Ui& ui, Rect& page) {
  const bool is_ready = glance_.is_ready();
  const std::string sentence =
      is_ready ? ui.texts().say_count("cohort.sentence",
                                      static_cast<long>(glance_.value().trainees.size()),
                                      {{"attempts", grouped(glance_.value().attempts)}})
               : std::string(ui.text("cohort.reading"));
  PageHead head =
      course_head(ui, *signed_in_,
                  is_ready ? glance_.value().cohort.name : taught_[cohort_].cohort_name, sentence);
  const ButtonSpec other{ui.text("cohort.other"), ButtonLook::Secondary, Icon::SortDown};
  const ButtonSpec limit{.label = ui.text("limits.open"),
                         .why_off = is_ready ? std::string_view() : ui.text("cohort.reading")};
  const float limit_width = button_width(ui, limit);
  head.buttons_width = limit_width;
  if (taught_.size() > 1) head.buttons_width += button_width(ui, other) + button_gap;
  Rect buttons = page_head(ui, "cohort", page, head).buttons;
  if (button(ui, "cohort.limits", take_left(buttons, limit_width, button_gap), limit))
    limits_.open({glance_.value().cohort.name, glance_.value().operations, glance_.value().limits});
  if (taught_.size() > 1 && button(ui, "cohort.other", buttons, other))
    menu_ = Point{buttons.right() - 250.0F, buttons.bottom() + 6.0F};
}

void CohortScreen::draw_cohort_menu(Ui& ui) {
  if (!menu_) return;
  std::vector<MenuItem> items;
  for (const database::Membership& taught : taught_)
    items.push_back({taught.cohort_name, Icon::Cohorts});
  const int chosen = menu(ui, "cohort.menu", *menu_, items);
  if (chosen == menu_open) return;
  menu_.reset();
  if (chosen >= 0) show(static_cast<std::size_t>(chosen));
}

std::array<std::string, CohortScreen::FilterCount> CohortScreen::pill_labels(
    const Texts& texts) const {
  const Glance& glance = glance_.value();
  const auto count = [&](int filter) {
    return static_cast<long>(std::count_if(
        glance.trainees.begin(), glance.trainees.end(),
        [&](const TraineeProgress& trainee) { return is_in(trainee, filter, glance.now_utc); }));
  };
  return {texts.say("cohort.filter.all", {{"count", grouped(count(All))}}),
          texts.say_count("cohort.filter.asking", count(Asking)),
          texts.say("cohort.filter.slipped", {{"count", grouped(count(Slipped))}}),
          texts.say("cohort.filter.idle", {{"count", grouped(count(Idle))}})};
}

void CohortScreen::draw_pills(Ui& ui, Rect& page) {
  Rect line = take_top(page, 24.0F, 12.0F);
  if (!glance_.is_ready()) return;
  const std::array<std::string, FilterCount> labels = pill_labels(ui.texts());
  for (int filter = All; filter < FilterCount; ++filter) {
    const std::string& label = labels[static_cast<std::size_t>(filter)];
    const float wanted = ui.width_of(Type::CaptionMedium, label) + 20.0F;
    if (wanted > line.w) {  // a second line, where the window is narrow
      line = take_top(page, 24.0F, 12.0F);
    }
    float width = 0.0F;
    if (filter_pill(ui, "cohort.filter." + std::to_string(filter), {line.x, line.mid_y()}, label,
                    filter_ == filter, &width)) {
      filter_ = filter;
      ui.want_frame_in_s(0.0);
    }
    take_left(line, width, 8.0F);
  }
}

CohortScreen::SortKey CohortScreen::sort_key(const TraineeProgress& trainee,
                                             const std::string* operation) {
  const std::string name = shown_name_of(trainee.standing.login, trainee.standing.display_name);
  if (operation == nullptr) return {0, name};
  const auto standing = standing_in(trainee, *operation);
  return {standing ? standing->results.best_milli.value_or(-1) : -2, name};
}

void CohortScreen::turn_pages(Ui& ui, Rect& rest, const std::vector<std::string>& heads) {
  float cell = least_cell;
  for (const std::string& head : heads)
    cell = std::max(cell, std::min(most_cell, ui.width_of(Type::Caption, head) + sort_mark));
  const int count = static_cast<int>(heads.size());
  auto room = static_cast<int>((rest.w - person_width) / (cell + cell_gap));
  if (room < columns_wanted) {
    const auto most = static_cast<int>((rest.w - least_person) / (least_cell + cell_gap));
    room = std::max(room, std::min(most, columns_wanted));
  }
  page_columns_ = std::clamp(room, 1, std::max(1, count));
  if (page_columns_ >= count) {
    first_column_ = 0;
    return;
  }
  first_column_ = std::clamp(first_column_, 0, count - page_columns_);
  const TextValues place{{"first", std::to_string(first_column_ + 1)},
                         {"last", std::to_string(first_column_ + page_columns_)},
                         {"count", std::to_string(count)}};
  const std::string words = page_columns_ == 1 ? ui.texts().say("cohort.operation_shown", place)
                                               : ui.texts().say("cohort.operations_shown", place);
  first_column_ = pager(ui, "cohort.operations", take_top(rest, pager_height),
                        {first_column_, page_columns_, count, words, ui.text("cohort.earlier"),
                         ui.text("cohort.later")});
}

std::vector<RowColumn<TraineeProgress>> CohortScreen::columns_of(
    const Ui& ui, const std::vector<std::string>& heads) const {
  using Trainee = const TraineeProgress&;
  const float person = page_columns_ > 3 ? person_width : 0.0F;
  std::vector<RowColumn<TraineeProgress>> columns{
      {{ui.text("cohort.person"), person, 1.35F},
       [this](Ui& own, Trainee trainee, const Rect& cell) { draw_person_cell(own, trainee, cell); },
       {},
       by([](Trainee trainee) { return sort_key(trainee, nullptr); })}};
  for (int number = 0; number < static_cast<int>(heads.size()); ++number) {
    const std::string& operation = glance_.value().operations[static_cast<std::size_t>(number)];
    const bool is_on_page = number >= first_column_ && number < first_column_ + page_columns_;
    columns.push_back(
        {{heads[static_cast<std::size_t>(number)], 0.0F, 1.0F, Align::Left,
          is_on_page ? 0.0F : std::numeric_limits<float>::infinity()},
         [this, &operation](Ui& own, Trainee trainee, const Rect& cell) {
           draw_standing_cell(own, trainee, operation, cell);
         },
         {},
         by([&operation](Trainee trainee) { return sort_key(trainee, &operation); })});
  }
  return columns;
}

void CohortScreen::draw_grid(Ui& ui, const Rect& content) {
  const Glance& glance = glance_.value();
  std::vector<const TraineeProgress*> shown;
  for (const TraineeProgress& trainee : glance.trainees)
    if (is_in(trainee, filter_, glance.now_utc)) shown.push_back(&trainee);
  if (shown.empty()) {
    const bool is_nobody = glance.trainees.empty();
    empty_card(ui, "cohort.empty", content,
               {Icon::Cohort, ui.text(is_nobody ? "cohort.empty" : "cohort.none"),
                ui.text(is_nobody ? "cohort.empty.sentence" : "cohort.none.sentence")});
    return;
  }
  Rect rest = content;
  const Rect legend = take_bottom(rest, legend_height);
  std::vector<std::string> heads;
  for (const std::string& operation : glance.operations) heads.push_back(operation_text(operation));
  turn_pages(ui, rest, heads);
  const RowTable<TraineeProgress> grid{
      glance.cohort.name, [](const TraineeProgress& trainee) { return row_id(trainee.standing); },
      [&](const TraineeProgress& trainee) {
        return person_name_of(ui.texts(), trainee.standing.login, trainee.standing.display_name);
      },
      columns_of(ui, heads), grid_row};
  sort_rows(shown, grid.columns, table_.sort);
  const TableResponse response = table(ui, "cohort.row", rest, grid, shown, table_);
  draw_legend(ui, legend);
  if (!response.opened) return;
  const TraineeProgress& opened = *shown[static_cast<std::size_t>(*response.opened)];
  navigator_.show_trainee(glance.cohort.id, opened.standing.id);
}

void CohortScreen::draw_person_cell(Ui& ui, const TraineeProgress& progress,
                                    const Rect& cell) const {
  const Theme& theme = ui.theme();
  const TraineeStanding& trainee = progress.standing;
  const std::string name = person_name_of(ui.texts(), trainee.login, trainee.display_name);
  person_avatar(ui, {cell.x + 14.0F, cell.mid_y()}, 14.0F, name, trainee.id);
  const bool asks = trainee.open_help_requests > 0;
  const float room = cell.w - 38.0F - (asks ? 24.0F : 0.0F);
  ui.canvas().text_in({cell.x + 38.0F, cell.mid_y() - 19.0F, room, 20.0F},
                      {Type::BodyMedium, theme.text}, name, true);
  const std::string last = last_seen(trainee);
  const bool is_idle = is_in(progress, Idle, glance_.value().now_utc);
  const std::string when = trainee.is_disabled
                               ? std::string(ui.text("people.disabled"))
                               : ago_text(ui.texts(), last, glance_.value().now_utc);
  ui.canvas().text_in({cell.x + 38.0F, cell.mid_y() + 1.0F, room, 18.0F},
                      {Type::Caption, is_idle ? theme.warn_text : theme.text_caption}, when, true);
  if (asks)
    ui.canvas().icon({cell.right() - 10.0F, cell.mid_y()}, Icon::Flag, IconSize::Control,
                     theme.accent);
}

void CohortScreen::draw_standing_cell(Ui& ui, const TraineeProgress& trainee,
                                      const std::string& operation, const Rect& cell) const {
  const Theme& theme = ui.theme();
  const auto standing = standing_in(trainee, operation);
  const Competence competence =
      standing ? competence_of(standing->results, standing->learning, glance_.value().now_utc)
               : Competence::NotStarted;
  if (competence == Competence::Slipped)
    ui.canvas().fill({cell.x - 4.0F, cell.y + 4.0F, 96.0F, cell.h - 8.0F},
                     tint_of(theme, Meaning::Bad), radius::row);
  draw_competence(ui.canvas(), theme, competence, {cell.x + 10.0F, cell.mid_y()}, 7.5F,
                  standing ? progress_of(standing->results, standing->learning) : 0.0F);
  if (!standing) return;
  const OperationStanding& results = standing->results;
  // Best and attempts stand at the same place in every row.
  const Rect best{cell.x + 22.0F, cell.y, 32.0F, cell.h};
  const std::string words =
      results.best_milli ? std::to_string((*results.best_milli + 500) / 1000) : "\xE2\x80\x93";
  ui.canvas().text_in(best, {Type::BodyMedium, theme.text, Align::Right}, words);
  ui.canvas().text_in({best.right() + 6.0F, cell.y, 26.0F, cell.h},
                      {Type::Small, theme.text_caption, Align::Right},
                      std::to_string(results.attempts));
}

void CohortScreen::draw_legend(Ui& ui, const Rect& line) const {
  const Theme& theme = ui.theme();
  ui.canvas().hairline_across(line.x, line.y, line.w, theme.line);
  constexpr std::array<std::pair<Competence, std::string_view>, 5> shapes{
      {{Competence::Competent, "cohort.legend.competent"},
       {Competence::Learning, "cohort.legend.learning"},
       {Competence::Slipped, "cohort.legend.slipped"},
       {Competence::Stale, "cohort.legend.stale"},
       {Competence::NotStarted, "cohort.legend.not_started"}}};
  float x = line.x;
  const float y = line.y + 30.0F;
  for (const auto& [competence, id] : shapes) {
    const float width = 22.0F + ui.width_of(Type::Caption, ui.text(id)) + 18.0F;
    if (x + width > line.right() + 18.0F) break;  // the words are in the help of the shapes
    draw_competence(ui.canvas(), theme, competence, {x + 8.0F, y}, 6.5F, 0.6F);
    ui.canvas().text({x + 22.0F, y}, {Type::Caption, theme.text_secondary}, ui.text(id));
    x += width;
  }
  const std::string_view numbers = ui.text("cohort.legend.numbers");
  if (x + ui.width_of(Type::Caption, numbers) <= line.right())
    ui.canvas().text({line.right(), y}, {Type::Caption, theme.text_caption, Align::Right}, numbers);
}

void CohortScreen::draw_requests(Ui& ui, const Rect& rect) {
  Rect rest = card(ui, rect, ui.text("cohort.requests"), space::side_card);
  if (!glance_.is_ready()) return;
  const std::vector<database::HelpRequest>& requests = glance_.value().open_requests;
  if (open_inbox_ && link(ui, "cohort.inbox", {rect.right() - space::side_card, rect.y + 30.0F},
                          ui.text("cohort.open_inbox"), Align::Right))
    open_inbox_();
  if (requests.empty()) {
    empty_card(
        ui, "cohort.no_requests", rest,
        {Icon::Inbox, ui.text("cohort.no_requests"), ui.text("cohort.no_requests.sentence")});
    return;
  }
  constexpr float height = 72.0F;
  for (std::size_t i = 0; i < std::min(requests.size(), listed_requests) && rest.h >= height; ++i) {
    const database::HelpRequest& request = requests[i];
    Rect row = card_row(rest, height, i == 0, ui);
    const std::string moment = help_moment(ui.texts(), request);
    if (row_control(ui, "cohort.request." + std::to_string(request.id.number), moment,
                    "cohort.requests", row))
      navigator_.show_replay(request.attempt, static_cast<double>(request.moment.moment_us) * 1e-6);
    person_avatar(ui, {row.x + 14.0F, row.y + 24.0F}, 14.0F, request.asker_name, request.asker);
    const float x = row.x + 38.0F, room = row.w - 38.0F;
    ui.canvas().text_in({x, row.y + 7.0F, room, 20.0F}, {Type::SmallMedium, ui.theme().text},
                        request.asker_name, true);
    ui.canvas().text_in({x, row.y + 26.0F, room, 18.0F}, {Type::Caption, ui.theme().text_caption},
                        moment, true);
    ui.canvas().text_in({x, row.y + 45.0F, room, 20.0F}, {Type::Small, ui.theme().text_secondary},
                        request.question, true);
  }
}

void CohortScreen::draw_last_attempts(Ui& ui, const Rect& rect) {
  Rect rest = card(ui, rect, ui.text("cohort.last_attempts"), space::side_card);
  if (!glance_.is_ready()) return;
  const Glance& glance = glance_.value();
  if (glance.last_attempts.empty()) {
    empty_card(ui, "cohort.no_attempts", rest,
               {Icon::History, ui.text("attempts.empty"), ui.text("attempts.empty.sentence")});
    return;
  }
  constexpr float height = 50.0F;
  for (std::size_t i = 0; i < glance.last_attempts.size() && rest.h >= height; ++i) {
    const LastAttempt& last = glance.last_attempts[i];
    Rect row = card_row(rest, height, i == 0, ui);
    const std::string what =
        ui.texts().say("cohort.attempt",
                       {{"operation", operation_text(last.header.scenario_name)},
                        {"number", grouped(static_cast<long>(last.header.number))},
                        {"when", ago_text(ui.texts(), last.header.started_utc, glance.now_utc)}});
    if (row_control(ui, "cohort.attempt." + std::to_string(last.header.order), what,
                    "cohort.attempts", row))
      navigator_.show_result(last.header.id);
    if (const std::string_view why = why_not_counted(ui, last.header); !why.empty())
      tooltip_when_resting(ui, "cohort.attempt." + std::to_string(last.header.order), row, why);
    const bool counts = why_not_counted(ui, last.header).empty();
    const std::optional<std::int64_t> milli =
        last.header.decided_milli ? last.header.decided_milli : last.header.score_milli;
    const float score = milli ? 44.0F : 0.0F, room = row.w - score - 8.0F;
    ui.canvas().text_in({row.x, row.y + 5.0F, room, 20.0F}, {Type::SmallMedium, ui.theme().text},
                        last.name, true);
    ui.canvas().text_in({row.x, row.y + 25.0F, room, 18.0F},
                        {Type::Caption, ui.theme().text_caption}, what, true);
    if (milli)
      ui.canvas().text_in(
          {row.right() - score, row.y, score, row.h},
          {Type::BodyMedium, counts ? ui.theme().text : ui.theme().text_caption, Align::Right},
          points_text(*milli));
  }
}

}  // namespace hallux::ui

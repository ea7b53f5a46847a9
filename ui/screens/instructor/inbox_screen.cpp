// The questions of all cohorts that somebody teaches, in one list. A trainee may be in two of these
// cohorts, so a question is known by its id and kept once, with the first desk that may answer it.
// What was typed stays as a draft outside the screen: seeing the moment means leaving it. A chosen
// question stays in the list of open ones once it was answered.
#include "ui/screens/instructor/inbox_screen.h"

#include <algorithm>
#include <set>

#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/help_rows.h"
#include "ui/screens/parts/page.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/field.h"

namespace hallux::ui {

namespace {

constexpr ListPageSpec page_spec{.side_width = 440.0F,
                                 .side_height = 520.0F,
                                 .list_height = 440.0F,
                                 .least_height = 600.0F,
                                 .has_head = false};
constexpr float answer_height = 132.0F;

}  // namespace

std::vector<InboxRequest> read_inbox(database::Session& session) {
  std::vector<InboxRequest> inbox;
  std::set<database::HelpRequestId> known;
  for (const database::Membership& membership : session.memberships()) {
    if (membership.role != database::CohortRole::Instructor) continue;
    for (database::HelpRequest& request :
         instructor_of(session, membership.cohort).help_requests()) {
      if (!known.insert(request.id).second) continue;
      inbox.push_back({std::move(request), membership.cohort});
    }
  }
  std::stable_sort(inbox.begin(), inbox.end(), [](const InboxRequest& a, const InboxRequest& b) {
    const bool is_open = !a.request.answer, is_other_open = !b.request.answer;
    if (is_open != is_other_open) return is_open;
    return is_open ? a.request.id < b.request.id : b.request.id < a.request.id;
  });
  return inbox;
}

int count_open(const std::vector<InboxRequest>& inbox) noexcept {
  return static_cast<int>(std::count_if(
      inbox.begin(), inbox.end(), [](const InboxRequest& each) { return !each.request.answer; }));
}

void InboxScreen::read(Ui& ui, Shell& shell) {
  is_counted_ = false;
  inbox_.read(ui, shell, ui.text("inbox.reading"), signed_in_, read_inbox);
}

const InboxRequest* InboxScreen::chosen() const {
  for (const InboxRequest& each : inbox_.value())
    if (each.request.id == chosen_) return &each;
  return nullptr;
}

void InboxScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  if (inbox_.is_new()) read(ui, shell);
  if (inbox_.is_ready() && !std::exchange(is_counted_, true) && counted_) {
    counted_(count_open(inbox_.value()));
    ui.want_frame_in_s(0.0);  // the navigation was drawn before
  }
  const ListPage page(
      ui, "inbox", course_head(ui, *signed_in_, ui.text("inbox.title"), ui.text("inbox.sentence")),
      content, page_spec);
  if (inbox_.draw_until_ready(ui, "inbox.failed", page.list(), 6)) {
    draw_list(ui, page.list());
    draw_chosen(ui, page.side(), shell);
  } else {
    card(ui, page.side(), {});
  }
}

void InboxScreen::draw_list(Ui& ui, const Rect& content) {
  Rect rest = content;
  const std::vector<InboxRequest>& inbox = inbox_.value();
  const int open = count_open(inbox);
  // Where nothing is open, there would be nothing to see.
  if (!std::exchange(is_filter_set_, true)) filter_ = open > 0 ? 0 : 1;
  Rect pills = take_top(rest, 24.0F, 8.0F);
  const std::string labels[] = {
      ui.texts().say("inbox.filter.open", {{"count", grouped(open)}}),
      ui.texts().say("inbox.filter.all", {{"count", grouped(static_cast<long>(inbox.size()))}})};
  for (int number = 0; number < 2; ++number) {
    float width = 0.0F;
    if (filter_pill(ui, "inbox.filter." + std::to_string(number), {pills.x, pills.mid_y()},
                    labels[number], filter_ == number, &width)) {
      filter_ = number;
      ui.want_frame_in_s(0.0);
    }
    take_left(pills, width, 8.0F);
  }
  std::vector<const database::HelpRequest*> shown;
  for (const InboxRequest& each : inbox)
    if (filter_ == 1 || !each.request.answer || each.request.id == chosen_)
      shown.push_back(&each.request);
  if (shown.empty()) {
    empty_card(ui, "inbox.empty", rest,
               {Icon::Inbox, ui.text(inbox.empty() ? "inbox.empty" : "inbox.none_open"),
                ui.text("inbox.empty.sentence")});
    return;
  }
  if (chosen_.number == 0) chosen_ = shown.front()->id;
  const int opened =
      help_rows(ui, rest, {"inbox.row", ui.text("inbox.title"), true}, shown, chosen_);
  if (opened < 0) return;
  chosen_ = shown[static_cast<std::size_t>(opened)]->id;
  ui.want_frame_in_s(0.0);
}

void InboxScreen::draw_chosen(Ui& ui, const Rect& content, Shell& shell) {
  const Rect inside = card(ui, content, {}, space::side_card);
  const InboxRequest* request = chosen();
  if (request == nullptr) {
    empty_card(ui, "inbox.nothing", inside,
               {Icon::Messages, ui.text("inbox.nothing"), ui.text("inbox.nothing.sentence")});
    return;
  }
  const float answer_room = request->request.answer ? 0.0F : answer_height + 150.0F;
  const float height = help_request_height(ui, request->request, inside.w - 12.0F) + answer_room;
  const float offset = ui.begin_scroll("inbox.chosen", ui.text("help.question"),
                                       inset(inside, -8.0F, -4.0F), height);
  Rect rest{inside.x, inside.y - offset, inside.w - 12.0F, height};
  if (draw_help_request(ui, "inbox", rest, request->request, true))
    navigator_.show_replay(request->request.attempt,
                           static_cast<double>(request->request.moment.moment_us) * 1e-6);
  if (!request->request.answer) draw_answer(ui, rest, *request, shell);
  ui.end_scroll();
}

void InboxScreen::draw_answer(Ui& ui, Rect& rest, const InboxRequest& chosen, Shell& shell) {
  std::string& draft = (*drafts_)[chosen.request.id];
  take_top(rest, field_label_height);
  field(ui, "inbox.answer", take_top(rest, answer_height, 12.0F), draft,
        {.label = ui.text("inbox.answer"),
         .why_off = work_.is_running() ? ui.text("button.busy") : std::string_view(),
         .lines = 4,
         .max_bytes = 2000});
  ButtonSpec send{ui.text("inbox.send"), ButtonLook::Primary, Icon::Send};
  if (draft.find_first_not_of(" \n\t") == std::string::npos)
    send.why_off = ui.text("inbox.answer.missing");
  send.is_busy = work_.is_running();
  if (button_in_line(ui, "inbox.send", take_top(rest, button_height, 12.0F), send))
    answer(ui, shell, chosen);
}

void InboxScreen::answer(Ui& ui, Shell& shell, const InboxRequest& chosen) {
  const database::HelpRequestId id = chosen.request.id;
  work_.change(
      shell, signed_in_,
      {std::string(ui.text("inbox.sending")), std::string(ui.text("inbox.not_sent"))},
      [id, cohort = chosen.cohort, text = (*drafts_)[id]](database::Session& session) {
        instructor_of(session, cohort).answer(id, text);
      },
      [this, &shell, id, said = std::string(ui.text("inbox.sent"))] {
        drafts_->erase(id);
        shell.say({Meaning::Good, said});
        inbox_.read_again();
      });
}

}  // namespace hallux::ui

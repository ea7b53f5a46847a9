// Everything told is gathered first, the newest first and work before messages, then given places
// in that order. A place is found anew in each frame, so that it follows the window; only where it
// looks freely among what is seen, a message stays where it was as long as it covers nothing there.
#include "ui/window/shell/messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ui/widgets/controls/toast.h"
#include "ui/window/shell/free_place.h"

namespace hallux::ui {

namespace {

constexpr double message_s = 6.0, work_shown_after_s = 0.3, work_frame_s = 0.1;
constexpr double time_left_from_s = 10.0, least_share = 0.05;
constexpr float narrower = 300.0F, narrowest = 208.0F;
constexpr float margin = 24.0F, gap = 12.0F, strip_edge = 16.0F, strip_share = 0.4F;
constexpr std::size_t messages_most = 4;

bool stays(const Message& message) {
  return message.meaning == Meaning::Bad || message.meaning == Meaning::Warn;
}

Toast words_of(const Message& message) {
  return {message.meaning, message.title, message.detail, message.action};
}

std::string time_left_text(const Texts& texts, const Background::Running& work) {
  if (work.share <= least_share) return {};
  const double left_s = work.elapsed_s / work.share - work.elapsed_s;
  return left_s > time_left_from_s ? texts.say_count("work.left", std::lround(left_s))
                                   : std::string();
}

RunningWork work_of(const Background::Running& work, std::string_view time_left) {
  return {work.label, time_left, static_cast<float>(work.share)};
}

}  // namespace

void Messages::say(Message message) {
  std::erase_if(messages_, [&](const Shown& shown) {
    return shown.message.title == message.title && shown.message.detail == message.detail;
  });
  messages_.push_back({std::move(message), "message." + std::to_string(next_message_++)});
  if (messages_.size() > messages_most) messages_.erase(messages_.begin());
}

void Messages::gather(Ui& ui, const Background& background) {
  const std::vector<Told> before = std::exchange(told_, {});
  const auto place_of = [&](const std::string& id) {
    const auto same = std::ranges::find(before, id, &Told::id);
    return same == before.end() ? Rect{} : same->rect;
  };
  for (const Background::Running& work : background.running()) {
    if (work.label.empty()) continue;
    if (work.elapsed_s < work_shown_after_s) {
      ui.want_frame_in_s(work_shown_after_s - work.elapsed_s);
      continue;
    }
    ui.want_frame_in_s(work_frame_s);
    told_.push_back({work.id, work, time_left_text(ui.texts(), work), place_of(work.id)});
  }
  std::for_each(messages_.rbegin(), messages_.rend(), [&](const Shown& shown) {
    told_.push_back({shown.id, {}, {}, place_of(shown.id)});
  });
}

Messages::Shown* Messages::find(const std::string& id) noexcept {
  const auto found = std::ranges::find(messages_, id, &Shown::id);
  return found == messages_.end() ? nullptr : &*found;
}

float Messages::height_of(const Ui& ui, const Told& told, float width) {
  if (told.work) return progress_height_for(ui, work_of(*told.work, told.time_left), width);
  return toast_height_for(ui, words_of(find(told.id)->message), width);
}

float Messages::plan(Ui& ui, const Background& background, const MessageRoom& room) {
  gather(ui, background);
  float strip = 0.0F;
  if (!room.page.is_empty()) strip = plan_on_page(ui, room);
  if (room.page.is_empty() || covers_what_lies_above(ui)) plan_freely(ui);
  const Obstacles seen = obstacles_in(ui.shown(), ui.display());
  std::vector<Rect> places;
  for (Told& told : told_) {
    told.covered = covered_by(told.rect, seen);
    if (!told.rect.is_empty()) places.push_back(told.rect);
  }
  ui.set_messages_at(std::move(places));
  return strip;
}

// From the foot of the gap upwards, then from the foot of the page.
float Messages::plan_on_page(const Ui& ui, const MessageRoom& room) {
  Rect free = room.gap;
  const float width = std::min(toast_width, room.page.w - 2.0F * strip_edge);
  float strip = 0.0F;
  for (Told& told : told_) {
    const float narrow = free.is_empty() ? 0.0F : height_of(ui, told, free.w);
    if (!free.is_empty() && narrow <= free.h) {
      told.rect = take_bottom(free, narrow, gap);
      continue;
    }
    const float height = height_of(ui, told, width);
    const float needed = strip + height + (strip > 0.0F ? gap : strip_edge);
    if (strip > 0.0F && needed > strip_share * room.page.h) {
      told.rect = {};
      continue;
    }
    told.rect = {room.page.right() - strip_edge - width, room.page.bottom() - needed, width,
                 height};
    strip = needed;
  }
  return std::min(strip > 0.0F ? strip + gap : 0.0F, room.page.h);
}

bool Messages::covers_what_lies_above(const Ui& ui) const {
  if (reachable_layer(ui.shown()) == Layer::Page) return false;
  const Obstacles above = obstacles_in(ui.shown(), ui.display());
  return std::ranges::any_of(told_,
                             [&](const Told& told) { return covered_by(told.rect, above) > 0.0F; });
}

Rect Messages::free_place_of(const Ui& ui, const Told& told, const Obstacles& obstacles) {
  const Rect display = ui.display();
  Rect best;
  float least = std::numeric_limits<float>::infinity();
  for (const float width : {toast_width, narrower, narrowest}) {
    const float fitting = std::min(width, display.w - 2.0F * margin);
    const float height = height_of(ui, told, fitting);
    const bool is_as_large = told.rect.w == fitting && told.rect.h == height;
    if (is_as_large && display.encloses(told.rect) && covered_by(told.rect, obstacles) <= 0.0F)
      return told.rect;
    const Rect found = free_place(display, fitting, height, margin, obstacles);
    const float covered = covered_by(found, obstacles);
    if (covered < least) least = covered, best = found;
    if (least <= 0.0F) break;
  }
  return best;
}

// As wide as it may be where nothing else is; narrow where only that finds room.
void Messages::plan_freely(const Ui& ui) {
  Obstacles obstacles = obstacles_in(ui.shown(), ui.display());
  for (Told& told : told_) {
    told.rect = free_place_of(ui, told, obstacles);
    obstacles.controls.push_back(inset(told.rect, -gap / 2.0F));
  }
}

bool Messages::draw_message(Ui& ui, const Rect& rect, Shown& shown, std::function<void()>& act) {
  if (shown.since_s < 0.0) shown.since_s = ui.time_s();
  const double left_s = message_s - (ui.time_s() - shown.since_s);
  if (!stays(shown.message)) ui.want_frame_in_s(left_s);
  const bool is_narrow = rect.w < narrow_toast_below;
  const float rise = 8.0F * (1.0F - ui.eased(shown.id + ".rise", true, 0.16F));
  const ToastAnswer answer =
      toast(ui, shown.id, moved(rect, 0.0F, is_narrow ? 0.0F : rise), words_of(shown.message));
  if (answer == ToastAnswer::Action) act = shown.message.on_action;
  return answer != ToastAnswer::Waiting || (!stays(shown.message) && left_s <= 0.0);
}

// What was planned by the frame before may cover what is new in this one: then another follows.
void Messages::watch_what_is_covered(Ui& ui) const {
  if (told_.empty()) return;
  const Obstacles now = obstacles_in(ui.drawn(), ui.display());
  for (const Told& told : told_)
    if (covered_by(told.rect, now) > told.covered) return ui.want_frame_in_s(0.0);
}

// The screen may have said something since it was planned: what is gone is not drawn, what is new
// comes with the next frame.
void Messages::draw(Ui& ui, Background& background) {
  watch_what_is_covered(ui);
  const LayerScope layer(ui.canvas(), Layer::Toast);
  std::vector<std::string> over;
  std::function<void()> act;
  for (const Told& told : told_) {
    if (told.rect.is_empty()) continue;
    if (told.work) {
      if (progress(ui, told.id, told.rect, work_of(*told.work, told.time_left)))
        background.cancel(told.id);
    } else if (Shown* shown = find(told.id)) {
      if (draw_message(ui, told.rect, *shown, act)) over.push_back(told.id);
    }
  }
  if (!messages_.empty() && messages_.back().since_s < 0.0) ui.want_frame_in_s(0.0);
  if (over.empty()) return;
  std::erase_if(messages_,
                [&](const Shown& shown) { return std::ranges::count(over, shown.id) > 0; });
  ui.want_frame_in_s(0.0);
  if (act) act();
}

}  // namespace hallux::ui

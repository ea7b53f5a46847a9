// Mode and time at the left, steps in the middle or below, health and end at the right. A done step
// is a button where it can be taken up again, and so is another that may be done next.
#include "ui/screens/operating/hud/hud_bar.h"

#include <algorithm>

#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/marks.h"

namespace hallux::ui {

namespace {

/// Mode and time, upper left.
float draw_mode(Hud& in) {
  const std::string_view mode = in.ui.text(in.hud.lesson        ? "flight.title"
                                           : in.hud.is_practice ? "operate.practice"
                                                                : "operate.assessment");
  const std::string time = clock_text(static_cast<double>(in.hud.tick) / 1000.0);
  const float mode_width = in.ui.width_of(Type::SmallMedium, mode) + 32.0F;
  const float time_width = in.ui.width_of(Type::BodyStrong, "00:00");
  const Rect bar{in.room.x, in.room.y, 6.0F + mode_width + 40.0F + time_width + hud_pad,
                 hud_bar_height};
  const HudPanel panel(in, "operate.panel.mode", bar, hud_bar_height / 2.0F);
  const Rect chip{bar.x + 6.0F, bar.y + 6.0F, mode_width, hud_bar_height - 12.0F};
  in.canvas().fill(chip, in.theme().chip, chip.h / 2.0F);
  in.canvas().text_in(chip, {Type::SmallMedium, in.theme().text, Align::Centre}, mode);
  in.canvas().icon({chip.right() + 20.0F, bar.mid_y()}, Icon::Clock, IconSize::Inline,
                   in.theme().text_caption);
  in.canvas().text({chip.right() + 38.0F, bar.mid_y()}, {Type::BodyStrong, in.theme().text}, time);
  in.ui.tell("operate.time", time, bar);
  return bar.w;
}

/// Disc and word while an attempt is recorded.
void draw_recording(Hud& in, Point at) {
  in.canvas().disc(at, 5.0F, in.hud.is_paused ? in.theme().text_caption : in.theme().bad);
  in.canvas().text({at.x + 12.0F, at.y}, {Type::Small, in.theme().text},
                   in.ui.text("operate.recording"));
}

/// Health, finish, abandon and pause, upper right. A lesson is not recorded and is only left.
float draw_state(Hud& in) {
  const bool is_well = in.hud.health.trouble.empty(), is_lesson = in.hud.lesson.has_value();
  const std::string_view rate = in.ui.text("operate.health.rate");
  const float rate_width = in.ui.width_of(Type::Small, rate);
  const float recording =
      is_lesson ? 0.0F : 34.0F + in.ui.width_of(Type::Small, in.ui.text("operate.recording"));
  const float buttons = (is_lesson ? 3.0F : 4.0F) * 38.0F + 8.0F;
  const float width = 40.0F + rate_width + recording + 16.0F + buttons;
  const Rect bar{in.room.right() - width, in.room.y, width, hud_bar_height};
  const HudPanel panel(in, "operate.panel.state", bar, hud_bar_height / 2.0F);
  draw_meaning(in.canvas(), in.theme(), is_well ? Meaning::Good : Meaning::Warn,
               {bar.x + 24.0F, bar.mid_y()}, 6.0F);
  in.canvas().text({bar.x + 38.0F, bar.mid_y()}, {Type::Small, in.theme().text}, rate);
  if (!is_lesson) draw_recording(in, {bar.x + 38.0F + rate_width + 24.0F, bar.mid_y()});
  float x = bar.right() - buttons;
  const auto press = [&](const char* id, const char* label, Icon icon, bool is_on = false) {
    const Rect place{x, bar.y + 4.0F, 36.0F, 36.0F};
    x += 38.0F;
    return icon_button(in.ui, id, place, {in.ui.text(label), icon, is_on});
  };
  in.answer.health = press("operate.health", "operate.health", Icon::Live, in.hud.is_health_open);
  in.answer.pause = press("operate.pause", in.hud.is_paused ? "operate.resume" : "operate.pause",
                          in.hud.is_paused ? Icon::Play : Icon::Pause);
  if (!is_lesson) in.answer.finish = press("operate.finish", "operate.finish", Icon::Check);
  in.answer.abandon =
      press("operate.abandon", is_lesson ? "flight.leave" : "operate.abandon", Icon::Close);
  return bar.w;
}

/// A done step: a tick, and where it can be taken up again a button around it.
void draw_done(Hud& in, Point centre, std::size_t step) {
  if (in.hud.steps[step].can_reopen) {
    const std::string id = "operate.step." + std::to_string(step + 1);
    const std::string label = in.ui.texts().say(
        "operate.take_up",
        {{"number", std::to_string(step + 1)}, {"step", in.hud.steps[step].title}});
    const Rect place{centre.x - 15.0F, centre.y - 15.0F, 30.0F, 30.0F};
    if (icon_button(in.ui, id, place, {label})) in.answer.take_up = step;
  }
  draw_meaning(in.canvas(), in.theme(), Meaning::Good, centre, 8.0F);
}

/// Around the number of a step that may be done next.
void choose_button(Hud& in, Point centre, std::size_t step) {
  const std::string label = in.ui.texts().say(
      "operate.choose", {{"number", std::to_string(step + 1)}, {"step", in.hud.steps[step].title}});
  const Rect place{centre.x - 15.0F, centre.y - 15.0F, 30.0F, 30.0F};
  if (icon_button(in.ui, "operate.step." + std::to_string(step + 1), place, {label}))
    in.answer.take_up = step;
}

/// A step as disc and number, the one at hand with its title. Returns the width.
float draw_step(Hud& in, Point at, std::size_t step, bool has_title) {
  const bool is_now = step == in.hud.step;
  Canvas& canvas = in.canvas();
  const std::string number = std::to_string(step + 1);
  const Point centre{at.x + 16.0F, at.y};
  float width = 32.0F;
  if (is_now && has_title) {
    const std::string& title = in.hud.steps[step].title;
    width = 32.0F + in.ui.width_of(Type::BodyStrong, title) + 18.0F;
    canvas.fill({at.x, at.y - 16.0F, width, 32.0F}, in.theme().accent, 16.0F);
    canvas.text({at.x + 32.0F, at.y}, {Type::BodyStrong, in.theme().on_accent}, title);
  }
  if (in.hud.steps[step].is_done && !is_now) {
    draw_done(in, centre, step);
    return width;
  }
  if (is_now) {
    canvas.disc(centre, 9.0F, has_title ? in.theme().on_accent : in.theme().accent);
  } else {
    canvas.ring(centre, 9.0F, in.theme().text_caption);
  }
  if (in.hud.steps[step].can_choose) choose_button(in, centre, step);
  const Color ink = !is_now     ? in.theme().text_secondary
                    : has_title ? in.theme().accent
                                : in.theme().on_accent;
  canvas.text_in({centre.x - 10.0F, centre.y - 9.0F, 20.0F, 18.0F},
                 {Type::CaptionMedium, ink, Align::Centre}, number);
  return width;
}

/// Where the bar of the steps lies, and whether its titles fit.
struct StepsPlace {
  Rect bar;
  bool has_title = true;
};

StepsPlace place_steps(const Hud& in, float left_used, float right_used, float button_room) {
  const std::string& title = in.hud.steps[std::min(in.hud.step, in.hud.steps.size() - 1)].title;
  const float discs = 16.0F + 32.0F * static_cast<float>(in.hud.steps.size()) + button_room;
  float width = discs + in.ui.width_of(Type::BodyStrong, title) + 18.0F;
  const float between = in.room.w - left_used - right_used - 2.0F * hud_gap;
  const float middle = in.ui.display().mid_x();
  if (width <= between) {
    const float low = in.room.x + left_used + hud_gap;
    const float x = std::clamp(middle - 0.5F * width, low, low + between - width);
    return {{x, in.room.y, width, hud_bar_height}, true};
  }
  // Beside the person's name, and below it where there is no room.
  Rect row{in.room.x, in.room.y + hud_bar_height + 8.0F, in.room.w, hud_bar_height};
  if (!intersection(in.hud.badge, row).is_empty()) take_left(row, in.hud.badge.w, 8.0F);
  const bool has_title = width <= row.w;
  if (!has_title) width = discs;
  if (width > row.w) row = {in.room.x, in.hud.badge.bottom() + 8.0F, in.room.w, hud_bar_height};
  const float x = std::clamp(middle - 0.5F * width, row.x, std::max(row.x, row.right() - width));
  return {{x, row.y, width, hud_bar_height}, has_title};
}

/// The steps between mode and state, or below them where there is no room; with the button of the
/// step at hand. Returns how far down they reach.
float draw_steps(Hud& in, float left_used, float right_used) {
  if (in.hud.steps.empty()) return in.room.y + hud_bar_height;
  ButtonSpec done{in.hud.step_action, ButtonLook::Primary, Icon::None};
  done.is_busy = in.hud.is_step_busy;
  done.why_off = in.hud.why_step_off;
  const std::string_view chip = in.ui.text("key.enter");
  const float button_w = done.label.empty() ? 0.0F : button_width(in.ui, done) + 12.0F;
  const float chip_w = done.label.empty() ? 0.0F : key_chip_width(in.ui, chip) + 12.0F;
  const StepsPlace place = place_steps(in, left_used, right_used, button_w + chip_w);
  const Rect& bar = place.bar;
  const HudPanel panel(in, "operate.panel.steps", bar, hud_bar_height / 2.0F);
  if (in.hud.step < in.hud.steps.size()) {
    in.ui.tell("operate.step",
               std::to_string(in.hud.step + 1) + " " + in.hud.steps[in.hud.step].title, bar);
  }
  float at = bar.x + 8.0F;
  for (std::size_t step = 0; step < in.hud.steps.size(); ++step)
    at += draw_step(in, {at, bar.mid_y()}, step, place.has_title);
  if (done.label.empty()) return bar.bottom();
  at += 8.0F;
  key_chip(in.ui, {at, bar.mid_y()}, chip);
  const Rect button_place{at + chip_w - 4.0F, bar.y + 5.0F, button_w - 12.0F,
                          hud_bar_height - 10.0F};
  in.answer.step = button(in.ui, "operate.step", button_place, done);
  return bar.bottom();
}

}  // namespace

float draw_hud_bar(Hud& in) {
  const float left = draw_mode(in), right = draw_state(in);
  return draw_steps(in, left, right);
}

}  // namespace hallux::ui

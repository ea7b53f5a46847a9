// Saw and push at the foot of the picture, and where the plan's values have room.
#include "ui/screens/operating/hud/hud_readings.h"

#include <algorithm>
#include <cmath>

#include "ui/screens/operating/hud/hud_aims.h"
#include "ui/screens/operating/hud/hud_hand.h"
#include "ui/screens/operating/hud/hud_plan.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/texts/number_text.h"

namespace hallux::ui {

namespace {

constexpr float tool_panel_width = 284.0F, force_panel_width = 240.0F, widest_plan = 700.0F;

void draw_tool(Hud& in, const Rect& rect) {
  const HudPanel panel(in, "operate.panel.tool", rect);
  Canvas& canvas = in.canvas();
  const Rect inner = inset(rect, hud_pad, 0.0F);
  const float saw_w = draw_hud_switch(in, "operate.saw", {inner.right(), rect.y + 23.0F},
                                      in.hud.is_saw_on ? "operate.saw.stop" : "operate.saw.start",
                                      "key.space", in.answer.saw);
  canvas.text_in({inner.x, rect.y + 12.0F, inner.w - saw_w, 22.0F},
                 {Type::BodyStrong, in.theme().text}, in.ui.text("operate.saw"));
  const std::string blade = in.ui.texts().say(
      "operate.blade", {{"width", short_text(in.hud.saw.blade.width_mm)},
                        {"thickness", fixed_text(in.hud.saw.blade.thickness_mm, 2)}});
  const float heat_w = draw_hud_heat(in, {inner.x, rect.y + 35.0F, inner.w, 20.0F});
  canvas.text_in({inner.x, rect.y + 35.0F, inner.w - heat_w, 20.0F},
                 {Type::Small, in.theme().text_secondary}, blade);
  const float y = rect.bottom() - 20.0F;
  canvas.disc({inner.x + 5.0F, y}, 5.0F,
              in.hud.is_saw_on ? in.theme().good : in.theme().text_caption);
  const std::string runs =
      in.hud.is_saw_on
          ? in.ui.texts().say("operate.saw.runs",
                              {{"rate", grouped(std::lround(in.hud.saw.cycles_per_minute))}})
          : in.text("operate.saw.still");
  const float water_w =
      draw_hud_switch(in, "operate.irrigation", {inner.right(), y},
                      in.hud.is_irrigated ? "operate.irrigation.on" : "operate.irrigation.off",
                      "key.i", in.answer.irrigation);
  canvas.text_in({inner.x + 18.0F, y - 10.0F, inner.w - 18.0F - water_w, 20.0F},
                 {Type::Small, in.theme().text}, runs);
  in.ui.tell("operate.saw.state", runs, rect);
}

// -- the push

float place_of(const Rect& track, double newton) {
  return track.w * static_cast<float>(std::clamp(newton / force_scale_newton, 0.0, 1.0));
}

/// The range that the hints ask for, marked and numbered.
void draw_push_track(Hud& in, const Rect& track, Color ink) {
  bar(in.ui, track, place_of(track, in.hud.force_newton) / track.w, ink);
  const float caption_y = track.bottom() + 7.0F;
  const TextStyle caption{Type::Caption, in.theme().text_caption, Align::Centre};
  for (const double newton : {in.hud.push.least_newton, in.hud.push.most_newton}) {
    const float x = track.x + place_of(track, newton);
    in.canvas().fill({x - 1.0F, track.y - 5.0F, 2.0F, 18.0F}, in.theme().text);
  }
  const std::string most = short_text(in.hud.push.most_newton);
  const std::string least = short_text(in.hud.push.least_newton);
  const float most_x = track.x + place_of(track, in.hud.push.most_newton);
  const float least_x = track.x + place_of(track, in.hud.push.least_newton);
  in.canvas().text_in({most_x - 14.0F, caption_y, 28.0F, 18.0F}, caption, most);
  if (most_x - least_x > 18.0F)
    in.canvas().text_in({least_x - 14.0F, caption_y, 28.0F, 18.0F}, caption, least);
  in.canvas().text_in({track.right() - 44.0F, caption_y, 44.0F, 18.0F},
                      {Type::Caption, in.theme().text_caption, Align::Right},
                      fixed_text(force_scale_newton, 0) + " N");
}

void draw_force(Hud& in, const Rect& rect) {
  const HudPanel panel(in, "operate.panel.force", rect);
  Canvas& canvas = in.canvas();
  const Rect inner = inset(rect, hud_pad, 0.0F);
  const bool is_high = in.hud.force_newton > in.hud.push.most_newton;
  const std::string range =
      in.ui.texts().say("operate.force.keep", {{"least", short_text(in.hud.push.least_newton)},
                                               {"most", short_text(in.hud.push.most_newton)}});
  Rect head{inner.x, rect.y + 12.0F, inner.w, 22.0F};
  canvas.text_in(take_right(head, in.ui.width_of(Type::Small, range) + 1.0F, 8.0F),
                 {Type::Small, is_high ? in.theme().warn_text : in.theme().text, Align::Right},
                 range);
  canvas.text_in(head, {Type::Small, in.theme().text_secondary}, in.ui.text("operate.force"));
  const std::string value = decimal_text(in.hud.force_newton);
  const float y = rect.bottom() - 32.0F, value_w = in.ui.width_of(Type::Number, value);
  canvas.text({inner.x, y}, {Type::Number, in.theme().text}, value);
  canvas.text({inner.x + value_w + 6.0F, y + 5.0F}, {Type::Small, in.theme().text_caption}, "N");
  if (is_high) {
    draw_meaning(canvas, in.theme(), Meaning::Warn, {inner.x + value_w + 11.0F, y - 12.0F}, 5.5F);
  }
  in.ui.tell("operate.force", in.text("operate.force") + " " + value + " N (" + range + ")", rect);
  draw_push_track(in, {inner.x + 96.0F, rect.bottom() - 43.0F, inner.w - 96.0F, 8.0F},
                  is_high ? in.theme().warn : in.theme().accent);
}

/// Above the saw, where there is no room beside it.
void draw_plan_above(Hud& in, float from_y) {
  const Point size = compact_plan_size(in);
  const Rect place = in.sided(
      {in.room.x, in.room.bottom() - hud_panel_height - 0.5F * hud_gap - size.y, size.x, size.y});
  if (place.y < from_y) return;
  in.side_width = place.w + hud_gap;
  draw_compact_plan(in, place);
}

}  // namespace

void draw_hud_readings(Hud& in, float from_y) {
  const float y = in.room.bottom() - hud_panel_height;
  const float force_w = std::min(force_panel_width, in.room.w);
  draw_force(in, in.sided({in.room.right() - force_w, y, force_w, hud_panel_height}));
  float left = in.room.w - force_w - hud_gap;
  if (left < (in.hud.held ? narrow_hand_panel_width : tool_panel_width)) return;
  const float tool_w = in.hud.held ? std::min(hand_panel_width, left) : tool_panel_width;
  const Rect tool = in.sided({in.room.x, y, tool_w, hud_panel_height});
  if (in.hud.held) {
    draw_hud_hand(in, tool);
  } else {
    draw_tool(in, tool);
  }
  left -= tool_w + hud_gap;
  const float middle = 0.5F * (in.room.x + tool_w + in.room.right() - force_w);
  const auto between = [&](float width) {
    return in.sided({middle - 0.5F * width, y, width, hud_panel_height});
  };
  if (!in.hud.aims.empty()) {
    const float needed = aims_width(in);
    if (needed <= left) draw_hud_aims(in, between(std::min(needed + 60.0F, left)));
    return;
  }
  if (!in.hud.plan) return;
  const float needed = plan_width(in);
  if (left < needed) return draw_plan_above(in, from_y);
  draw_hud_plan(in, between(std::clamp(widest_plan, needed, left)));
}

}  // namespace hallux::ui

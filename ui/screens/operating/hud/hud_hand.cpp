// At the left what is held and whether it runs, at the right what the hand can do with it now: no
// more than three things, each with its key.
#include "ui/screens/operating/hud/hud_hand.h"

#include <array>
#include <cmath>

#include "simulator/contact/heat_law.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/texts/number_text.h"

namespace hallux::ui {

namespace {

constexpr float switch_line = 24.0F, first_line = 23.0F;

/// What a line of the right side says and does.
struct HandSwitch {
  const char* id;
  const char* label;
  const char* key;
  bool* is_pressed;
};

std::array<HandSwitch, 3> switches_of(const HudTool& held, bool is_irrigated, HudAnswer& answer) {
  const HandSwitch forceps{"operate.forceps",
                           held.is_gripping ? "operate.forceps.release" : "operate.forceps.grip",
                           "key.f", &answer.forceps};
  if (held.is_gripping) {
    return {forceps,
            HandSwitch{"operate.drive_home", "operate.drive_home", "key.j", &answer.drive_home},
            HandSwitch{nullptr, nullptr, nullptr, nullptr}};
  }
  const HandSwitch tray{"operate.tray.open", "operate.tray.open", "key.b", &answer.tray};
  if (held.is_implant) {
    const bool takes = !held.stands_in_bone && held.can_take;
    return {tray, forceps,
            HandSwitch{"operate.leave_or_take", takes ? "operate.take" : "operate.leave", "key.x",
                       &answer.leave_or_take}};
  }
  return {tray, forceps,
          HandSwitch{"operate.irrigation",
                     is_irrigated ? "operate.irrigation.on" : "operate.irrigation.off", "key.i",
                     &answer.irrigation}};
}

std::string state_of(const Hud& in, const HudTool& held) {
  if (held.is_gripping) return in.text("operate.forceps.holds");
  if (!in.hud.is_saw_on) return in.text("operate.saw.still");
  return in.ui.texts().say("operate.tool.rate",
                           {{"rate", grouped(std::lround(held.rate_per_minute))}});
}

Rect shortened(Rect line, float by) noexcept {
  line.w -= by;
  return line;
}

/// Title, size and state; and where there is room the drive's own switch below them.
void draw_left(Hud& in, const HudTool& held, const Rect& left, bool is_narrow) {
  Canvas& canvas = in.canvas();
  const std::string title = held.is_gripping ? in.text("operate.forceps") : held.title;
  const std::string runs = state_of(in, held);
  const Rect title_line{left.x, left.y + 12.0F, left.w, 22.0F};
  const Rect size_line{left.x, left.y + 35.0F, left.w, 20.0F};
  const float heat_w = draw_hud_heat(in, is_narrow ? size_line : title_line);
  canvas.text_in(shortened(title_line, is_narrow ? 0.0F : heat_w),
                 {Type::BodyStrong, in.theme().text}, title);
  canvas.text_in(shortened(size_line, is_narrow ? heat_w : 0.0F),
                 {Type::Small, in.theme().text_secondary},
                 held.is_gripping ? in.text("operate.forceps.led") : held.size, is_narrow);
  const float y = left.bottom() - 20.0F;
  float used = 0.0F;
  if (!held.is_gripping && !is_narrow) {
    used = draw_hud_switch(in, "operate.saw", {left.right(), y},
                           in.hud.is_saw_on ? "operate.saw.stop" : "operate.saw.start", "key.space",
                           in.answer.saw);
  }
  canvas.disc({left.x + 5.0F, y}, 5.0F,
              in.hud.is_saw_on ? in.theme().good : in.theme().text_caption);
  canvas.text_in({left.x + 18.0F, y - 10.0F, left.w - 18.0F - used, 20.0F},
                 {Type::Small, in.theme().text}, runs, true);
  in.ui.tell("operate.saw.state", runs, left);
  in.ui.tell("operate.tool", held.is_gripping ? title : title + ", " + held.size, left);
}

}  // namespace

float draw_hud_heat(Hud& in, const Rect& line) {
  if (!in.hud.bone_celsius) return 0.0F;
  const bool is_hot = *in.hud.bone_celsius > simulator::hot_celsius;
  const std::string words =
      in.ui.texts().say("operate.bone_heat", {{"celsius", fixed_text(*in.hud.bone_celsius, 0)}});
  const float words_w = in.ui.width_of(Type::Small, words);
  in.canvas().text({line.right() - words_w, line.mid_y()},
                   {Type::Small, is_hot ? in.theme().warn_text : in.theme().text_secondary}, words);
  in.ui.tell("operate.heat", words, line);
  if (!is_hot) return words_w + 12.0F;
  draw_meaning(in.canvas(), in.theme(), Meaning::Warn,
               {line.right() - words_w - 12.0F, line.mid_y()}, 5.5F);
  return words_w + 30.0F;
}

float draw_hud_switch(Hud& in, const char* id, Point right_middle, const char* label,
                      const char* key, bool& is_pressed) {
  const std::string_view chip = in.ui.text(key);
  const ButtonSpec spec{in.ui.text(label), ButtonLook::Ghost};
  const float chip_w = key_chip_width(in.ui, chip);
  const float width = in.ui.width_of(Type::BodyMedium, spec.label) + 20.0F;
  key_chip(in.ui, {right_middle.x - chip_w, right_middle.y}, chip);
  const Rect place{right_middle.x - chip_w - width - 2.0F, right_middle.y - 14.0F, width, 28.0F};
  is_pressed = button(in.ui, id, place, spec);
  return chip_w + width + 8.0F;
}

void draw_hud_hand(Hud& in, const Rect& rect) {
  const HudPanel panel(in, "operate.panel.tool", rect);
  const HudTool& held = *in.hud.held;
  const Rect inner = inset(rect, hud_pad, 0.0F);
  float widest = 0.0F, y = rect.y + first_line;
  for (const HandSwitch& each : switches_of(held, in.hud.is_irrigated, in.answer)) {
    if (each.id == nullptr) continue;
    widest = std::max(widest, draw_hud_switch(in, each.id, {inner.right(), y}, each.label, each.key,
                                              *each.is_pressed));
    y += switch_line;
  }
  draw_left(in, held, {inner.x, rect.y, inner.w - widest - 8.0F, rect.h},
            rect.w < hand_panel_width);
}

}  // namespace hallux::ui

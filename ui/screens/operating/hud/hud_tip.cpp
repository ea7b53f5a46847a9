// Force and distances where one looks: beside the teeth. A bar for the push on one side, a label
// with the ways to bone, far side, hinge and plan on the other, tied to the tip by a line.
#include "ui/screens/operating/hud/hud_tip.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hallux::ui {

namespace {

constexpr float label_way = 130.0F, label_rise = 60.0F, line_height = 20.0F, label_pad = 12.0F;
constexpr float place_step = 16.0F;

/// The push as a bar beside the teeth.
void draw_force_at_blade(Hud& in) {
  if (in.hud.force_newton < 0.2) return;
  const Point tip = *in.hud.tip;
  const float side = in.hud.is_left_handed ? 1.0F : -1.0F;
  const Rect track{tip.x + side * 72.0F - 4.0F, tip.y - 40.0F, 8.0F, 80.0F};
  if (!in.room.encloses(track)) return;
  Canvas& canvas = in.canvas();
  canvas.line({track.mid_x() - side * 8.0F, track.mid_y()}, {tip.x + side * 14.0F, tip.y},
              faded(in.theme().text, 0.5F), 1.5F);
  canvas.fill(inset(track, -3.0F, -3.0F), in.theme().hud, 7.0F);
  canvas.fill(track, in.theme().chip, 4.0F);
  const double share = std::clamp(in.hud.force_newton / force_scale_newton, 0.0, 1.0);
  const float height = std::max(4.0F, track.h * static_cast<float>(share));
  const bool is_high = in.hud.force_newton > in.hud.push.most_newton;
  canvas.fill({track.x, track.bottom() - height, track.w, height},
              is_high ? in.theme().warn : in.theme().accent, 4.0F);
  for (const double newton : {in.hud.push.least_newton, in.hud.push.most_newton}) {
    const float mark = track.bottom() - track.h * static_cast<float>(newton / force_scale_newton);
    canvas.fill({track.x - 4.0F, mark - 1.0F, 16.0F, 2.0F}, in.theme().text);
  }
  in.ui.tell("operate.force.tip", decimal_text(in.hud.force_newton) + " N", track);
}

/// Where nothing else stands, as near as may be; where there is no such place, as near as may be.
Rect nearest_free_place(const Hud& in, Rect wanted) {
  const float right = std::max(in.room.x, in.room.right() - wanted.w);
  const float top = in.room.y + hud_bar_height;
  const float bottom = std::max(in.room.y, in.room.bottom() - hud_panel_height - wanted.h - 8.0F);
  wanted.x = std::clamp(wanted.x, in.room.x, right);
  wanted.y = std::clamp(wanted.y, std::min(top, bottom), bottom);
  Rect best = wanted;
  float least = std::numeric_limits<float>::infinity();
  for (float x = in.room.x; x <= right; x += place_step) {
    for (float y = std::min(top, bottom); y <= in.room.bottom() - wanted.h; y += place_step) {
      const Rect place{x, y, wanted.w, wanted.h};
      const float way = std::hypot(x - wanted.x, y - wanted.y);
      if (way < least && !in.has_panel(place)) least = way, best = place;
    }
  }
  return best;
}

/// Beside the tip, where the label hides neither saw nor panel; nearer to the tip where there is
/// little room.
Rect place_label(const Hud& in, float width, float height) {
  const Point tip = *in.hud.tip;
  for (const float way : {label_way, 0.75F * label_way, 0.5F * label_way}) {
    const float right = tip.x + way, left = tip.x - way - width;
    for (const float x :
         {in.hud.is_left_handed ? left : right, in.hud.is_left_handed ? right : left}) {
      for (const float y : {tip.y + label_rise - height, tip.y - label_rise,
                            tip.y + 1.8F * label_rise, tip.y - 1.8F * label_rise - height}) {
        const Rect place{x, y, width, height};
        if (in.room.encloses(place) && !in.has_tool_behind(place) && !in.has_panel(place))
          return place;
      }
    }
  }
  // Rather over the saw than over a panel.
  for (const float share : {0.5F, 0.75F, 0.25F, 1.0F, 0.0F}) {
    for (const float y : {tip.y + label_rise, tip.y - label_rise - height}) {
      const Rect place{tip.x - share * width, y, width, height};
      if (in.room.encloses(place) && !in.has_panel(place)) return place;
    }
  }
  return nearest_free_place(in, {tip.x + label_way, tip.y + label_rise - height, width, height});
}

/// At the label's side; at its upper or lower edge where it lies right below or above the tip.
Point end_of_leader(Point tip, const Rect& label) {
  if (tip.x < label.x) return {label.x, label.mid_y()};
  if (tip.x > label.right()) return {label.right(), label.mid_y()};
  return {tip.x, tip.y < label.y ? label.y : label.bottom()};
}

void draw_label(Hud& in) {
  if (in.hud.tip_lines.empty()) return;
  float width = 0.0F;
  for (const std::string& line : in.hud.tip_lines)
    width = std::max(width, in.ui.width_of(Type::SmallMedium, line));
  width += 2.0F * label_pad;
  const float height = line_height * static_cast<float>(in.hud.tip_lines.size()) + label_pad;
  const Rect label = place_label(in, width, height);
  in.canvas().line(*in.hud.tip, end_of_leader(*in.hud.tip, label), faded(in.theme().text, 0.5F),
                   1.5F);
  draw_hud_panel(in.canvas(), in.theme(), label, radius::control);
  in.canvas().set_giving_way(true);
  float y = label.y + 0.5F * label_pad;
  for (const std::string& line : in.hud.tip_lines) {
    in.canvas().text_in({label.x + label_pad, y, width - 2.0F * label_pad + 1.0F, line_height},
                        {Type::SmallMedium, in.theme().text}, line);
    y += line_height;
  }
  in.canvas().set_giving_way(false);
  std::string told;
  for (const std::string& line : in.hud.tip_lines) told += (told.empty() ? "" : ". ") + line;
  in.ui.tell("operate.ahead", told, label);
}

}  // namespace

void draw_tip_force(Hud& in) {
  if (in.hud.tip) draw_force_at_blade(in);
}

void draw_tip_label(Hud& in) {
  if (in.hud.tip) draw_label(in);
}

}  // namespace hallux::ui

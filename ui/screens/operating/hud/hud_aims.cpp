#include "ui/screens/operating/hud/hud_aims.h"

namespace hallux::ui {

namespace {

constexpr float column_gap = 28.0F;

float aim_width(const Hud& in, const HudAim& aim) {
  return std::max(in.ui.width_of(Type::Small, in.ui.text(aim.name_id)),
                  in.ui.width_of(Type::CardTitle, aim.value)) +
         1.0F;
}

}  // namespace

float aims_width(const Hud& in) {
  float width = 2.0F * hud_pad - column_gap;
  for (const HudAim& aim : in.hud.aims) width += aim_width(in, aim) + column_gap;
  return width;
}

void draw_hud_aims(Hud& in, const Rect& rect) {
  const HudPanel panel(in, "operate.panel.plan", rect);
  const float spare =
      (rect.w - aims_width(in)) / static_cast<float>(std::max<std::size_t>(1, in.hud.aims.size()));
  float x = rect.x + hud_pad;
  for (const HudAim& aim : in.hud.aims) {
    const Rect column{x, rect.y + 16.0F, aim_width(in, aim) + spare, rect.h - 32.0F};
    const std::string_view name = in.ui.text(aim.name_id);
    in.canvas().text_in({column.x, column.y, column.w, 20.0F},
                        {Type::Small, in.theme().text_secondary}, name);
    in.canvas().text_in({column.x, column.y + 26.0F, column.w, 28.0F},
                        {Type::CardTitle, in.theme().text}, aim.value);
    in.ui.tell(std::string("operate.") + aim.id, std::string(name) + " " + aim.value, column);
    x += column.w + column_gap;
  }
}

}  // namespace hallux::ui

#include "ui/screens/replay/hand_panel.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "simulator/base/units.h"
#include "ui/widgets/shapes.h"
#include "ui/widgets/texts/number_text.h"

namespace hallux::ui {

namespace {

/// Lower pictures have no room for it.
constexpr float least_height = 80.0F;

}  // namespace

void draw_hand_panel(Ui& ui, const Rect& rect, const HandAtMoment& hand) {
  const std::array<std::pair<std::string_view, std::string>, 4> facts{{
      {ui.text("replay.force"),
       ui.texts().say("replay.newton", {{"value", fixed_text(hand.force_newton, 1)}})},
      {ui.text("replay.to_plan"),
       ui.texts().say("result.mm", {{"distance", fixed_text(std::abs(hand.to_plan_mm), 1)}})},
      {ui.text("replay.tilt"),
       ui.texts().say("replay.degrees",
                      {{"value", fixed_text(degree_from_radian(hand.tilt_rad), 1)}})},
      {ui.text("replay.speed"),
       ui.texts().say("replay.mm_s", {{"value", fixed_text(hand.speed_mm_s, 0)}})},
  }};
  std::array<float, facts.size()> widths{};
  float width = 32.0F;
  std::size_t count = 0;
  for (; count < facts.size(); ++count) {
    // Room for the widest value, so that the panel does not tremble with its digits.
    widths[count] = ui.width_of(Type::Small, facts[count].first) + 8.0F +
                    std::max(64.0F, ui.width_of(Type::SmallMedium, facts[count].second)) + 20.0F;
    if (width + widths[count] > rect.w) break;
    width += widths[count];
  }
  if (count == 0 || rect.h < least_height) return;
  const Rect panel{rect.x, rect.bottom() - 40.0F, width, 40.0F};
  draw_hud_panel(ui.canvas(), ui.theme(), panel, 20.0F);
  float x = panel.x + 20.0F;
  for (std::size_t i = 0; i < count; ++i) {
    const float name = ui.canvas().text({x, panel.mid_y()},
                                        {Type::Small, ui.theme().text_secondary}, facts[i].first);
    ui.canvas().text({x + name + 8.0F, panel.mid_y()}, {Type::SmallMedium, ui.theme().text},
                     facts[i].second);
    x += widths[i];
  }
}

}  // namespace hallux::ui

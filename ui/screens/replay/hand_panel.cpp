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

/// Of the distance, the turn and the last fact.
struct FactNames {
  std::string_view distance, turn, last;
};
constexpr FactNames saw_names{"replay.to_plan", "replay.tilt", "replay.speed"},
    driver_names{"replay.off_axis", "replay.tilt", "replay.depth"},
    forceps_names{"replay.moved", "replay.turned", "replay.speed"};

const FactNames& names_of(HeldTool held) noexcept {
  switch (held) {
    case HeldTool::Driver:
      return driver_names;
    case HeldTool::Forceps:
      return forceps_names;
    case HeldTool::Saw:
      break;
  }
  return saw_names;
}

}  // namespace

std::array<HandFact, 4> hand_facts(const Texts& texts, const HandAtMoment& hand) {
  const FactNames& names = names_of(hand.tool.held);
  const auto said = [&](std::string_view words, const char* name, std::string value) {
    return texts.say(words, {{name, std::move(value)}});
  };
  const auto mm = [&](double distance_mm) {
    return said("result.mm", "distance", fixed_text(distance_mm, 1));
  };
  const std::string last = hand.tool.held == HeldTool::Driver
                               ? mm(hand.to_plan.depth_mm)
                               : said("replay.mm_s", "value", fixed_text(hand.speed_mm_s, 0));
  const double tilt_deg = degree_from_radian(hand.to_plan.tilt_rad);
  return {HandFact{std::string(texts.text("replay.force")),
                   said("replay.newton", "value", fixed_text(hand.force_newton, 1))},
          HandFact{std::string(texts.text(names.distance)), mm(std::abs(hand.to_plan.distance_mm))},
          HandFact{std::string(texts.text(names.turn)),
                   said("replay.degrees", "value", fixed_text(tilt_deg, 1))},
          HandFact{std::string(texts.text(names.last)), last}};
}

void draw_hand_panel(Ui& ui, const Rect& rect, const HandAtMoment& hand) {
  const std::array<HandFact, 4> facts = hand_facts(ui.texts(), hand);
  std::array<float, facts.size()> widths{};
  float width = 32.0F;
  std::size_t count = 0;
  for (; count < facts.size(); ++count) {
    // Room for the widest value, so that the panel does not tremble with its digits.
    widths[count] = ui.width_of(Type::Small, facts[count].name) + 8.0F +
                    std::max(64.0F, ui.width_of(Type::SmallMedium, facts[count].value)) + 20.0F;
    if (width + widths[count] > rect.w) break;
    width += widths[count];
  }
  if (count == 0 || rect.h < least_height) return;
  const Rect panel{rect.x, rect.bottom() - 40.0F, width, 40.0F};
  draw_hud_panel(ui.canvas(), ui.theme(), panel, 20.0F);
  float x = panel.x + 20.0F;
  for (std::size_t i = 0; i < count; ++i) {
    const float name = ui.canvas().text({x, panel.mid_y()},
                                        {Type::Small, ui.theme().text_secondary}, facts[i].name);
    ui.canvas().text({x + name + 8.0F, panel.mid_y()}, {Type::SmallMedium, ui.theme().text},
                     facts[i].value);
    x += widths[i];
  }
}

}  // namespace hallux::ui

// Lines of words: what to do next and why a button is off, below the steps; what the hand does, at
// the lower edge.
#include "ui/screens/operating/hud/hud_hints.h"

#include <algorithm>

#include "ui/screens/operating/hand/gestures.h"
#include "ui/widgets/controls/marks.h"

namespace hallux::ui {

namespace {

constexpr float line_gap = 8.0F, sign_room = 36.0F, widest_share = 0.62F, foot_line = 18.0F;

/// A sentence on a panel in the middle, broken where it is long; returns where it ends.
float draw_sentence(Hud& in, const char* id, Meaning meaning, const std::string& words, float y) {
  if (words.empty()) return y;
  const float most = widest_share * in.room.w;
  const float width = std::min(most, in.ui.width_of(Type::Small, words) + sign_room + 20.0F);
  const float inner = width - sign_room - 16.0F;
  const float height = in.ui.paragraph_height(Type::Small, words, inner) + 14.0F;
  const Rect rect{in.ui.display().mid_x() - 0.5F * width, y + line_gap, width, height};
  const HudPanel panel(in, id, rect, std::min(18.0F, 0.5F * height),
                       in.hud.lesson ? HudFading::Never : HudFading::BehindTool);
  draw_meaning(in.canvas(), in.theme(), meaning, {rect.x + 20.0F, rect.y + 17.0F}, 6.0F);
  in.canvas().paragraph({rect.x + sign_room, rect.y + 7.0F, inner, height - 14.0F},
                        {Type::Small, in.theme().text}, words);
  in.ui.tell(id, words, rect);
  return rect.bottom();
}

std::string usual_gestures(const Hud& in) {
  std::string words;
  for (const BoundGesture& bound : bound_gestures) {
    if (!bound.is_usual) continue;
    if (!words.empty()) words += "   ·   ";
    words += in.text(bound.input_text) + ": " + in.text(bound.gesture_text);
  }
  return words;
}

std::string foot_of(const Hud& in) {
  if (in.hud.hand == HandState::Off) return {};
  if (in.hud.hand == HandState::Lifted) return in.text("operate.foot.lifted");
  std::string words = usual_gestures(in);
  if (in.hud.hand == HandState::LedFree) words = in.text("operate.foot.free") + "   " + words;
  return words;
}

}  // namespace

float draw_hud_hints(Hud& in, float y) {
  y = draw_sentence(in, "operate.reason", Meaning::Info, in.hud.why_step_off, y);
  return draw_sentence(in, "operate.hint", Meaning::Neutral, in.hud.hint, y);
}

void draw_hud_foot(Hud& in) {
  const char* id = in.hud.is_simulated  ? "operate.simulated"
                   : in.hud.is_reviewed ? nullptr
                                        : "operate.not_reviewed";
  const TextStyle style{Type::Caption, in.theme().text_caption, Align::Centre};
  const float margin = in.ui.display().bottom() - in.room.bottom();
  const float height = std::min(foot_line, 0.5F * margin);
  const float y = in.room.bottom() + std::min(4.0F, margin - 2.0F * height);
  const std::string foot = foot_of(in);
  if (!foot.empty()) {
    const Rect line{in.room.x, y, in.room.w, height};
    in.canvas().text_in(line, {Type::Caption, in.theme().text_secondary, Align::Centre}, foot,
                        true);
    in.ui.tell("operate.foot", foot, line);
  }
  if (id == nullptr) return;
  in.canvas().text_in({in.room.x, y + height, in.room.w, height}, style, in.ui.text(id));
}

}  // namespace hallux::ui

// The lines at the lower edge. They are broken between movements and between words, never cut: in a
// low window the panels make room.
#include "ui/screens/operating/hud/hud_foot.h"

#include <algorithm>
#include <sstream>

#include "ui/screens/operating/hand/gestures.h"

namespace hallux::ui {

namespace {

constexpr float foot_line = 17.0F, edge_x = 12.0F, edge_y = 3.0F, least_gap = 3.0F;
constexpr std::string_view between_parts = "   ·   ", between_words = " ";

/// What is not broken, and what stands before it where it does not begin a line.
struct Part {
  std::string_view before;
  std::string words;
};

void add_words(std::vector<Part>& parts, std::string_view sentence) {
  std::istringstream words{std::string(sentence)};
  std::string_view before = between_parts;
  for (std::string word; words >> word; before = between_words) parts.push_back({before, word});
}

std::vector<Part> parts_of_hand(const Ui& ui, HandState hand) {
  std::vector<Part> parts;
  if (hand == HandState::Off) return parts;
  if (hand == HandState::Lifted) {
    add_words(parts, ui.text("operate.foot.lifted"));
    return parts;
  }
  if (hand == HandState::OnDevice) {
    add_words(parts, ui.text("operate.foot.device"));
    return parts;
  }
  if (hand == HandState::LedFree) add_words(parts, ui.text("operate.foot.free"));
  for (const BoundGesture& bound : bound_gestures) {
    if (!bound.is_usual) continue;
    parts.push_back({between_parts, std::string(ui.text(bound.input_text)) + ": " +
                                        std::string(ui.text(bound.gesture_text))});
  }
  return parts;
}

std::string joined(const std::vector<Part>& parts) {
  std::string all;
  for (const Part& part : parts) all += (all.empty() ? "" : std::string(part.before)) + part.words;
  return all;
}

/// What an operation is that nobody may take for more.
void add_status(std::vector<Part>& parts, const Ui& ui, const OperatingHud& hud) {
  if (hud.is_reviewed && !hud.is_simulated) return;
  parts.push_back({between_parts, std::string(ui.text(hud.is_simulated ? "operate.simulated"
                                                                       : "operate.not_reviewed"))});
}

std::vector<std::string> broken(const Ui& ui, const std::vector<Part>& parts, float width) {
  std::vector<std::string> lines;
  for (const Part& part : parts) {
    const std::string longer =
        lines.empty() ? part.words : lines.back() + std::string(part.before) + part.words;
    if (!lines.empty() && ui.width_of(Type::Caption, longer) <= width) {
      lines.back() = longer;
    } else {
      lines.push_back(part.words);
    }
  }
  return lines;
}

}  // namespace

HudFoot lay_out_foot(const Ui& ui, const OperatingHud& hud, float width) {
  std::vector<Part> parts = parts_of_hand(ui, hud.hand);
  HudFoot foot;
  foot.hand = joined(parts);
  add_status(parts, ui, hud);
  foot.lines = broken(ui, parts, width - 2.0F * edge_x);
  if (foot.lines.empty()) return foot;
  for (const std::string& line : foot.lines)
    foot.width = std::max(foot.width, ui.width_of(Type::Caption, line) + 2.0F * edge_x);
  foot.height = foot_line * static_cast<float>(foot.lines.size()) + 2.0F * edge_y;
  return foot;
}

Rect above_foot(const Rect& room, const Rect& display, const HudFoot& foot) {
  const float margin = display.bottom() - room.bottom();
  const float lacking = foot.height + 2.0F * least_gap - margin;
  return {room.x, room.y, room.w, room.h - std::max(0.0F, lacking)};
}

void draw_hud_foot(Hud& in, const HudFoot& foot) {
  if (foot.lines.empty()) return;
  const float below = in.ui.display().bottom() - in.room.bottom();
  const float y = in.room.bottom() + std::min(8.0F, 0.5F * (below - foot.height));
  const Rect ground{in.ui.display().mid_x() - 0.5F * foot.width, y, foot.width, foot.height};
  draw_hud_panel(in.canvas(), in.theme(), ground, radius::control);
  Rect line{ground.x, ground.y + edge_y, ground.w, foot_line};
  for (const std::string& words : foot.lines) {
    in.canvas().text_in(line, {Type::Caption, in.theme().text_secondary, Align::Centre}, words);
    line.y += foot_line;
  }
  if (!foot.hand.empty()) in.ui.tell("operate.foot", foot.hand, ground);
}

}  // namespace hallux::ui

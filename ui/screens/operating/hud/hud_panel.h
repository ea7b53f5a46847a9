/// A panel over the picture of an operation, and what all of them are drawn from: its ground, its
/// side, its fading.
/// Inside this corner only.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "ui/screens/operating/hud/operating_hud.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

inline constexpr float hud_bar_height = 44.0F, hud_panel_height = 92.0F, hud_gap = 16.0F,
                       hud_pad = 20.0F;
/// Of a panel that the tool passes behind.
inline constexpr float faded_presence = 0.25F;
/// The end of the meter of the push.
inline constexpr double force_scale_newton = 30.0;
/// Of the room: lines of hints are no wider.
inline constexpr float widest_hint_share = 0.62F;

/// One drawing of the panels.
struct Hud {
  Ui& ui;
  const OperatingHud& hud;
  /// Inside the inset.
  Rect room;
  HudAnswer answer;
  /// Of those drawn so far, and the messages over them.
  std::vector<Rect> panels = {};
  /// What a panel above the lower ones takes at a side.
  float side_width = 0.0F;

  const Theme& theme() const { return ui.theme(); }
  Canvas& canvas() const { return ui.canvas(); }
  std::string text(std::string_view id) const { return std::string(ui.text(id)); }
  /// The panel in the mirror where the left hand leads.
  Rect sided(const Rect& rect) const {
    if (!hud.is_left_handed) return rect;
    return {room.x + room.right() - rect.right(), rect.y, rect.w, rect.h};
  }
  bool has_panel(const Rect& rect) const {
    return std::any_of(panels.begin(), panels.end(),
                       [&](const Rect& panel) { return !intersection(panel, rect).is_empty(); });
  }
  bool has_tool_behind(const Rect& rect) const {
    return std::any_of(hud.tool.begin(), hud.tool.end(),
                       [&](const ToolPlace& place) { return is_behind(place, rect); });
  }
  bool has_fading_tool_behind(const Rect& rect) const {
    return std::any_of(hud.tool.begin(), hud.tool.end(), [&](const ToolPlace& place) {
      return place.fades_panels && is_behind(place, rect);
    });
  }
  static bool is_behind(const ToolPlace& place, const Rect& rect) {
    return inset(rect, -place.radius, -place.radius).contains(place.at);
  }
};

/// Whether it fades where the tool passes behind it: what is to be learned now stays readable.
enum class HudFading { BehindTool, Never };

/// Its ground, and the fading of all that is drawn on it until the scope ends. Over it the pointer
/// is a pointer: the saw stays where it is.
class HudPanel {
 public:
  /// name  a text of the catalogue
  HudPanel(Hud& in, const char* name, const Rect& rect, float corner = radius::picture,
           HudFading fading = HudFading::BehindTool)
      : canvas_(in.canvas()) {
    in.ui.area(name, in.ui.text(name), rect);
    in.panels.push_back(rect);
    if (fading == HudFading::BehindTool && in.has_fading_tool_behind(rect))
      canvas_.set_presence(faded_presence);
    draw_hud_panel(canvas_, in.theme(), rect, corner);
  }
  HudPanel(const HudPanel&) = delete;
  HudPanel& operator=(const HudPanel&) = delete;
  ~HudPanel() { canvas_.set_presence(1.0F); }

 private:
  Canvas& canvas_;
};

}  // namespace hallux::ui

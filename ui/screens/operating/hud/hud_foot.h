/// The lines at the lower edge of the window: what the hand does, and what the operation is.
/// Inside this corner only.
#pragma once

#include <string>
#include <vector>

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

struct HudFoot {
  std::vector<std::string> lines;
  /// What is told of the hand.
  std::string hand;
  float width = 0.0F, height = 0.0F;
};

/// In as many lines as that width takes; of height 0 where there is nothing to tell.
HudFoot lay_out_foot(const Ui& ui, const OperatingHud& hud, float width);

/// What is left of a room above the foot.
Rect above_foot(const Rect& room, const Rect& display, const HudFoot& foot);

/// Below the room, on a ground of its own.
void draw_hud_foot(Hud& in, const HudFoot& foot);

}  // namespace hallux::ui

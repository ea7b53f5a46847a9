/// Lines of words: the next thing to do, and why a button is off.
/// Inside this corner only.
#pragma once

#include <vector>

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// Where they stand below the bar, and where they were drawn.
struct HintsPlace {
  /// Down to where they reach below the bar, be they drawn there or not.
  float high_bottom = 0.0F;
  /// Those above the lower panels.
  std::vector<Rect> low = {};
};

/// Below the bar, beginning at `y`, or ending above `lower_end` where the tool passes behind them.
HintsPlace draw_hud_hints(Hud& in, float y, float lower_end);

}  // namespace hallux::ui

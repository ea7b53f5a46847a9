/// Lines of words: the next thing to do, and why a button is off.
/// Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// Below the bar, beginning at `y`, or ending above `lower_end` where the tool passes behind them;
/// returns how far down they reach below the bar.
float draw_hud_hints(Hud& in, float y, float lower_end);

}  // namespace hallux::ui

/// Lines of words: the next thing to do, why a button is off, and what the hand does.
/// Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// Below the bar, beginning at `y`, or ending above `lower_end` where the tool passes behind them;
/// returns how far down they reach below the bar.
float draw_hud_hints(Hud& in, float y, float lower_end);
/// At the lower edge of the window.
void draw_hud_foot(Hud& in);

}  // namespace hallux::ui

/// Lines of words: the next thing to do, why a button is off, and what the hand does.
/// Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// Below the bar, beginning at `y`; returns where they end.
float draw_hud_hints(Hud& in, float y);
/// At the lower edge of the window.
void draw_hud_foot(Hud& in);

}  // namespace hallux::ui

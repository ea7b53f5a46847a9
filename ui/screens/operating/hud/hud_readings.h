/// Tool, plan and force at the foot of the picture. Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// As many of the three as the window is wide for, force first; the plan in short lines above the
/// saw where it has no room beside it and they end below `from_y`.
void draw_hud_readings(Hud& in, float from_y);

}  // namespace hallux::ui

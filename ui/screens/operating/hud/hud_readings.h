/// Tool, plan and force at the foot of the picture. Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// As many of the three as the window is wide for, force first.
void draw_hud_readings(Hud& in);

}  // namespace hallux::ui

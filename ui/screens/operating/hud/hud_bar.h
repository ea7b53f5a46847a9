/// Mode, time, steps and state at the upper edge. Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// Returns how far down they reach.
float draw_hud_bar(Hud& in);

}  // namespace hallux::ui

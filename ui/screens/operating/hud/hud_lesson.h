/// The lesson at hand: its task, its goal, and the ways on without it. Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// Below the bar, beginning at `y`; returns where it ends. Nothing where no lesson is shown.
float draw_hud_lesson(Hud& in, float y);

}  // namespace hallux::ui

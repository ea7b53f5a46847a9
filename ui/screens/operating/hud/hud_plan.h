/// The blade against the plan, by what the rubric scores. Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// The width that its tracks take, captions and widest values with them.
float plan_width(const Hud& in);
void draw_hud_plan(Hud& in, const Rect& rect);

/// The same without tracks, one line for each value, for small windows.
Point compact_plan_size(const Hud& in);
void draw_compact_plan(Hud& in, const Rect& rect);

}  // namespace hallux::ui

/// A tool's axis or a fragment against the plan, in place of the blade's read-outs.
/// Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// The width that its values take side by side.
float aims_width(const Hud& in);
void draw_hud_aims(Hud& in, const Rect& rect);

}  // namespace hallux::ui

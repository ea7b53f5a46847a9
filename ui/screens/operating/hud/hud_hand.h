/// What is in the hand where there is a tray: the tool, its drive, and what is done with it.
/// Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// In less than the first the drive has no button of its own (the space bar and a click lead it),
/// and the tool's size may be shortened.
inline constexpr float hand_panel_width = 408.0F, narrow_hand_panel_width = 284.0F;

/// needs   a tool is held
void draw_hud_hand(Hud& in, const Rect& rect);

/// The hottest bone at the right of the line, where it is told, with a sign from where bone
/// suffers. Returns the width that it takes.
float draw_hud_heat(Hud& in, const Rect& line);

/// A switch: a small button at the right end of a line, with its key. Returns the width.
float draw_hud_switch(Hud& in, const char* id, Point right_middle, const char* label,
                      const char* key, bool& is_pressed);

}  // namespace hallux::ui

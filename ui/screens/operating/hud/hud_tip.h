/// Force and distances where one looks: beside the teeth. Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// Nothing where the teeth are not on the window.
void draw_hud_tip(Hud& in);

}  // namespace hallux::ui

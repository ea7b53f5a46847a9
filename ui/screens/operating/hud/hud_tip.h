/// Force and distances where one looks: beside the teeth. Inside this corner only.
#pragma once

#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {

/// Both nothing where the teeth are not on the window.
void draw_tip_force(Hud& in);
/// Beside the panels that were drawn before.
void draw_tip_label(Hud& in);

}  // namespace hallux::ui

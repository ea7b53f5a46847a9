/// What the hand does at a moment of a replay, in numbers. Inside this corner only.
#pragma once

#include "ui/screens/replay/replay_material.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Force, way and tilt to the plan, speed, at the lower left of `rect`; as many as have room.
void draw_hand_panel(Ui& ui, const Rect& rect, const HandAtMoment& hand);

}  // namespace hallux::ui

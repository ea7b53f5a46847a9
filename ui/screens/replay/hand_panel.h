/// What the hand does at a moment of a replay, in numbers. Inside this corner only.
#pragma once

#include <array>
#include <string>

#include "ui/screens/replay/replay_material.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

struct HandFact {
  std::string name, value;
};
/// Of a saw force, way and tilt to the planned face, speed; of a driver force, way and tilt to the
/// planned axis, depth of the tip beyond its entry; of a piece in the forceps force, how far it has
/// come and turned, speed.
std::array<HandFact, 4> hand_facts(const Texts& texts, const HandAtMoment& hand);

/// The facts at the lower left of `rect`; as many as have room.
void draw_hand_panel(Ui& ui, const Rect& rect, const HandAtMoment& hand);

}  // namespace hallux::ui

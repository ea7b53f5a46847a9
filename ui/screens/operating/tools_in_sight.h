/// The tools of an operation in its picture: what is in the hand, and in practice where wires,
/// screws and fragments are planned. Inside this corner only.
#pragma once

#include "ui/render/scene/scene.h"
#include "ui/screens/operating/operating_viewport.h"

namespace hallux::ui {

/// What of a tool is asked for its outline: a saw's own, or the working end of another tool.
simulator::Blade outline_blade(const simulator::Tool& tool) noexcept;

/// The saw as it stands; of another tool its outline, which is not drawn.
SawInScene saw_in_sight(const OperationInSight& shown);

/// Saw, driver or forceps, as the hand holds them.
/// saw     of saw_in_sight
/// swings  another in each picture while a drive runs
void add_tool(Scene& scene, const OperationInSight& shown, const SawInScene& saw, double swings);

/// In practice: the planned wire or screw at hand, and the place to which a fragment is led.
void add_planned_fixation(Scene& scene, const OperationInSight& shown);

}  // namespace hallux::ui

/// Where somebody stands and holds the saw when an operation begins. A scenario says it; one that
/// does not gets the saw square to the bone's axes, because the plan would else be found for the
/// trainee, and the operator's view.
#pragma once

#include "scenarios/plan.h"
#include "ui/render/scene/camera.h"

namespace hallux::ui {

/// World from tool: off the bone on the side of the approach. What the plan asks beyond that is the
/// trainee's to find.
RigidTransform start_pose(const scenarios::Scenario& scenario, simulator::Bones bones,
                          const scenarios::Plan& plan);
/// The site of the first cut as one stands before it.
Camera start_camera(const scenarios::Scenario& scenario, simulator::Bones bones,
                    const scenarios::Plan& plan);

}  // namespace hallux::ui

/// Where somebody stands and holds the saw when an operation begins. Inside this room only.
#pragma once

#include "ui/jobs/live_attempt.h"
#include "ui/render/scene/camera.h"

namespace hallux::ui {

/// Where the saw is held when an attempt begins: off the bone on the side of the approach. What the
/// plan asks beyond that is the trainee's to find.
RigidTransform start_pose(const PreparedCase& prepared_case);
/// The site as one stands before it.
Camera start_camera(const PreparedCase& prepared_case);

}  // namespace hallux::ui

/// Where somebody stands and holds the saw when an operation begins.
#pragma once

#include "ui/jobs/live_attempt.h"
#include "ui/render/scene/camera.h"

namespace hallux::ui {

/// Of a case that is prepared, as ui/sight says them.
RigidTransform start_pose(const PreparedCase& prepared_case);
Camera start_camera(const PreparedCase& prepared_case);

}  // namespace hallux::ui

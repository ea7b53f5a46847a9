/// The chevron of the scenario tests, on a coarse bone.
#pragma once

#include "ui/jobs/live_attempt.h"

namespace hallux::ui {

/// edge_mm  of the bone's triangles
PreparedCase chevron_case(double edge_mm = 1.0);

}  // namespace hallux::ui

/// What stands around the bone that is operated on, made before the operation: the bone beside it,
/// and the planned faces as far as they lie in the bone. For the picture alone.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "simulator/base/progress.h"
#include "ui/jobs/live_attempt.h"
#include "ui/screens/pictures/patient_view.h"
#include "ui/screens/pictures/planned_frame.h"

namespace hallux::ui {

/// The bone beside a scenario's, ready to be drawn; its look is kept like every bone's. Nothing
/// where it is operated on, too.
/// errors  Cancelled
/// thread  any but the window's; a second the first time
std::optional<BoneInView> neighbour_picture(const scenarios::Scenario& scenario,
                                            const std::filesystem::path& data_directory,
                                            const Progress& progress = {});

struct SitePicture {
  std::optional<BoneInView> neighbour;
  /// Over its solid; null where there is none.
  std::shared_ptr<const simulator::Bvh> neighbour_tree;
  /// By cut, in the order of the plan.
  std::vector<PlannedFace> faces;
};

}  // namespace hallux::ui

/// Landmarks by name, for what a scenario lays on one patient. Inside this corner only.
#pragma once

#include <string>

#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

/// Where the bone has this landmark [mm, bone frame]; `path` says who asks.
/// errors  ScenarioError with the names that the bone has
Vec3 landmark_of(const simulator::Bone& bone, const std::string& name, const std::string& path);

}  // namespace hallux::scenarios

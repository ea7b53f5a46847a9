#include "scenarios/landmark_of.h"

#include <optional>

#include "scenarios/scenario_error.h"

namespace hallux::scenarios {

Vec3 landmark_of(const simulator::Bone& bone, const std::string& name, const std::string& path) {
  if (const std::optional<Vec3> point = simulator::find_landmark(bone, name)) return *point;
  std::string known;
  for (const simulator::Landmark& landmark : bone.landmarks) {
    known += (known.empty() ? "" : ", ") + landmark.name;
  }
  throw ScenarioError(path + ": the bone \"" + bone.name + "\" has no landmark \"" + name +
                      "\"; use one of: " + known);
}

}  // namespace hallux::scenarios

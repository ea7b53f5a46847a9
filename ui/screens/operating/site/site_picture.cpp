#include "ui/screens/operating/site/site_picture.h"

#include "scenarios/neighbour.h"
#include "ui/screens/pictures/bone_viewport.h"
#include "ui/screens/pictures/cached_look.h"

namespace hallux::ui {

std::optional<BoneInView> neighbour_picture(const scenarios::Scenario& scenario,
                                            const std::filesystem::path& data_directory,
                                            const Progress& progress) {
  const std::optional<simulator::Bone> beside = scenarios::neighbour_of(scenario);
  report(progress, 0.0);
  if (!beside) return std::nullopt;
  const simulator::Bone& bone = *beside;
  BoneInView neighbour;
  neighbour.look = cached_look_of(data_directory, bone, progress);
  neighbour.mesh = mesh_of(picture_id("neighbour " + std::to_string(neighbour.look.id)),
                           simulator::uncut_solid(solid_of(bone)), neighbour.look);
  neighbour.world_from_bone = bone.world_from_bone;
  return neighbour;
}

}  // namespace hallux::ui

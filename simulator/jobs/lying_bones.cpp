#include "simulator/jobs/lying_bones.h"

#include <vector>

namespace hallux::simulator {

FragmentPoses poses_of(const Bones& bones) {
  std::vector<RigidTransform> world_from_bones;
  for (const Bone& bone : bones) world_from_bones.push_back(bone.world_from_bone);
  return FragmentPoses(world_from_bones);
}

}  // namespace hallux::simulator

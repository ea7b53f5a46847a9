#include "assessment/rebuild/bone_surfaces.h"

#include <utility>

namespace hallux::assessment {

BoneSurfaces::BoneSurfaces(const simulator::Bones& bones) {
  for (const simulator::Bone& bone : bones) {
    own_.push_back(std::make_unique<const simulator::Bvh>(bone.outer));
    of_each_.push_back(own_.back().get());
  }
  if (bones.size() > 1) together_ = std::make_unique<const simulator::Bvh>(outsides_of(bones));
}

BoneSurfaces::BoneSurfaces(const simulator::Bones& bones, std::vector<const simulator::Bvh*> known)
    : of_each_(std::move(known)) {
  if (bones.size() > 1) together_ = std::make_unique<const simulator::Bvh>(outsides_of(bones));
}

}  // namespace hallux::assessment

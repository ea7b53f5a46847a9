#include "assessment/process/standing_wound.h"

namespace hallux::assessment {

namespace {

/// A ball that every bone lies in.
constexpr double any_bone_mm = 1.0e6;

}  // namespace

BoneTissues::BoneTissues(const simulator::Bones& bones) {
  for (std::size_t bone = 0; bone < bones.size(); ++bone) {
    maps.emplace_back(bones[bone]);
    first_from_bones.push_back(first_from(bones, bone));
  }
}

simulator::Wound standing_wound(const BoneTissues& tissues, const simulator::KerfSet& kerfs) {
  const simulator::FragmentPoses& fragments = kerfs.fragments();
  if (fragments.count() == 1) return {tissues.maps.front(), kerfs, {}};
  simulator::Wound wound(kerfs);
  for (std::int32_t fragment = 0; fragment < fragments.count(); ++fragment) {
    const simulator::FragmentPose& pose = fragments[fragment];
    const auto bone = static_cast<std::size_t>(pose.bone);
    const RigidTransform wound_from_fragment =
        bone == 0 ? pose.bone_from_fragment
                  : tissues.first_from_bones[bone] * pose.bone_from_fragment;
    wound.put(fragment, {{tissues.maps[bone], {kerfs, fragment}, {}},
                         wound_from_fragment,
                         inverse(wound_from_fragment),
                         pose.is_moved || bone != 0,
                         Vec3{0.0, 0.0, 0.0},
                         any_bone_mm});
  }
  return wound;
}

}  // namespace hallux::assessment

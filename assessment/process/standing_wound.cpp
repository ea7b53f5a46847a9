#include "assessment/process/standing_wound.h"

namespace hallux::assessment {

namespace {

/// A ball that every bone lies in.
constexpr double any_bone_mm = 1.0e6;

}  // namespace

simulator::Wound standing_wound(const simulator::TissueMap& tissue,
                                const simulator::KerfSet& kerfs) {
  const simulator::FragmentPoses& fragments = kerfs.fragments();
  if (fragments.count() == 1) return {tissue, kerfs, {}};
  simulator::Wound wound(kerfs);
  for (std::int32_t fragment = 0; fragment < fragments.count(); ++fragment) {
    const simulator::FragmentPose& pose = fragments[fragment];
    wound.put(fragment, {{tissue, {kerfs, fragment}, {}},
                         pose.bone_from_fragment,
                         inverse(pose.bone_from_fragment),
                         pose.is_moved,
                         Vec3{0.0, 0.0, 0.0},
                         any_bone_mm});
  }
  return wound;
}

}  // namespace hallux::assessment

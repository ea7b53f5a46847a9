/// What is seen of a fragment at a moment of its history, measured: for tests.
#pragma once

#include <algorithm>

#include "simulator/history/bone_moment.h"

namespace hallux::simulator::testing {

inline double six_volumes(const Vec3& a, const Vec3& b, const Vec3& c) {
  return glm::dot(a, glm::cross(b, c));
}

/// Of the triangles that are not hidden, and the patch; 0 where the fragment is not there.
inline double shown_mm3(const FragmentMoment& fragment) {
  if (!fragment.is_there()) return 0.0;
  const IndexedMesh& mesh = fragment.solid().mesh;
  const SolidPatch none;
  const SolidPatch& patch = fragment.patch() == nullptr ? none : *fragment.patch();
  double sum = 0.0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (std::binary_search(patch.hidden.begin(), patch.hidden.end(), i)) continue;
    const auto corners = corners_of(mesh, i);
    sum += six_volumes(corners[0], corners[1], corners[2]);
  }
  const auto at = [&](std::uint32_t index) {
    return index < mesh.points_mm.size() ? mesh.points_mm[index]
                                         : patch.points_in_bone_mm[index - mesh.points_mm.size()];
  };
  for (const Triangle& t : patch.triangles) sum += six_volumes(at(t[0]), at(t[1]), at(t[2]));
  return sum / 6.0;
}

/// How many fragments are there.
inline std::int32_t standing_count(const BoneMoment& moment) {
  std::int32_t count = 0;
  for (std::int32_t number = 0; number < moment.fragment_count(); ++number)
    if (moment.fragment(number).is_there()) ++count;
  return count;
}

}  // namespace hallux::simulator::testing

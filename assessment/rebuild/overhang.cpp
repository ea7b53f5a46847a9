// The furthest point of a triangle between two planes is a corner, or lies where an edge crosses
// one of them.
#include "assessment/rebuild/overhang.h"

#include <array>

namespace hallux::assessment {

namespace {

/// Points between two planes square to `along`.
struct Between {
  Vec3 along{1.0, 0.0, 0.0};
  double low_mm = 0.0, high_mm = 0.0;

  double height_mm(const Vec3& point_mm) const { return glm::dot(along, point_mm); }
  bool holds(const Vec3& point_mm) const {
    const double at_mm = height_mm(point_mm);
    return at_mm >= low_mm && at_mm <= high_mm;
  }
};

Between between_ends_of(const scenarios::PlannedCut& cut) {
  const Vec3 way_mm = cut.exit_point_in_bone_mm - cut.depth_point_in_bone_mm;
  Between between{way_mm / length_of(way_mm), 0.0, 0.0};
  between.low_mm = between.height_mm(cut.depth_point_in_bone_mm);
  between.high_mm = between.height_mm(cut.exit_point_in_bone_mm);
  return between;
}

void raise(Overhang& most, const scenarios::ReferenceFace& face, const Vec3& point_mm) {
  const double over_mm = glm::dot(face.normal, point_mm) - face.offset_mm;
  if (over_mm > most.over_mm) most = {over_mm, point_mm};
}

void raise_by_edge(Overhang& most, const scenarios::ReferenceFace& face, const Between& between,
                   const Vec3& from_mm, const Vec3& to_mm) {
  if (between.holds(from_mm)) raise(most, face, from_mm);
  const double start_mm = between.height_mm(from_mm), end_mm = between.height_mm(to_mm);
  for (const double plane_mm : {between.low_mm, between.high_mm}) {
    if ((start_mm < plane_mm) == (end_mm < plane_mm)) continue;
    raise(most, face, from_mm + (plane_mm - start_mm) / (end_mm - start_mm) * (to_mm - from_mm));
  }
}

}  // namespace

Overhang measure_overhang(const RebuiltBone& rebuilt, const scenarios::PlannedCut& cut) {
  const Between between = between_ends_of(cut);
  Overhang most;
  for (std::size_t i = 0; i < rebuilt.fragments.size(); ++i) {
    const RebuiltFragment& fragment = rebuilt.fragments[i];
    const simulator::FragmentPose& placed =
        rebuilt.fields.fragments()[static_cast<std::int32_t>(i)];
    if (static_cast<std::size_t>(placed.bone) != cut.bone) continue;
    const RigidTransform& pose = placed.bone_from_fragment;
    const std::size_t end = fragment.first_piece + fragment.piece_count;
    for (std::size_t piece = fragment.first_piece; piece < end; ++piece) {
      if (rebuilt.is_piece_out[piece]) continue;
      const simulator::IndexedMesh& mesh = rebuilt.pieces[piece].mesh;
      for (const auto& triangle : mesh.triangles) {
        for (std::size_t corner = 0; corner < 3; ++corner)
          raise_by_edge(most, cut.face, between,
                        transform_point(pose, mesh.points_mm[triangle[corner]]),
                        transform_point(pose, mesh.points_mm[triangle[(corner + 1) % 3]]));
      }
    }
  }
  return most;
}

}  // namespace hallux::assessment

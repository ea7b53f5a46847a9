#include "ui/screens/pictures/planned_frame.h"

#include <limits>

#include "simulator/cutting/slice/section.h"

namespace hallux::ui {

namespace {

/// How far a shown face reaches beyond the bone.
constexpr double rim_mm = 3.0;
constexpr double section_thickness_mm = 0.2;

const simulator::SectionRegion* region_at(const simulator::Section& section, const Vec2& place_mm) {
  const simulator::SectionRegion* nearest = nullptr;
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (const simulator::SectionRegion& region : section.regions) {
    const double distance_mm =
        glm::distance(place_mm, glm::clamp(place_mm, region.min_mm, region.max_mm));
    if (distance_mm >= nearest_mm) continue;
    nearest_mm = distance_mm;
    nearest = &region;
  }
  return nearest;
}

}  // namespace

RigidTransform bone_from_planned(const scenarios::PlannedCut& cut) noexcept {
  constexpr double no_length_mm = 1.0e-6;
  const Vec3& normal = cut.face.normal;
  const Vec3 middle_mm = 0.5 * (cut.entry_point_in_bone_mm + cut.exit_point_in_bone_mm);
  Vec3 along = cut.exit_point_in_bone_mm - cut.entry_point_in_bone_mm;
  along -= glm::dot(along, normal) * normal;
  if (glm::length(along) < no_length_mm) along = cut.axis;
  along = glm::normalize(along);
  const double off_mm = cut.face.offset_mm - glm::dot(normal, middle_mm);
  return {rotation_from_axes(along, glm::cross(normal, along)), middle_mm + off_mm * normal};
}

PlannedFace planned_face(const simulator::CutSolid& solid, const simulator::Bvh& tree,
                         const RigidTransform& bone_from_plane, const Vec3& place_in_bone_mm) {
  const simulator::Section section =
      slice_section(solid, tree, simulator::KerfPlane{bone_from_plane, section_thickness_mm});
  const Vec3 place_mm = transform_point(inverse(bone_from_plane), place_in_bone_mm);
  PlannedFace face;
  Vec2 middle_mm(place_mm.x, place_mm.y);
  if (const simulator::SectionRegion* region = region_at(section, middle_mm)) {
    middle_mm = 0.5 * (region->min_mm + region->max_mm);
    face.entry_x_mm = region->min_mm.x - middle_mm.x;
    face.half_mm = 0.5 * (region->max_mm - region->min_mm) + Vec2(rim_mm);
  }
  face.bone_from_face = bone_from_plane * RigidTransform{Quat(1.0, 0.0, 0.0, 0.0),
                                                         Vec3(middle_mm.x, middle_mm.y, 0.0)};
  return face;
}

std::vector<PlannedFace> planned_faces(std::span<const simulator::SolidWithTree> wholes,
                                       const scenarios::Plan& plan, const simulator::Bones& bones) {
  std::vector<PlannedFace> faces;
  for (const scenarios::PlannedCut& cut : plan.cuts) {
    const simulator::SolidWithTree& whole = wholes[cut.bone];
    PlannedFace& face = faces.emplace_back(
        planned_face(whole.solid, whole.bvh, bone_from_planned(cut), cut.depth_point_in_bone_mm));
    if (cut.bone != 0) face.bone_from_face = first_from(bones, cut.bone) * face.bone_from_face;
  }
  return faces;
}

}  // namespace hallux::ui

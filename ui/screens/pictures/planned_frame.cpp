#include "ui/screens/pictures/planned_frame.h"

namespace hallux::ui {

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

}  // namespace hallux::ui

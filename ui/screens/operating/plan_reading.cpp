#include "ui/screens/operating/plan_reading.h"

#include "simulator/base/elementary.h"

namespace hallux::ui {

PlanReading read_against(const scenarios::PlannedCut& cut, const simulator::Blade& blade,
                         const RigidTransform& bone_from_tool) noexcept {
  const auto in_bone = [&](const Vec3& axis) { return transform_direction(bone_from_tool, axis); };
  const Vec3& waste = cut.face.normal;
  // The blade has two faces; the one that looks to the waste is compared.
  const Vec3 normal = in_bone(Vec3(0.0, 0.0, 1.0));
  const double side = glm::dot(normal, waste) < 0.0 ? -1.0 : 1.0;
  PlanReading reading;
  reading.pitch_rad = elementary::asin(glm::dot(waste, in_bone(Vec3(1.0, 0.0, 0.0))));
  reading.roll_rad = elementary::asin(side * glm::dot(waste, in_bone(Vec3(0.0, 1.0, 0.0))));
  reading.distance_mm =
      glm::dot(waste, bone_from_tool.translation_mm) - cut.face.offset_mm - 0.5 * blade.kerf_mm;
  return reading;
}

RigidTransform bone_from_face(const scenarios::PlannedCut& cut) noexcept {
  const Vec3& normal = cut.face.normal;
  const Vec3 middle_mm = 0.5 * (cut.entry_point_in_bone_mm + cut.exit_point_in_bone_mm);
  const double off_mm = cut.face.offset_mm - glm::dot(normal, middle_mm);
  const Vec3 axis = cut.axis - glm::dot(cut.axis, normal) * normal;
  return {rotation_from_axes(axis, glm::cross(normal, axis)), middle_mm + off_mm * normal};
}

}  // namespace hallux::ui

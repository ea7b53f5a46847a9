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

}  // namespace hallux::ui

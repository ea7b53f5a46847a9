#include "ui/screens/operating/hud/plan_reading.h"

#include <algorithm>
#include <cmath>

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
  reading.angle_rad =
      elementary::atan2(length_of(glm::cross(normal, waste)), std::abs(glm::dot(normal, waste)));
  reading.distance_mm =
      glm::dot(waste, bone_from_tool.translation_mm) - cut.face.offset_mm - 0.5 * blade.kerf_mm;
  return reading;
}

double distance_ahead_mm(const PlanReading& reading, double way_mm) noexcept {
  return reading.distance_mm + way_mm * elementary::sin(reading.pitch_rad);
}

PassReading read_passes(const scenarios::PlannedCut& cut, const scenarios::PlannedPasses& passes,
                        const RigidTransform& bone_from_tool) noexcept {
  const Vec3 from_entry_mm = bone_from_tool.translation_mm - cut.entry_point_in_bone_mm;
  const double along_mm = glm::dot(passes.along_in_bone, from_entry_mm);
  const auto nearest = std::min_element(
      passes.middles_mm.begin(), passes.middles_mm.end(),
      [&](double a, double b) { return std::abs(a - along_mm) < std::abs(b - along_mm); });
  return {static_cast<std::size_t>(nearest - passes.middles_mm.begin()), passes.middles_mm.size(),
          along_mm - *nearest, glm::dot(passes.feed_in_bone, from_entry_mm)};
}

}  // namespace hallux::ui

#include "ui/screens/pictures/fixation_reading.h"

#include "simulator/base/elementary.h"
#include "ui/screens/pictures/rotation_vector.h"

namespace hallux::ui {

namespace {

/// An axis that lies flatter against the planned entry's plane meets it nowhere near.
constexpr double least_cosine = 0.2;

}  // namespace

ImplantReading read_implant(const scenarios::PlannedImplant& planned,
                            const RigidTransform& bone_from_tool) noexcept {
  const Vec3& along = planned.direction_in_bone;
  const Vec3 axis = axis_x(bone_from_tool);
  const Vec3 from_entry_mm = bone_from_tool.translation_mm - planned.entry_in_bone_mm;
  const double cosine = glm::dot(axis, along);
  ImplantReading reading;
  reading.depth_mm = glm::dot(from_entry_mm, along);
  const Vec3 at_entry_mm =
      cosine < least_cosine ? from_entry_mm : from_entry_mm - reading.depth_mm / cosine * axis;
  reading.off_in_bone_mm = at_entry_mm - glm::dot(at_entry_mm, along) * along;
  reading.entry_mm = length_of(reading.off_in_bone_mm);
  reading.direction_rad = elementary::atan2(length_of(glm::cross(axis, along)), cosine);
  return reading;
}

ShiftReading read_shift(const scenarios::Plan& plan, std::size_t shift,
                        const RigidTransform& bone_from_fragment) noexcept {
  const scenarios::PlannedShift& planned = plan.fixation.shifts[shift];
  const scenarios::PlannedFragment& fragment = *find_fragment(plan.fixation, planned.fragment);
  const RigidTransform target = planned.bone_from_cut();
  const Vec3 now_mm = transform_point(bone_from_fragment, fragment.holds_in_bone_mm);
  ShiftReading reading;
  reading.off_in_bone_mm = transform_point(target, fragment.holds_in_bone_mm) - now_mm;
  reading.off_mm = length_of(reading.off_in_bone_mm);
  reading.moved_mm = length_of(now_mm - fragment.holds_in_bone_mm);
  reading.turn_left_in_bone_rad =
      rotation_vector(target.rotation * glm::conjugate(bone_from_fragment.rotation));
  reading.turned_rad = length_of(reading.turn_left_in_bone_rad);
  return reading;
}

}  // namespace hallux::ui

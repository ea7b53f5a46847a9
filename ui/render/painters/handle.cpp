#include "ui/render/painters/handle.h"

#include <algorithm>
#include <variant>

#include "ui/render/scene/driver_model.h"
#include "ui/render/scene/forceps_model.h"
#include "ui/render/scene/tool_model.h"

namespace hallux::ui {

namespace {

constexpr double saw_half_mm = 9.0;
/// Of a wire or a bit, and of the shaft behind a screw.
constexpr double bit_kept_mm = 16.0, shaft_kept_mm = 3.0;

}  // namespace

Handle handle_of(const SawInScene& saw) noexcept {
  const double pivot_mm = pivot_x_mm(saw.blade);
  return {.world_from_tool = saw.world_from_tool,
          .front_x_mm = pivot_mm,
          .back_x_mm = pivot_mm - cable_end_mm,
          .half_mm = Vec2(saw_half_mm),
          .presence = saw.handpiece_presence};
}

Handle handle_of(const DriverInScene& driver) noexcept {
  const double front_mm = chuck_x_mm(driver.tool);
  return {.world_from_tool = driver.world_from_tool,
          .front_x_mm = front_mm,
          .back_x_mm = front_mm - driver_length_mm,
          .half_mm = Vec2(driver_half_y_mm, driver_half_z_mm),
          .presence = driver.handpiece_presence};
}

Handle held_of(const DriverInScene& driver) noexcept {
  const double radius_mm = held_radius_mm(driver.tool);
  const auto* screwdriver = std::get_if<simulator::Screwdriver>(&driver.tool);
  const double keeps_mm =
      screwdriver == nullptr
          ? bit_kept_mm
          : screwdriver->screw.length_mm + screwdriver->screw.head_height_mm + shaft_kept_mm;
  return {.world_from_tool = driver.world_from_tool,
          .front_x_mm = -keeps_mm,
          .back_x_mm = chuck_x_mm(driver.tool) - held_in_chuck_mm,
          .half_mm = Vec2(radius_mm),
          .keeps_mm = keeps_mm};
}

Handle handle_of(const ForcepsInScene& forceps) noexcept {
  const RigidTransform tool_from_arm = ui::tool_from_arm(forceps.opening_mm);
  Box box;
  for (const double x_mm : {0.0, -forceps_handle_mm}) {
    for (const double y_mm : {0.0, -forceps_arm_half_mm})
      box.add(transform_point(tool_from_arm, Vec3(x_mm, y_mm, 0.0)));
  }
  const double joint_mm = tool_from_arm.translation_mm.x;
  return {.world_from_tool = forceps.world_from_tool,
          .front_x_mm = joint_mm,
          .back_x_mm = box.low_mm.x,
          .half_mm = Vec2(std::max(-box.low_mm.y, box.high_mm.y), forceps_half_thickness_mm),
          .presence = forceps.handle_presence};
}

Box before_the_tip(const Handle& handle, const Vec3& eye_mm) noexcept {
  const Vec3 tip_mm = handle.world_from_tool.translation_mm;
  const Vec3 to_tip = glm::normalize(tip_mm - eye_mm);
  constexpr double step_mm = 4.0;
  const double reach_mm = std::max(handle.half_mm.x, handle.half_mm.y) + step_mm;
  Box box;
  for (double along_mm = handle.front_x_mm; along_mm > handle.back_x_mm; along_mm -= step_mm) {
    const Vec3 from_tip = transform_direction(handle.world_from_tool, Vec3(along_mm, 0.0, 0.0));
    const bool is_nearer = glm::dot(from_tip, to_tip) < reach_mm;
    const double beside_mm = glm::length(glm::cross(from_tip, to_tip));
    if (!is_nearer || beside_mm > whole_beyond_mm + reach_mm) continue;
    box.add(Vec3(along_mm - reach_mm, -reach_mm, -reach_mm));
    box.add(Vec3(along_mm + reach_mm, reach_mm, reach_mm));
  }
  return box;
}

Box seen_through_part(const Handle& handle, const EyeView& view) noexcept {
  if (handle.presence >= 1.0) return before_the_tip(handle, view.eye_in_world_mm);
  const Vec2 side_mm = handle.half_mm + Vec2(1.0);
  Box box;
  box.add(Vec3(handle.back_x_mm - 1.0, -side_mm.x, -side_mm.y));
  box.add(Vec3(handle.front_x_mm + side_mm.x, side_mm.x, side_mm.y));
  return box;
}

}  // namespace hallux::ui

#include "simulator/contact/bore/bore_motion.h"

#include <cmath>

#include "simulator/contact/bore/bore_inside.h"
#include "simulator/contact/bore/bore_outside.h"
#include "simulator/contact/contact_walk.h"
#include "simulator/contact/coupling.h"

namespace hallux::simulator {

namespace {

/// Between points of a shaft that are asked whether they lie in bone.
constexpr double shaft_step_mm = 2.0;

/// How far the tool may go; it learns where the hand is.
double travel_of(BoreToolState& tool, const BoreInput& input,
                 const ContactSettings& settings) noexcept {
  const ProxyMotion hand = motion_between(tool.wound_from_handle, input.wound_from_handle);
  const bool is_free = tool.stage == BoreStage::Free && !tool.is_held;
  const bool is_gentle = tool.knows_handle && !is_free;
  tool.wound_from_handle = input.wound_from_handle;
  tool.knows_handle = true;
  return travel_limit_mm(reach_of(hand, shaft_reach_mm(input.tool)), input.duration_s, is_gentle,
                         settings);
}

/// What the stretched coupling does to the hand. In a bore the tool spins freely about its axis.
void pull_hand(const BoreToolState& tool, const BoreInput& input, const ContactSettings& settings,
               BoreOutcome& outcome) noexcept {
  ProxyMotion stretch = motion_between(input.wound_from_handle, tool.wound_from_tool);
  if (tool.stage == BoreStage::InBore) {
    const Vec3 axis = axis_x(tool.wound_from_tool);
    stretch.rotation_rad -= glm::dot(stretch.rotation_rad, axis) * axis;
  }
  const CouplingPull pull = coupling_pull(stretch, settings);
  outcome.force_in_wound_newton = pull.force_newton;
  outcome.torque_in_wound_newton_mm = pull.torque_newton_mm;
  outcome.is_force_limited = pull.is_force_limited;
}

/// A point on bone, or in a hole's mouth, that lies along an open bore's axis finds it again.
void join_bore(BoreToolState& tool, const BoreInput& input, const DrilledWound& bone,
               BoreOutcome& outcome) noexcept {
  const bool is_in_mouth = bone.is_in_hole(tool.wound_from_tool.translation_mm);
  if (tool.stage == BoreStage::Free && !is_in_mouth) return;
  const std::int32_t bore = find_bore_to_join(tool.wound_from_tool, input.bores);
  if (bore < 0) return;
  // In the air before the skin nothing is found yet.
  const Bore& found = input.bores[static_cast<std::size_t>(bore)];
  const double way_mm = way_along(found, tool.wound_from_tool.translation_mm);
  if (tool.stage == BoreStage::Free && way_mm < 0.0) return;
  outcome.found_bore = bore;
  outcome.wants_bore = false;
  if (found.radius_mm >= input.tool.radius_mm) enter_bore(tool, bore);
}

}  // namespace

BoreOutcome move_bore(BoreToolState& tool, const BoreInput& input, const Wound& wound,
                      const ContactSettings& settings) noexcept {
  BoreOutcome outcome;
  const DrilledWound bone{wound, input.holes};
  const double limit_mm = travel_of(tool, input, settings);
  if (tool.stage == BoreStage::InBore) {
    move_in_bore(tool, input, bone, settings, limit_mm, outcome);
  } else {
    move_outside_bore(tool, input, bone, settings, limit_mm, outcome);
    join_bore(tool, input, bone, outcome);
  }
  if (tool.stage != BoreStage::Free || tool.is_held) pull_hand(tool, input, settings, outcome);
  return outcome;
}

std::int32_t find_bore_to_join(const RigidTransform& wound_from_tool, std::span<const Bore> bores,
                               double beyond_mm) noexcept {
  std::int32_t nearest = -1;
  double least_mm = bore_rejoin_offset_mm;
  for (std::size_t i = 0; i < bores.size(); ++i) {
    const Vec3 axis = axis_x(bores[i].body_from_bore), ahead = axis_x(wound_from_tool);
    const double sine = length_of(glm::cross(axis, ahead));
    if (glm::dot(axis, ahead) <= 0.0 || sine > bore_rejoin_angle_rad) continue;
    const double way_mm = way_along(bores[i], wound_from_tool.translation_mm);
    if (way_mm < -bore_rejoin_reach_mm || way_mm > bores[i].depth_mm + beyond_mm) continue;
    const Vec3 arm_mm =
        wound_from_tool.translation_mm - bores[i].body_from_bore.translation_mm - way_mm * axis;
    if (length_of(arm_mm) > least_mm) continue;
    least_mm = length_of(arm_mm);
    nearest = static_cast<std::int32_t>(i);
  }
  return nearest;
}

bool shaft_is_in_bone(const RigidTransform& wound_from_tool, const BoreTool& tool,
                      const Wound& wound) noexcept {
  const Vec3 ahead = axis_x(wound_from_tool);
  for (double back_mm = 0.0; back_mm <= shaft_reach_mm(tool); back_mm += shaft_step_mm) {
    if (wound.clearance_mm(wound_from_tool.translation_mm - back_mm * ahead) < 0.0) return true;
  }
  return false;
}

void enter_bore(BoreToolState& tool, std::int32_t bore) noexcept {
  tool.stage = BoreStage::InBore;
  tool.bore = bore;
  tool.may_break_through = tool.is_threaded = false;
  tool.drawn_back_mm = 0.0;
}

}  // namespace hallux::simulator

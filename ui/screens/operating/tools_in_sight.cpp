#include "ui/screens/operating/tools_in_sight.h"

#include <algorithm>
#include <cmath>

#include "ui/screens/operating/hud/fixation_reading.h"

namespace hallux::ui {

namespace {

using simulator::ToolStatus;

/// A tip is told by a ring that is seen; what lies further back is like a handpiece.
constexpr double least_outline_mm = 3.0, working_end_mm = 25.0;
/// Of forceps around a piece.
constexpr double closed_mm = 6.0;
/// So far out of the piece their points stand.
constexpr double outside_mm = 1.0;

const simulator::Tool* tool_of(const OperationInSight& shown) noexcept {
  const scenarios::LaidOutTool* const tool = shown.tools == nullptr ? nullptr : shown.tools->tool();
  return tool == nullptr ? nullptr : &tool->tool;
}

bool has_status(const OperationInSight& shown, ToolStatus status) noexcept {
  return shown.loop != nullptr && !shown.is_paused && has(shown.loop->sample.status, status);
}

/// Any direction square to this one, as near to a wish as may be.
Vec3 square_to(const Vec3& direction, const Vec3& wish) {
  const Vec3 across = wish - glm::dot(wish, direction) * direction;
  if (length_of(across) > 0.1) return unit(across);
  return unit(glm::cross(direction,
                         std::abs(direction.x) < 0.9 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0)));
}

/// From the hand to the place of the piece that is nearest to it.
std::optional<ForcepsInScene> forceps_of(const OperationInSight& shown) {
  if (shown.tools == nullptr || shown.tools->forceps() != Forceps::Holding || shown.bone == nullptr)
    return std::nullopt;
  const std::optional<FragmentSurface> held = shown.bone->fragment(shown.tools->gripped());
  if (!held) return std::nullopt;
  const Vec3 hand_mm = shown.world_from_target.translation_mm;
  const Vec3 hand_in_piece_mm = transform_point(inverse(held->world_from_fragment), hand_mm);
  const auto near = held->tree->nearest(hand_in_piece_mm);
  if (!near) return std::nullopt;
  const Vec3 place_mm = transform_point(held->world_from_fragment, near->point_mm);
  const Vec3 away_mm = place_mm - hand_mm;
  const Vec3 along =
      length_of(away_mm) > outside_mm ? unit(away_mm) : axis_x(shown.world_from_target);
  const Vec3 across = square_to(along, axis_y(shown.world_from_target));
  return ForcepsInScene{{rotation_from_axes(along, across), place_mm - outside_mm * along},
                        closed_mm};
}

DriverInScene driver_of(const OperationInSight& shown, const simulator::Tool& tool,
                        const SawInScene& outline, double swings) {
  DriverInScene driver;
  driver.world_from_tool = outline.world_from_tool;
  driver.tool = tool;
  driver.is_running = has_status(shown, ToolStatus::DriveOn);
  driver.turned_rad = driver.is_running ? swings : 0.0;
  driver.handpiece_presence = outline.handpiece_presence;
  return driver;
}

/// Its diameter and length as planned.
simulator::Tool planned_tool(const scenarios::PlannedImplant& planned) {
  if (planned.kind == scenarios::ImplantKind::Wire) {
    simulator::WireDriver driver;
    driver.wire.diameter_mm = planned.diameter_mm;
    driver.wire.length_mm = planned.length_mm;
    return driver;
  }
  simulator::Screwdriver driver;
  driver.screw.thread_diameter_mm = planned.diameter_mm;
  driver.screw.length_mm = planned.length_mm;
  return driver;
}

}  // namespace

simulator::Blade outline_blade(const simulator::Tool& tool) noexcept {
  if (const auto* saw = std::get_if<simulator::Saw>(&tool)) return saw->blade;
  simulator::Blade blade;
  blade.width_mm = std::max(least_outline_mm, 2.0 * bored_radius_mm(tool));
  blade.depth_mm = working_end_mm;
  return blade;
}

SawInScene saw_in_sight(const OperationInSight& shown) {
  const bool is_gripping = shown.tools != nullptr && shown.tools->forceps() == Forceps::Holding;
  SawInScene saw;
  saw.world_from_tool = shown.loop == nullptr || is_gripping
                            ? shown.world_from_target
                            : transform_from(shown.loop->sample.world_from_tool);
  const simulator::Tool* const tool = tool_of(shown);
  saw.blade = tool == nullptr ? shown.prepared_case.scenario.saw.blade : outline_blade(*tool);
  saw.is_running = has_status(shown, ToolStatus::SawOn);
  return saw;
}

void add_tool(Scene& scene, const OperationInSight& shown, const SawInScene& saw, double swings) {
  scene.forceps = forceps_of(shown);
  if (scene.forceps) return;
  const simulator::Tool* const tool = tool_of(shown);
  if (tool == nullptr || std::holds_alternative<simulator::Saw>(*tool)) {
    scene.saw = saw;
  } else {
    scene.driver = driver_of(shown, *tool, saw, swings);
  }
}

void add_planned_fixation(Scene& scene, const OperationInSight& shown) {
  const RigidTransform& world_from_bone = shown.prepared_case.bone.world_from_bone;
  if (shown.implant != nullptr) {
    const scenarios::PlannedImplant& planned = *shown.implant;
    const Vec3 across = square_to(planned.direction_in_bone, Vec3(0.0, 1.0, 0.0));
    scene.implants.push_back(
        {world_from_bone * RigidTransform{rotation_from_axes(planned.direction_in_bone, across),
                                          planned.tip_in_bone_mm},
         planned_tool(planned), true});
  }
  if (!shown.shift || shown.tools == nullptr || shown.bone == nullptr) return;
  const std::optional<FragmentSurface> held = shown.bone->fragment(shown.tools->gripped());
  if (!held) return;
  const RigidTransform target = bone_from_shifted(shown.prepared_case.plan, *shown.shift);
  scene.free_pieces.push_back({held->mesh, world_from_bone * target});
}

}  // namespace hallux::ui

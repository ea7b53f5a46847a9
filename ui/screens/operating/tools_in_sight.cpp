#include "ui/screens/operating/tools_in_sight.h"

#include <algorithm>

#include "ui/screens/pictures/fixation_reading.h"
#include "ui/screens/pictures/tool_poses.h"

namespace hallux::ui {

namespace {

using simulator::ToolStatus;

/// A tip is told by a ring that is seen; what lies further back is like a handpiece.
constexpr double least_outline_mm = 3.0, working_end_mm = 25.0;

const simulator::Tool* tool_of(const OperationInSight& shown) noexcept {
  const scenarios::LaidOutTool* const tool = shown.tools == nullptr ? nullptr : shown.tools->tool();
  return tool == nullptr ? nullptr : &tool->tool;
}

bool has_status(const OperationInSight& shown, ToolStatus status) noexcept {
  return shown.loop != nullptr && !shown.is_paused && has(shown.loop->sample.status, status);
}

/// From the hand to the place of the piece that is nearest to it.
std::optional<ForcepsInScene> forceps_of(const OperationInSight& shown) {
  if (shown.tools == nullptr || shown.tools->forceps() != Forceps::Holding || shown.bone == nullptr)
    return std::nullopt;
  const std::optional<FragmentSurface> held = shown.bone->fragment(shown.tools->gripped());
  if (!held) return std::nullopt;
  const std::optional<RigidTransform> piece_from_jaws =
      jaws_around(*held->tree, inverse(held->world_from_fragment) * shown.world_from_target);
  if (!piece_from_jaws) return std::nullopt;
  return ForcepsInScene{held->world_from_fragment * *piece_from_jaws, jaws_opening_mm};
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
  const RigidTransform& world_from_bone = shown.prepared_case.bone().world_from_bone;
  if (shown.implant != nullptr) {
    const scenarios::PlannedImplant& planned = *shown.implant;
    const RigidTransform bone_from_tool =
        pose_along(planned.direction_in_bone, Vec3(0.0, 1.0, 0.0), planned.tip_in_bone_mm);
    scene.implants.push_back({world_from_bone * bone_from_tool, planned_tool(planned), true});
  }
  if (!shown.shift || shown.tools == nullptr || shown.bone == nullptr) return;
  const std::optional<FragmentSurface> held = shown.bone->fragment(shown.tools->gripped());
  if (!held) return;
  const scenarios::PlannedShift& shift =
      shown.prepared_case.plan_in_first.fixation.shifts[*shown.shift];
  const RigidTransform first_from_target =
      shift.bone_from_cut() * first_from(shown.prepared_case.bones, shift.bone);
  scene.free_pieces.push_back({held->mesh, world_from_bone * first_from_target});
}

}  // namespace hallux::ui

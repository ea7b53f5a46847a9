/// Each implant and each shift draws from a stream of its own, named by it, so that another one in
/// the scenario changes none of the others.
#include "scenarios/hands/hand_reach.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "scenarios/tray/fitting_tools.h"
#include "simulator/base/random.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {

namespace {

/// A wire that is to hold in one cortex alone goes so far of its way.
constexpr double unicortical_share = 0.6;

Vec3 turned(const Vec3& direction, const Vec3& about, double angle_rad) {
  return transform_direction({rotation_about(about, angle_rad), {}}, direction);
}

/// Square to a direction.
Vec3 any_across(const Vec3& direction) {
  const Vec3 hint = std::abs(direction.x) < 0.9 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  return unit(glm::cross(direction, hint));
}

}  // namespace

AimedImplant aim_implant(const Scenario& scenario, const Plan& plan, std::size_t implant,
                         const HandSkill& skill, std::uint64_t seed) {
  const PlannedImplant& planned = plan.fixation.implants[implant];
  const auto size_of = [&](FaultKind kind) { return fault_size(skill.faults, kind, planned.name); };
  Random random(seed, "hand.implant." + planned.name);
  const double off_mm =
      random.truncated_normal(skill.location_mean_mm, skill.location_deviation_mm, 2.0);
  const double off_rad = radian_from_degree(
      random.truncated_normal(skill.angle_mean_deg, skill.angle_deviation_deg, 2.0));
  const double entry_turn_rad = random.uniform(0.0, 2.0 * pi);
  const double axis_turn_rad = random.uniform(0.0, 2.0 * pi);
  const Vec3& direction = planned.direction_in_bone;
  const Vec3 across = any_across(direction);
  const Vec3 entry_mm = planned.entry_in_bone_mm +
                        std::max(0.0, off_mm) * turned(across, direction, entry_turn_rad) +
                        size_of(FaultKind::Entry) * across;
  const Vec3 leaned =
      turned(turned(direction, turned(across, direction, axis_turn_rad), std::max(0.0, off_rad)),
             across, radian_from_degree(size_of(FaultKind::Direction)));
  const std::vector<LaidOutTool> tools = laid_out_tools(scenario);
  const double longer_mm = size_of(FaultKind::Length);
  AimedImplant aimed;
  aimed.bone_from_axis = {rotation_from_axes(leaned, any_across(leaned)), entry_mm};
  const std::optional<std::int32_t> tool = fitting_tool(tools, planned, longer_mm);
  if (!tool) throw ScenarioError("implant \"" + planned.name + "\": nothing on the tray sets it");
  aimed.tool = *tool;
  aimed.drill = pilot_drill(tools, aimed.tool);
  aimed.depth_mm = planned.length_mm + longer_mm;
  if (is_faulty(skill.faults, FaultKind::Unicortical, planned.name))
    aimed.depth_mm *= unicortical_share;
  return aimed;
}

RigidTransform aim_shift(const Plan& plan, std::size_t shift, const HandSkill& skill,
                         std::uint64_t seed) {
  const PlannedShift& planned = plan.fixation.shifts[shift];
  const PlannedFragment& fragment = *find_fragment(plan.fixation, planned.fragment);
  Random random(seed, "hand.shift." + planned.name);
  const double off_mm = random.truncated_normal(0.0, skill.shift_deviation_mm, 2.0);
  const double turn_deg = random.truncated_normal(0.0, skill.shift_turn_deviation_deg, 2.0);
  const Vec3 place_mm = transform_point(planned.before_from_cut, fragment.holds_in_bone_mm);
  const Vec3 way_mm = transform_point(planned.bone_from_before, place_mm) - place_mm;
  const double length_mm = length_of(way_mm);
  const Vec3 along = length_mm > 0.0 ? way_mm / length_mm : Vec3{0.0, 0.0, 0.0};
  RigidTransform led = planned.bone_from_before;
  if (is_faulty(skill.faults, FaultKind::WrongWay, fragment.name)) led = inverse(led);
  led.translation_mm +=
      (off_mm + fault_size(skill.faults, FaultKind::ShiftBy, fragment.name)) * along;
  const double turned_rad =
      radian_from_degree(turn_deg + fault_size(skill.faults, FaultKind::TurnBy, fragment.name));
  return turn_about(transform_point(led, place_mm), fragment.foot_dorsal_in_bone, turned_rad) * led;
}

}  // namespace hallux::scenarios

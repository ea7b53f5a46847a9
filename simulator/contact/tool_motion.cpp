#include "simulator/contact/tool_motion.h"

#include <algorithm>
#include <cmath>

#include "simulator/contact/blade_probe.h"

namespace hallux::simulator {

namespace {

/// How far in front of the teeth bone is asked for: they stand on bone, not in it.
constexpr double probe_ahead_mm = 0.02;
/// Free motion is walked in steps of this, at most `walk_steps` a tick: the tool of a hand above 1 m/s comes after it.
constexpr double walk_step_mm = 0.1;
constexpr int walk_steps = 10;
/// A turn in the kerf's plane below this is not worth asking the bone about.
constexpr double turn_worth_asking = 0.0005;
/// A shift aside below the record's quantum likewise [mm].
constexpr double shift_worth_asking_mm = 0.001;
/// Backing out further than this ends a touch.
constexpr double leave_depth_mm = -0.1;

Vec3 axis_x(const RigidTransform& to_from_tool) noexcept {
  return transform_direction(to_from_tool, Vec3{1.0, 0.0, 0.0});
}

Vec3 axis_z(const RigidTransform& to_from_tool) noexcept {
  return transform_direction(to_from_tool, Vec3{0.0, 0.0, 1.0});
}

RigidTransform moved(const RigidTransform& pose, const Vec3& by_mm) noexcept {
  return {pose.rotation, pose.translation_mm + by_mm};
}

/// What is left of a deviation: all of it within the play, beyond it only the share that gives way.
double comply(double deviation, double play, double share) noexcept {
  const double beyond = std::abs(deviation) - play;
  if (beyond <= 0.0) return deviation;
  return (deviation < 0.0 ? -1.0 : 1.0) * (play + share * beyond);
}

/// Advances along the tool's x towards `wanted_mm`: freely until the teeth stand on bone, then by the feed law.
double feed(RigidTransform& bone_from_tool, double wanted_mm, const ToolInput& input,
            const StandingBone& bone, const ContactSettings& settings, TeethMemory& teeth,
            ToolOutcome& outcome) noexcept {
  const Vec3 ahead = axis_x(bone_from_tool);
  double done_mm = 0.0;
  for (int i = 0; i < walk_steps && done_mm < wanted_mm; ++i) {
    outcome.engaged = engagement(bone_from_tool, bone, probe_ahead_mm, teeth);
    const bool is_engaged = outcome.engaged.width_mm() > 0.0;
    double step_mm = std::min(walk_step_mm, wanted_mm - done_mm);
    if (is_engaged) {
      const double force_newton = std::min(settings.force_limit_newton,
                                           settings.coupling_newton_per_mm * (wanted_mm - done_mm));
      const double rate_mm_s =
          input.saw_runs ? feed_rate_mm_s(outcome.engaged, force_newton, settings.cycles_per_minute)
                         : 0.0;
      step_mm = std::min(wanted_mm - done_mm, rate_mm_s * input.duration_s);
      outcome.advance_mm = step_mm;
    }
    bone_from_tool = moved(bone_from_tool, step_mm * ahead);
    done_mm += step_mm;
    if (is_engaged) break;
  }
  return done_mm;
}

void move_free(ToolState& tool, const ToolInput& input, const StandingBone& bone,
               ToolOutcome& outcome) noexcept {
  const RigidTransform from = tool.bone_from_tool;
  const Vec3 way = input.bone_from_handle.translation_mm - from.translation_mm;
  const double way_mm = std::sqrt(glm::dot(way, way));
  constexpr double walk_mm = walk_step_mm * walk_steps;
  const RigidTransform to = way_mm > walk_mm
                                ? interpolate(from, input.bone_from_handle, walk_mm / way_mm)
                                : input.bone_from_handle;
  const int steps =
      std::clamp(static_cast<int>(std::min(way_mm, walk_mm) / walk_step_mm) + 1, 1, walk_steps);
  tool.bone_from_tool = to;
  for (int i = 1; i <= steps; ++i) {
    const RigidTransform pose = interpolate(from, to, static_cast<double>(i) / steps);
    if (!(engagement(pose, bone, 0.0, tool.teeth).width_mm() > 0.0)) continue;
    tool.bone_from_tool = pose;
    tool.stage = ToolStage::Touching;
    tool.touch_depth_mm = tool.scratch_mm = 0.0;
    tool.is_refused = false;
    outcome.began_contact = true;
    return;
  }
}

void move_touching(ToolState& tool, const ToolInput& input, const StandingBone& bone,
                   const ContactSettings& settings, ToolOutcome& outcome) noexcept {
  const double engaged_mm =
      engagement(tool.bone_from_tool, bone, probe_ahead_mm, tool.teeth).width_mm();
  const auto is_allowed = [&](const RigidTransform& pose) {
    return engagement(pose, bone, probe_ahead_mm, tool.teeth).width_mm() <= engaged_mm;
  };
  RigidTransform pose = tool.bone_from_tool;
  const RigidTransform turned{input.bone_from_handle.rotation, pose.translation_mm};
  if (is_allowed(turned)) pose = turned;
  const Vec3 ahead = axis_x(pose);
  const Vec3 way = input.bone_from_handle.translation_mm - pose.translation_mm;
  const double forward_mm = glm::dot(way, ahead);
  const RigidTransform aside = moved(pose, way - forward_mm * ahead);
  if (is_allowed(aside)) pose = aside;
  const bool retreats = forward_mm < 0.0;
  if (retreats) pose = moved(pose, forward_mm * ahead);
  double fed_mm = retreats ? forward_mm : 0.0;
  if (!retreats && !tool.is_refused) {
    fed_mm = feed(pose, forward_mm, input, bone, settings, tool.teeth, outcome);
  }
  tool.bone_from_tool = pose;
  tool.touch_depth_mm += fed_mm;
  tool.scratch_mm = std::max(tool.scratch_mm, tool.touch_depth_mm);
  outcome.wants_freeze = !tool.is_refused && tool.touch_depth_mm >= settings.freeze_depth_mm;
  const bool is_clear = !(engagement(pose, bone, probe_ahead_mm, tool.teeth).width_mm() > 0.0);
  if (is_clear && tool.touch_depth_mm < leave_depth_mm) {
    outcome.scratch_mm = tool.scratch_mm;
    tool.stage = ToolStage::Free;
  }
}

/// A rotation about z by the angle of the unit direction; half angles by square roots alone.
Quat rotation_to(const Vec2& direction) noexcept {
  const double half_cos = std::sqrt(std::max(0.0, 0.5 * (1.0 + direction.x)));
  const double half_sin = std::sqrt(std::max(0.0, 0.5 * (1.0 - direction.x)));
  return {half_cos, 0.0, 0.0, direction.y < 0.0 ? -half_sin : half_sin};
}

/// The pose in the kerf's frame from its planar part and the handle's deviation out of the plane.
RigidTransform bent_pose(const PlanarPose& planar, const RigidTransform& kerf_from_handle,
                         const ContactSettings& settings) noexcept {
  const double share = settings.coupling_newton_per_mm /
                       (settings.coupling_newton_per_mm + settings.slot_stiffness_newton_per_mm);
  const Quat in_plane = rotation_to(planar.direction);
  Quat tilt = glm::conjugate(in_plane) * kerf_from_handle.rotation;
  if (tilt.w < 0.0) tilt = -tilt;
  const double tilt_x = comply(2.0 * tilt.x, settings.slot_play_rad, settings.slot_compliance);
  const double tilt_y = comply(2.0 * tilt.y, settings.slot_play_rad, settings.slot_compliance);
  const double out_mm = comply(kerf_from_handle.translation_mm.z, settings.slot_play_mm, share);
  // The last part keeps the blade's direction in the plane: two small tilts together would turn it a little each tick.
  const Quat bend{1.0, 0.5 * tilt_x, 0.5 * tilt_y, -0.25 * tilt_x * tilt_y};
  return {normalised(in_plane * bend), Vec3{planar.tip_mm.x, planar.tip_mm.y, out_mm}};
}

/// The flat blade at a planar pose, in the bone frame.
RigidTransform flat_pose(const KerfPlane& plane, const PlanarPose& planar) noexcept {
  return plane.bone_from_kerf *
         RigidTransform{rotation_to(planar.direction), Vec3{planar.tip_mm.x, planar.tip_mm.y, 0.0}};
}

/// Turns the blade towards the wanted direction, step by step, until an edge or the teeth would meet bone.
void turn_aside(PlanarPose& planar, const Vec2& wanted, const KerfPlane& plane,
                const StandingBone& bone, TeethMemory& teeth) noexcept {
  const double turn = planar.direction.x * wanted.y - planar.direction.y * wanted.x;
  if (std::abs(turn) < turn_worth_asking) return;
  const double step = walk_step_mm / bone.kerfs.blade().depth_mm;
  const int steps = std::clamp(static_cast<int>(std::abs(turn) / step) + 1, 1, walk_steps);
  const double share = std::min(1.0 / steps, step / std::abs(turn));
  const Vec2 from = planar.direction;
  for (int i = 1; i <= steps; ++i) {
    const Vec2 sum = from + (share * i) * (wanted - from);
    const double length = std::sqrt(glm::dot(sum, sum));
    if (!(length > 0.5)) return;  // about to turn round: no way to go is shorter
    const PlanarPose turned{planar.tip_mm, sum / length};
    const RigidTransform pose = flat_pose(plane, turned);
    const bool is_free = !edge_meets_bone(pose, bone, 1.0) && !edge_meets_bone(pose, bone, -1.0) &&
                         !(engagement(pose, bone, 0.0, teeth).width_mm() > 0.0);
    if (!is_free) return;
    planar = turned;
  }
}

/// Shifts the blade along its tooth line, step by step, until the edge in front would meet bone.
void shift_aside(PlanarPose& planar, const Vec2& wanted_tip_mm, const KerfPlane& plane,
                 const StandingBone& bone) noexcept {
  const Vec2 along{-planar.direction.y, planar.direction.x};
  const double shift_mm = glm::dot(wanted_tip_mm - planar.tip_mm, along);
  if (std::abs(shift_mm) < shift_worth_asking_mm) return;
  const double side = shift_mm < 0.0 ? -1.0 : 1.0;
  double left_mm = std::abs(shift_mm);
  for (int i = 0; i < walk_steps && left_mm > 0.0; ++i) {
    const double step_mm = std::min(walk_step_mm, left_mm);
    const PlanarPose shifted{planar.tip_mm + (side * step_mm) * along, planar.direction};
    if (edge_meets_bone(flat_pose(plane, shifted), bone, side)) return;
    planar = shifted;
    left_mm -= step_mm;
  }
}

bool teeth_are_outside(const RigidTransform& bone_from_tool, const StandingBone& bone) noexcept {
  for (const Vec3& point : tooth_points(bone_from_tool, bone.kerfs.blade(), 0.0)) {
    if (bone.original.clearance_mm(point) <= 0.0) return false;
  }
  return true;
}

void move_in_kerf(ToolState& tool, const ToolInput& input, const StandingBone& bone,
                  const ContactSettings& settings, ToolOutcome& outcome) noexcept {
  const KerfPlane& plane = bone.kerfs.plane(tool.kerf);
  const RigidTransform kerf_from_handle =
      bone.kerfs.kerf_from_bone(tool.kerf) * input.bone_from_handle;
  PlanarPose planar = planar_pose(plane, tool.bone_from_tool);
  const PlanarPose wanted = planar_pose(plane, input.bone_from_handle);
  turn_aside(planar, wanted.direction, plane, bone, tool.teeth);
  shift_aside(planar, wanted.tip_mm, plane, bone);

  const double forward_mm = glm::dot(wanted.tip_mm - planar.tip_mm, planar.direction);
  RigidTransform flat = flat_pose(plane, planar);
  const double fed_mm = forward_mm < 0.0
                            ? forward_mm
                            : feed(flat, forward_mm, input, bone, settings, tool.teeth, outcome);
  planar.tip_mm += fed_mm * planar.direction;
  tool.bone_from_tool = plane.bone_from_kerf * bent_pose(planar, kerf_from_handle, settings);

  const bool is_engaged = outcome.engaged.width_mm() > 0.0;
  outcome.broke_through = tool.was_engaged && !is_engaged && forward_mm > 0.0 &&
                          teeth_are_outside(flat_pose(plane, planar), bone);
  tool.was_engaged = is_engaged;
  if (forward_mm < 0.0 && !blade_is_in_bone(flat_pose(plane, planar), bone)) {
    tool.stage = ToolStage::Free;
    tool.kerf = -1;
  }
}

/// Teeth that stand over what the blade has swept in the kerf's plane, in bone or in the air before it: a hand lays the
/// blade back into the line of its cut, also where the bone begins deeper.
std::int32_t teeth_over_slot(const RigidTransform& bone_from_tool, const StandingBone& bone,
                             std::int32_t kerf) noexcept {
  const KerfPlane& plane = bone.kerfs.plane(kerf);
  const RigidTransform flat = flat_pose(plane, planar_pose(plane, bone_from_tool));
  std::int32_t count = 0;
  for (const Vec3& point : tooth_points(flat, bone.kerfs.blade(), 0.0)) {
    const Vec3 local = transform_point(bone.kerfs.kerf_from_bone(kerf), point);
    if (bone.kerfs.field(kerf).is_open(Vec2{local.x, local.y})) ++count;
  }
  return count;
}

void limit_force(ToolOutcome& outcome, const ContactSettings& settings) noexcept {
  const double newton =
      std::sqrt(glm::dot(outcome.force_in_bone_newton, outcome.force_in_bone_newton));
  if (newton <= settings.force_limit_newton) return;
  outcome.force_in_bone_newton *= settings.force_limit_newton / newton;
  outcome.is_force_limited = true;
}

}  // namespace

std::int32_t find_kerf_to_join(const RigidTransform& bone_from_tool, const StandingBone& bone,
                               const ContactSettings& settings) noexcept {
  for (std::int32_t kerf = 0; kerf < bone.kerfs.count(); ++kerf) {
    const RigidTransform kerf_from_tool = bone.kerfs.kerf_from_bone(kerf) * bone_from_tool;
    const Vec3 normal = axis_z(kerf_from_tool);
    const double tilt_sine = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    const double offset_mm = std::abs(kerf_from_tool.translation_mm.z);
    if (normal.z <= 0.0 || tilt_sine > settings.capture_angle_rad) continue;
    if (tilt_sine <= settings.rejoin_angle_rad && offset_mm <= settings.rejoin_offset_mm)
      return kerf;
    if (offset_mm > 0.5 * bone.kerfs.blade().kerf_mm + settings.capture_offset_mm) continue;
    if (teeth_over_slot(bone_from_tool, bone, kerf) >= settings.capture_teeth) return kerf;
  }
  return -1;
}

void enter_kerf(ToolState& tool, std::int32_t kerf, const StandingBone& bone,
                const ContactSettings& settings) noexcept {
  const KerfPlane& plane = bone.kerfs.plane(kerf);
  const RigidTransform kerf_from_tool = bone.kerfs.kerf_from_bone(kerf) * tool.bone_from_tool;
  const PlanarPose planar = planar_pose(plane, tool.bone_from_tool);
  tool.bone_from_tool = plane.bone_from_kerf * bent_pose(planar, kerf_from_tool, settings);
  tool.stage = ToolStage::InKerf;
  tool.kerf = kerf;
  tool.was_engaged = false;
}

ToolOutcome move_tool(ToolState& tool, const ToolInput& input, const StandingBone& bone,
                      const ContactSettings& settings) noexcept {
  ToolOutcome outcome;
  if (tool.stage == ToolStage::Free) {
    move_free(tool, input, bone, outcome);
    if (tool.stage == ToolStage::Touching) {
      const std::int32_t kerf = find_kerf_to_join(tool.bone_from_tool, bone, settings);
      if (kerf >= 0) enter_kerf(tool, kerf, bone, settings);
    }
    if (tool.stage == ToolStage::Free) return outcome;
  } else if (tool.stage == ToolStage::Touching) {
    move_touching(tool, input, bone, settings, outcome);
  } else {
    move_in_kerf(tool, input, bone, settings, outcome);
  }
  if (tool.stage == ToolStage::Free) return outcome;
  outcome.force_in_bone_newton =
      settings.coupling_newton_per_mm *
      (tool.bone_from_tool.translation_mm - input.bone_from_handle.translation_mm);
  limit_force(outcome, settings);
  return outcome;
}

}  // namespace hallux::simulator

/// In its kerf the blade has three freedoms that the step solves one after the other: it turns and
/// shifts in the plane until an edge meets bone, advances by the feed law, and bends a little out
/// of the plane under the hand. Each is walked in small steps from the pose before, so the blade
/// never lies in bone that stands and no wall is jumped, however fast the hand is. A spring is
/// pulled by what is left of the way; friction holds part of that pull back.
#include "simulator/contact/tool_in_kerf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/contact/blade_probe.h"

namespace hallux::simulator {

namespace {

/// Ways are walked in steps of this, at most `walk_steps` a tick.
constexpr double walk_step_mm = 0.1;
constexpr int walk_steps = 10;
/// A turn in the kerf's plane below this is not worth asking the bone about.
constexpr double turn_worth_asking = 0.0005;
/// A shift aside below the record's quantum likewise [mm].
constexpr double shift_worth_asking_mm = 0.001;
/// Sliding along the walls is over where the pull is this share of the friction.
constexpr double rest_share = 0.95;
/// A handle whose direction is this much or less of it in the plane, 3 degrees from its normal,
/// says none there.
constexpr double across_plane = 0.05;
/// A blade drawn back by more than this since its teeth were in bone is on its way out, not
/// through.
constexpr double drawn_back_limit_mm = 1.0;
/// So far behind teeth that have just come out at the far side there is bone, also where they came
/// out aslant.
constexpr double behind_far_side_mm = 1.0;
/// Kerfs of blades that differ by less are as wide.
constexpr double same_width_mm = 1.0e-6;

RigidTransform moved(const RigidTransform& pose, const Vec3& by_mm) noexcept {
  return {pose.rotation, pose.translation_mm + by_mm};
}

/// What is left of a deviation: all of it within the play, beyond it only the share that gives way.
double comply(double deviation, double play, double share) noexcept {
  const double beyond = std::abs(deviation) - play;
  if (beyond <= 0.0) return deviation;
  return (deviation < 0.0 ? -1.0 : 1.0) * (play + share * beyond);
}

/// Where the hand wants the teeth, ahead of where they are, how far they may go where no bone is in
/// their way, and how far until the collar stands on the bone.
struct Push {
  double wanted_mm = 0.0;
  double travel_limit_mm = 0.0;
  double room_mm = 0.0;
};

/// Advances along the tool's x: freely until the teeth stand on bone, then by the feed law of the
/// whole push.
double feed(RigidTransform& bone_from_tool, const Push& push, const ToolInput& input,
            const Wound& bone, const ContactSettings& settings, OfFragments<TeethMemory>& teeth,
            ToolOutcome& outcome) noexcept {
  const Vec3 ahead = axis_x(bone_from_tool);
  const double free_mm = std::min({push.wanted_mm, push.travel_limit_mm, push.room_mm});
  double done_mm = 0.0;
  for (int i = 0; i == 0 || (i < walk_steps && done_mm < free_mm); ++i) {
    outcome.engaged = engagement(bone_from_tool, bone, probe_ahead_mm, teeth);
    const bool is_engaged = outcome.engaged.width_mm() > 0.0;
    double step_mm = std::min(walk_step_mm, free_mm - done_mm);
    if (is_engaged) {
      const double left_mm = push.wanted_mm - done_mm;
      const double force_newton =
          std::min(settings.force_limit_newton, settings.coupling_newton_per_mm * left_mm);
      const double rate_mm_s = input.cuts() ? feed_rate_mm_s(outcome.engaged, force_newton,
                                                             input.saw, settings.bone_quality)
                                            : 0.0;
      step_mm = std::min({left_mm, push.room_mm - done_mm, rate_mm_s * input.duration_s});
      outcome.advance_mm = step_mm;
    }
    bone_from_tool = moved(bone_from_tool, step_mm * ahead);
    done_mm += step_mm;
    if (is_engaged) break;
  }
  return done_mm;
}

/// What the walls' friction leaves of a pull along the plane, of a blade pushed against them; both
/// as stretch of the spring.
Vec2 after_friction(const Vec2& pull_mm, double push_mm, const ContactSettings& settings,
                    bool& slides) noexcept {
  const double length_mm = length_of(pull_mm);
  const double hold_mm = settings.friction * push_mm;
  const double slide_mm = settings.kinetic_ratio * hold_mm;
  slides = length_mm > (slides ? rest_share * slide_mm : hold_mm);
  if (!slides) return {0.0, 0.0};
  return (std::max(0.0, length_mm - slide_mm) / length_mm) * pull_mm;
}

/// A rotation about z by the angle of the unit direction; half angles by square roots alone.
Quat rotation_to(const Vec2& direction) noexcept {
  const double half_cos = std::sqrt(std::max(0.0, 0.5 * (1.0 + direction.x)));
  const double half_sin = std::sqrt(std::max(0.0, 0.5 * (1.0 - direction.x)));
  return {half_cos, 0.0, 0.0, direction.y < 0.0 ? -half_sin : half_sin};
}

/// How far aside a hand is felt: beyond, force and bend are at their greatest.
double held_aside_mm(double hand_mm, const ContactSettings& settings) noexcept {
  const double most_mm = settings.slot_play_mm +
                         settings.force_limit_newton / settings.coupling_newton_per_mm +
                         settings.force_limit_newton / settings.slot_stiffness_newton_per_mm;
  return std::clamp(hand_mm, -most_mm, most_mm);
}

/// The same of a tilt.
double held_tilt_rad(double hand_rad, const ContactSettings& settings) noexcept {
  const double grip_share = 1.0 - settings.slot_compliance;
  const double most_rad =
      settings.slot_play_rad +
      settings.torque_limit_newton_mm / (grip_share * settings.torsion_newton_mm_per_rad);
  return std::clamp(hand_rad, -most_rad, most_rad);
}

/// How far out of its plane the slot lets a blade that is held there.
double bent_aside_mm(double held_mm, const ContactSettings& settings) noexcept {
  const double share = settings.coupling_newton_per_mm /
                       (settings.coupling_newton_per_mm + settings.slot_stiffness_newton_per_mm);
  return comply(held_mm, settings.slot_play_mm, share);
}

/// Out of the kerf's plane: aside, and tilted about the feed direction and about the tooth line.
struct Bend {
  double out_mm = 0.0;
  double tilt_x_rad = 0.0, tilt_y_rad = 0.0;
};

/// How a pose deviates from the flat blade at a planar pose.
Bend deviation(const PlanarPose& planar, const RigidTransform& kerf_from_pose) noexcept {
  Quat tilt = glm::conjugate(rotation_to(planar.direction)) * kerf_from_pose.rotation;
  if (tilt.w < 0.0) tilt = -tilt;
  return {kerf_from_pose.translation_mm.z, 2.0 * tilt.x, 2.0 * tilt.y};
}

/// What the slot leaves of the hand's deviation.
Bend bend_under(const Bend& hand, const ContactSettings& settings) noexcept {
  const auto tilt_rad = [&](double hand_rad) {
    return comply(held_tilt_rad(hand_rad, settings), settings.slot_play_rad,
                  settings.slot_compliance);
  };
  return {bent_aside_mm(held_aside_mm(hand.out_mm, settings), settings), tilt_rad(hand.tilt_x_rad),
          tilt_rad(hand.tilt_y_rad)};
}

double towards(double from, double to, double step) noexcept {
  return std::abs(to - from) <= step ? to : from + (to < from ? -step : step);
}

/// From one bend towards another; no point of the blade goes further by any of the three.
Bend bent_towards(const Bend& from, const Bend& to, double travel_limit_mm,
                  double depth_mm) noexcept {
  const double turn_limit_rad = travel_limit_mm / depth_mm;
  return {towards(from.out_mm, to.out_mm, travel_limit_mm),
          towards(from.tilt_x_rad, to.tilt_x_rad, turn_limit_rad),
          towards(from.tilt_y_rad, to.tilt_y_rad, turn_limit_rad)};
}

/// The pose in the kerf's frame from its planar part and its bend.
RigidTransform bent_pose(const PlanarPose& planar, const Bend& bend) noexcept {
  const double half_x = 0.5 * bend.tilt_x_rad, half_y = 0.5 * bend.tilt_y_rad;
  // The last part keeps the blade's direction in the plane: two small tilts together would turn it
  // a little each tick.
  const Quat tilt{1.0, half_x, half_y, -half_x * half_y};
  return {normalised(rotation_to(planar.direction) * tilt),
          Vec3{planar.tip_mm.x, planar.tip_mm.y, bend.out_mm}};
}

/// Where the hand wants the blade in the plane; a handle that stands across it leaves the blade its
/// direction.
PlanarPose wanted_in_plane(const KerfPlane& plane, const RigidTransform& bone_from_handle,
                           const PlanarPose& now) noexcept {
  PlanarPose wanted = planar_pose(plane, bone_from_handle);
  const Vec3 ahead = axis_x(bone_from_handle);
  const double across = glm::dot(ahead, axis_z(plane.bone_from_kerf));
  if (1.0 - across * across <= across_plane * across_plane) wanted.direction = now.direction;
  return wanted;
}

/// The flat blade at a planar pose, in the bone frame.
RigidTransform flat_pose(const KerfPlane& plane, const PlanarPose& planar) noexcept {
  return plane.bone_from_kerf *
         RigidTransform{rotation_to(planar.direction), Vec3{planar.tip_mm.x, planar.tip_mm.y, 0.0}};
}

/// A way in steps of `step`, no more than there may be; the share of the way that each is.
struct Steps {
  int count = 1;
  double share = 1.0;
};
Steps steps_of(double way, double step, double limit) noexcept {
  const int count = std::clamp(static_cast<int>(std::min(way, limit) / step) + 1, 1, walk_steps);
  return {count, std::min({1.0, limit / way, count * step / way}) / count};
}

/// Turns the blade towards the wanted direction, step by step, until an edge or the teeth would
/// meet bone.
void turn_aside(PlanarPose& planar, const Vec2& wanted, double travel_limit_mm,
                const KerfPlane& plane, const Wound& bone,
                OfFragments<TeethMemory>& teeth) noexcept {
  const double turn = cross(planar.direction, wanted);
  if (std::abs(turn) < turn_worth_asking) return;
  const double depth_mm = bone.blade().depth_mm;
  const auto [steps, share] =
      steps_of(std::abs(turn), walk_step_mm / depth_mm, travel_limit_mm / depth_mm);
  const Vec2 from = planar.direction;
  for (int i = 1; i <= steps; ++i) {
    const Vec2 sum = from + (share * i) * (wanted - from);
    const double length = length_of(sum);
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
void shift_aside(PlanarPose& planar, const Vec2& wanted_tip_mm, double travel_limit_mm,
                 const KerfPlane& plane, const Wound& bone) noexcept {
  const Vec2 along{-planar.direction.y, planar.direction.x};
  const double shift_mm = glm::dot(wanted_tip_mm - planar.tip_mm, along);
  if (std::abs(shift_mm) < shift_worth_asking_mm) return;
  const double side = shift_mm < 0.0 ? -1.0 : 1.0;
  double left_mm = std::min(std::abs(shift_mm), travel_limit_mm);
  for (int i = 0; i < walk_steps && left_mm > 0.0; ++i) {
    const double step_mm = std::min(walk_step_mm, left_mm);
    const PlanarPose shifted{planar.tip_mm + (side * step_mm) * along, planar.direction};
    if (edge_meets_bone(flat_pose(plane, shifted), bone, side)) return;
    planar = shifted;
    left_mm -= step_mm;
  }
}

/// A way that the blade may go at least before its collar, thicker than a kerf, stands on the
/// original surface; asked anew where that is below `enough_mm`.
double collar_room_mm(const RigidTransform& bone_from_tool, const Wound& bone, double enough_mm,
                      OfFragments<CollarMemory>& memories) noexcept {
  const Blade& blade = bone.blade();
  double room_mm = std::numeric_limits<double>::infinity();
  const auto ask = [&](std::int32_t number, const WoundFragment& standing) {
    const RigidTransform fragment_from_tool = standing.fragment_from(bone_from_tool);
    double side = -0.5;
    for (SurfaceMemory& known : memories[static_cast<std::size_t>(number)]) {
      const Vec3 point_mm =
          transform_point(fragment_from_tool, Vec3{-blade.depth_mm, side * blade.width_mm, 0.0});
      double least_mm = known.clearance_mm - length_of(point_mm - known.asked_mm);
      if (!known.is_known || least_mm < enough_mm) {
        least_mm = standing.tissue.clearance_mm(point_mm);
        known = {point_mm, least_mm, true};
      }
      room_mm = std::min(room_mm, std::max(0.0, least_mm));
      side += 0.5;
    }
  };
  bone.visit_near(bone_from_tool.translation_mm, reach_of_blade_mm(blade), ask);
  return room_mm;
}

bool teeth_are_outside(const RigidTransform& bone_from_tool, const Wound& bone) noexcept {
  for (const Vec3& point : tooth_points(bone_from_tool, bone.blade(), 0.0)) {
    if (bone.clearance_mm(point) <= 0.0) return false;
  }
  return true;
}

/// Whether the blade comes out at the far side by going `ahead_mm` further (negative: back). The
/// last tooth in bone need not be the last within the bone: beside an earlier stroke the others
/// still stand in its kerf, deeper where the bone is.
bool breaks_through(ToolState& tool, bool is_engaged, double ahead_mm,
                    const RigidTransform& bone_from_flat, const Wound& bone) noexcept {
  if (is_engaged) {
    tool.may_break_through = true;
    tool.drawn_back_mm = 0.0;
    return false;
  }
  if (!tool.may_break_through) return false;
  tool.drawn_back_mm = std::max(0.0, tool.drawn_back_mm - ahead_mm);
  const bool is_out = ahead_mm > 0.0 && teeth_are_outside(bone_from_flat, bone);
  tool.may_break_through = !is_out && tool.drawn_back_mm <= drawn_back_limit_mm;
  if (!is_out) return false;
  // Behind teeth that slid out sideways there is no bone.
  const double behind_mm = ahead_mm + behind_far_side_mm;
  return !teeth_are_outside(moved(bone_from_flat, -behind_mm * axis_x(bone_from_flat)), bone);
}

/// Teeth that stand over what the blade has swept in the kerf's plane, in bone or in the air before
/// it: a hand lays the blade back into the line of its cut, also where the bone begins deeper.
std::int32_t teeth_over_slot(const RigidTransform& fragment_from_tool, const KerfSet& kerfs,
                             std::int32_t kerf) noexcept {
  const KerfPlane& plane = kerfs.plane(kerf);
  const RigidTransform flat = flat_pose(plane, planar_pose(plane, fragment_from_tool));
  std::int32_t count = 0;
  for (const Vec3& point : tooth_points(flat, kerfs.blade(), 0.0)) {
    const Vec3 local = transform_point(kerfs.kerf_from_bone(kerf), point);
    if (kerfs.field(kerf).is_open(Vec2{local.x, local.y})) ++count;
  }
  return count;
}

/// The kerf of one fragment that a pose in its frame may use again, or -1. One that is narrower or
/// wider than what the blade takes is none of its own.
std::int32_t kerf_to_join(const RigidTransform& fragment_from_tool, const FragmentKerfs& kerfs,
                          const ContactSettings& settings) noexcept {
  for (const std::int32_t kerf : kerfs) {
    const double wider_mm = kerfs.plane(kerf).thickness_mm - kerfs.blade().kerf_mm;
    if (std::abs(wider_mm) > same_width_mm) continue;
    const RigidTransform kerf_from_tool = kerfs.kerf_from_bone(kerf) * fragment_from_tool;
    const Vec3 normal = axis_z(kerf_from_tool);
    const double tilt_sine = length_of(Vec2{normal.x, normal.y});
    const double offset_mm = std::abs(kerf_from_tool.translation_mm.z);
    if (normal.z <= 0.0 || tilt_sine > settings.capture_angle_rad) continue;
    if (tilt_sine <= settings.rejoin_angle_rad && offset_mm <= settings.rejoin_offset_mm)
      return kerf;
    if (offset_mm > 0.5 * kerfs.blade().kerf_mm + settings.capture_offset_mm) continue;
    if (teeth_over_slot(fragment_from_tool, kerfs.all(), kerf) >= settings.capture_teeth)
      return kerf;
  }
  return -1;
}

}  // namespace

void move_in_kerf(ToolState& tool, const ToolInput& input, const Wound& bone,
                  const ContactSettings& settings, double travel_limit_mm,
                  ToolOutcome& outcome) noexcept {
  const WoundFragment& standing = bone.fragment_of_kerf(tool.kerf);
  const KerfPlane plane = bone.plane(tool.kerf);
  const RigidTransform& kerf_from_fragment = bone.kerfs().kerf_from_bone(tool.kerf);
  const RigidTransform kerf_from_handle =
      kerf_from_fragment * standing.fragment_from(input.bone_from_handle);
  PlanarPose planar = planar_pose(plane, tool.bone_from_tool);
  const Bend bend =
      deviation(planar, kerf_from_fragment * standing.fragment_from(tool.bone_from_tool));
  const PlanarPose wanted = wanted_in_plane(plane, input.bone_from_handle, planar);
  const double held_mm = held_aside_mm(kerf_from_handle.translation_mm.z, settings);
  const double push_mm = std::abs(held_mm - bent_aside_mm(held_mm, settings));
  const Vec2 target_mm =
      planar.tip_mm + after_friction(wanted.tip_mm - planar.tip_mm, push_mm, settings, tool.slides);
  turn_aside(planar, wanted.direction, travel_limit_mm, plane, bone, tool.teeth);
  shift_aside(planar, target_mm, travel_limit_mm, plane, bone);

  const double forward_mm = glm::dot(target_mm - planar.tip_mm, planar.direction);
  RigidTransform flat = flat_pose(plane, planar);
  double fed_mm = std::max(forward_mm, -travel_limit_mm);
  if (forward_mm >= 0.0) {
    const double room_mm = collar_room_mm(flat, bone, travel_limit_mm + walk_step_mm, tool.collar);
    const Push push{forward_mm, travel_limit_mm, room_mm};
    fed_mm = feed(flat, push, input, bone, settings, tool.teeth, outcome);
  }
  planar.tip_mm += fed_mm * planar.direction;
  const Bend wanted_bend = bend_under(deviation(planar, kerf_from_handle), settings);
  tool.bone_from_tool =
      plane.bone_from_kerf *
      bent_pose(planar, bent_towards(bend, wanted_bend, travel_limit_mm, bone.blade().depth_mm));

  outcome.broke_through = breaks_through(tool, outcome.engaged.width_mm() > 0.0, fed_mm,
                                         flat_pose(plane, planar), bone);
  if (forward_mm < 0.0 && !blade_is_in_bone(flat_pose(plane, planar), bone)) {
    leave_kerf(tool);
  }
}

std::int32_t find_kerf_to_join(const RigidTransform& bone_from_tool, const Wound& bone,
                               const ContactSettings& settings) noexcept {
  std::int32_t kerf = -1;
  bone.visit_near(bone_from_tool.translation_mm, reach_of_blade_mm(bone.blade()),
                  [&](std::int32_t, const WoundFragment& standing) {
                    if (kerf >= 0) return;
                    kerf = kerf_to_join(standing.fragment_from(bone_from_tool),
                                        standing.tissue.kerfs, settings);
                  });
  return kerf;
}

void enter_kerf(ToolState& tool, std::int32_t kerf) noexcept {
  tool.stage = ToolStage::InKerf;
  tool.kerf = kerf;
  tool.may_break_through = tool.slides = false;
}

void leave_kerf(ToolState& tool) noexcept {
  if (tool.stage != ToolStage::InKerf) return;
  tool.stage = ToolStage::Free;
  tool.is_held = true;
  tool.kerf = -1;
}

}  // namespace hallux::simulator

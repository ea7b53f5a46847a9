/// A tick's way is gone in parts of a quarter of a millimetre, with contacts looked for anew in
/// each. Points remember how far they were from a surface: most of them are answered by that alone.
/// Surfaces are held a few micrometres apart, so that the way out of each other is always known.
/// After the way a few further points of each side are looked at: one that came into the other body
/// is led out from the next tick on.
#include "simulator/contact/gripped_body.h"

#include <algorithm>
#include <cmath>

#include "simulator/contact/contact_walk.h"

namespace hallux::simulator {

namespace {

/// That surfaces are held apart.
constexpr double apart_mm = 0.005;
/// Nearer than this the way to a surface is no direction.
constexpr double direction_mm = 1.0e-5;
/// A piece that is driven home turns as readily as it goes: as if it were held this far out.
constexpr double driven_grip_mm = 8.0;
/// Bone on bone, from rest, and of it while it slides.
constexpr double bone_friction = 0.2, bone_kinetic_ratio = 0.8;
/// A part of a way that is shorter than it could be by less is whole.
constexpr double rounding_mm = 1.0e-9;
/// Of a contact, for a claim.
constexpr double touching_mm = 0.02;
/// So many further points of a side are looked at in a tick, and so deep.
constexpr int looked_at_once = 12;
constexpr double look_mm = 0.3;

/// A pose of the piece about its centroid.
RigidTransform about_centroid(const RigidTransform& wound_from_piece, const Vec3& centroid_mm) {
  return {wound_from_piece.rotation, transform_point(wound_from_piece, centroid_mm)};
}

RigidTransform from_centroid(const RigidTransform& pose, const Vec3& centroid_mm) {
  return {pose.rotation,
          pose.translation_mm - transform_direction({pose.rotation, {}}, centroid_mm)};
}

/// Further than this no point that the piece meets others by lies from its centroid.
double radius_of(const GrippedBody& gripped) noexcept {
  double most_mm2 = 0.0;
  for (const Vec3& point : gripped.points_mm)
    most_mm2 = std::max(most_mm2, squared_length(point - gripped.centroid_mm));
  return std::sqrt(most_mm2);
}

struct NearSurface {
  /// Out of the surface, in its frame.
  Vec3 normal{0.0, 0.0, 0.0};
  double height_mm = 0.0;
};

/// The surface within the distance of a point of its frame; the memory learns what was asked.
std::optional<NearSurface> near_surface(const Bvh& surface, const Vec3& point_mm, double within_mm,
                                        SurfaceMemory& memory) noexcept {
  const double moved_mm = memory.moved_mm(point_mm);
  if (memory.is_known && std::abs(memory.clearance_mm) - moved_mm > within_mm) return std::nullopt;
  const double looked_mm = within_mm + tick_travel_limit_mm;
  const std::optional<NearestPoint> found = nearest_by_memory(surface, point_mm, looked_mm, memory);
  if (!found) {
    memory = {point_mm, looked_mm, true};
    return std::nullopt;
  }
  const double side = found->is_inside ? -1.0 : 1.0;
  memory = {point_mm, side * found->distance_mm, true};
  if (found->distance_mm > within_mm || found->distance_mm < direction_mm) return std::nullopt;
  return NearSurface{(side / found->distance_mm) * (point_mm - found->point_mm),
                     side * found->distance_mm};
}

/// The same of another that stands; place and normal in the wound frame.
std::optional<NearSurface> near_other(const StandingSurface& other, const Vec3& place_mm,
                                      double within_mm, SurfaceMemory& memory) noexcept {
  auto near = near_surface(*other.surface, transform_point(other.surface_from_wound, place_mm),
                           within_mm, memory);
  if (near) near->normal = transform_direction(other.wound_from_surface, near->normal);
  return near;
}

bool is_at_joint(const GrippedBody& gripped, const Vec3& place_mm) noexcept {
  if (!gripped.joint) return false;
  const Vec3 arm = place_mm - gripped.joint->point_mm;
  const Vec3 across = arm - glm::dot(arm, gripped.joint->axis) * gripped.joint->axis;
  const double free_mm = gripped.joint->free_radius_mm;
  return squared_length(across) < free_mm * free_mm;
}

/// Contacts of a pose about the centroid with everything within the margin.
class GrippedContacts {
 public:
  GrippedContacts(GrippedBody& gripped, const RigidTransform& pose, double margin_mm) noexcept
      : gripped_(gripped),
        pose_(pose),
        margin_mm_(margin_mm),
        wound_from_piece_(from_centroid(pose, gripped.centroid_mm)),
        piece_from_wound_(inverse(wound_from_piece_)) {
    std::size_t place = 0;
    for (const StandingSurface& other : gripped.others) add_own(other, gripped.memories[place++]);
    add_met();
  }

  std::span<const BladeContact> all() const noexcept { return contacts_.all(); }

 private:
  /// Points of the piece; of several surfaces each is held out of the nearest.
  void add_own(const StandingSurface& other, PointMemories& memories) noexcept {
    const std::span<const std::size_t> slots = gripped_.asked.slots();
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
      const Vec3 place_mm = transform_point(wound_from_piece_, gripped_.points_mm[slots[slot]]);
      if (is_at_joint(gripped_, place_mm)) continue;
      const auto near = near_other(other, place_mm, margin_mm_ + apart_mm, memories[slots[slot]]);
      if (near) put(slot, place_mm, near->normal, near->height_mm - apart_mm);
    }
  }

  /// Points of the others, which the piece must not take in.
  void add_met() noexcept {
    const std::span<const std::size_t> slots = gripped_.asked_met.slots();
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
      const Vec3& place_mm = gripped_.met_points_mm.begin()[slots[slot]];
      if (is_at_joint(gripped_, place_mm)) continue;
      const Vec3 point_mm = transform_point(piece_from_wound_, place_mm);
      const auto near = near_surface(*gripped_.surface, point_mm, margin_mm_ + apart_mm,
                                     gripped_.met_memories[slots[slot]]);
      if (!near) continue;
      const Vec3 normal = -transform_direction(wound_from_piece_, near->normal);
      put(asked_point_limit + slot, place_mm, normal, near->height_mm - apart_mm);
    }
  }

  void put(std::size_t number, const Vec3& place_mm, const Vec3& normal, double gap_mm) noexcept {
    const BladeContact contact{number, place_mm - pose_.translation_mm, normal, gap_mm, false};
    std::size_t& place = place_of_[number];
    if (place == 0) {
      contacts_.list[contacts_.count++] = contact;
      place = contacts_.count;
    } else if (gap_mm < contacts_.list[place - 1].gap_mm) {
      contacts_.list[place - 1] = contact;
    }
  }

  GrippedBody& gripped_;
  const RigidTransform& pose_;
  double margin_mm_;
  RigidTransform wound_from_piece_, piece_from_wound_;
  BladeContacts contacts_;
  /// Of each point its place in the list, counted from 1; 0: none.
  std::array<std::size_t, contact_limit> place_of_{};
};

void look_at_own(GrippedBody& gripped) noexcept {
  const std::size_t point = gripped.asked.next();
  const Vec3 place_mm = transform_point(gripped.wound_from_piece, gripped.points_mm[point]);
  if (is_at_joint(gripped, place_mm)) return;
  bool is_in = false;
  std::size_t place = 0;
  for (const StandingSurface& other : gripped.others) {
    const auto near = near_other(other, place_mm, look_mm, gripped.memories[place++][point]);
    is_in = is_in || (near && near->height_mm < 0.0);
  }
  if (!is_in) return;
  const auto away_mm = [&](std::size_t asked) {
    double least_mm = gripped.memories[0][asked].clearance_mm;
    for (std::size_t i = 1; i < gripped.others.size(); ++i)
      least_mm = std::min(least_mm, gripped.memories[i][asked].clearance_mm);
    return least_mm;
  };
  const std::size_t slot = gripped.asked.take_in(point, away_mm);
  if (slot < asked_point_limit) gripped.load.forget(slot);
}

void look_at_met(GrippedBody& gripped, const RigidTransform& piece_from_wound) noexcept {
  const std::size_t point = gripped.asked_met.next();
  const Vec3& place_mm = gripped.met_points_mm.begin()[point];
  if (is_at_joint(gripped, place_mm)) return;
  const auto near = near_surface(*gripped.surface, transform_point(piece_from_wound, place_mm),
                                 look_mm, gripped.met_memories[point]);
  if (!near || !(near->height_mm < 0.0)) return;
  const std::size_t slot = gripped.asked_met.take_in(
      point, [&](std::size_t asked) { return gripped.met_memories[asked].clearance_mm; });
  if (slot < asked_point_limit) gripped.load.forget(asked_point_limit + slot);
}

/// Beside the points that are asked in every tick.
void look_further(GrippedBody& gripped) noexcept {
  const RigidTransform piece_from_wound = inverse(gripped.wound_from_piece);
  for (int i = 0; i < looked_at_once; ++i) {
    if (gripped.asked.has_more()) look_at_own(gripped);
    if (gripped.asked_met.has_more()) look_at_met(gripped, piece_from_wound);
  }
}

/// The turn about a joint that comes nearest to a motion.
double nearest_turn_rad(const WoundJoint& joint, const ProxyMotion& wanted, const Vec3& centre_mm,
                        double grip2_mm2) noexcept {
  const Vec3 swing = glm::cross(joint.axis, centre_mm - joint.point_mm);
  const double push = glm::dot(swing, wanted.translation_mm) +
                      grip2_mm2 * glm::dot(joint.axis, wanted.rotation_rad);
  return push / (glm::dot(swing, swing) + grip2_mm2);
}

/// As much of a turn as contacts allow.
double free_turn(double turn_rad, const WoundJoint& joint, const Vec3& centre_mm,
                 std::span<const BladeContact> contacts) noexcept {
  double most_rad = turn_rad;
  for (const BladeContact& contact : contacts) {
    const Vec3 arm = centre_mm + contact.arm_mm - joint.point_mm;
    const double per_rad = glm::dot(contact.normal, glm::cross(joint.axis, arm));
    if (!(per_rad * most_rad < 0.0)) continue;
    const double room_rad = std::max(0.0, contact.gap_mm) / std::abs(per_rad);
    if (std::abs(most_rad) > room_rad) most_rad = most_rad < 0.0 ? -room_rad : room_rad;
  }
  return most_rad;
}

RigidTransform turned_about(const RigidTransform& pose, const WoundJoint& joint,
                            double turn_rad) noexcept {
  const RigidTransform turn{rotation_about(joint.axis, turn_rad), {}};
  return {normalised(turn.rotation * pose.rotation),
          joint.point_mm + transform_direction(turn, pose.translation_mm - joint.point_mm)};
}

/// As much of a way along a joint as contacts allow.
double free_slide_mm(double slide_mm, const WoundJoint& joint,
                     std::span<const BladeContact> contacts) noexcept {
  double most_mm = slide_mm;
  for (const BladeContact& contact : contacts) {
    const double per_mm = glm::dot(contact.normal, joint.axis);
    if (!(per_mm * most_mm < 0.0)) continue;
    const double room_mm = std::max(0.0, contact.gap_mm) / std::abs(per_mm);
    if (std::abs(most_mm) > room_mm) most_mm = most_mm < 0.0 ? -room_mm : room_mm;
  }
  return most_mm;
}

/// Pose, hand and drive of one tick.
struct Lead {
  RigidTransform pose, wanted;
  std::optional<Vec3> drive_mm;
  double grip_mm = 0.0, radius_mm = 0.0;

  ProxyMotion motion() const noexcept {
    return drive_mm ? ProxyMotion{*drive_mm, Vec3{0.0, 0.0, 0.0}} : motion_between(pose, wanted);
  }
};

/// Along the joint or about it; how far the piece's furthest point went.
double go_by_joint(const WoundJoint& joint, Lead& lead, const ProxyMotion& wanted, double most_mm,
                   std::span<const BladeContact> contacts) noexcept {
  if (joint.moves == JointMotion::Slide) {
    const double asked_mm =
        std::clamp(glm::dot(joint.axis, wanted.translation_mm), -most_mm, most_mm);
    const double slide_mm = free_slide_mm(asked_mm, joint, contacts);
    lead.pose.translation_mm += slide_mm * joint.axis;
    return std::abs(slide_mm);
  }
  const double grip2_mm2 = lead.grip_mm * lead.grip_mm;
  const double arm_mm = length_of(lead.pose.translation_mm - joint.point_mm) + lead.radius_mm;
  const double limit_rad = most_mm / arm_mm;
  const double asked_rad = std::clamp(
      nearest_turn_rad(joint, wanted, lead.pose.translation_mm, grip2_mm2), -limit_rad, limit_rad);
  const double turn_rad = free_turn(asked_rad, joint, lead.pose.translation_mm, contacts);
  lead.pose = turned_about(lead.pose, joint, turn_rad);
  return std::abs(turn_rad) * arm_mm;
}

/// One part of a tick's way; how far it went.
double go_on(GrippedBody& gripped, Lead& lead, const ProxyMotion& wanted, double most_mm,
             GrippedOutcome& outcome) noexcept {
  const GrippedContacts contacts(gripped, lead.pose, most_mm);
  for (const BladeContact& contact : contacts.all())
    outcome.is_touching = outcome.is_touching || contact.gap_mm < touching_mm;
  if (gripped.joint) return go_by_joint(*gripped.joint, lead, wanted, most_mm, contacts.all());
  const ProxyFriction friction{bone_friction, bone_kinetic_ratio, bone_friction};
  const ProxyMotion motion =
      solve_proxy(wanted, contacts.all(), lead.grip_mm, friction, gripped.load).motion;
  const double way_mm = reach_of(motion, lead.radius_mm);
  lead.pose = moved_by(lead.pose, scaled(motion, way_mm > most_mm ? most_mm / way_mm : 1.0));
  return std::min(way_mm, most_mm);
}

}  // namespace

void choose_points(GrippedBody& gripped) noexcept {
  gripped.met_points_mm = {};
  bool has_more = true;
  for (std::size_t rank = 0; has_more; ++rank) {
    has_more = false;
    for (const StandingSurface& other : gripped.others) {
      if (rank >= other.points_mm.size() || gripped.met_points_mm.is_full()) continue;
      gripped.met_points_mm.push(transform_point(other.wound_from_surface, other.points_mm[rank]));
      has_more = true;
    }
  }
  gripped.asked = AskedPoints(gripped.points_mm.size());
  gripped.asked_met = AskedPoints(gripped.met_points_mm.size());
}

GrippedOutcome move_gripped(GrippedBody& gripped, const RigidTransform& wound_from_handle,
                            const std::optional<Vec3>& drive_mm,
                            const ContactSettings& settings) noexcept {
  GrippedOutcome outcome;
  Lead lead;
  lead.pose = about_centroid(gripped.wound_from_piece, gripped.centroid_mm);
  lead.wanted = about_centroid(wound_from_handle * gripped.handle_from_piece, gripped.centroid_mm);
  lead.drive_mm = drive_mm;
  lead.radius_mm = radius_of(gripped);
  lead.grip_mm =
      drive_mm ? driven_grip_mm
               : std::sqrt(settings.torsion_newton_mm_per_rad / settings.coupling_newton_per_mm);
  const Vec3 from_mm = lead.pose.translation_mm;
  double left_mm = tick_travel_limit_mm;
  for (int part = 0; part < walk_part_limit && left_mm > 0.0; ++part) {
    const double most_mm = std::min(walk_part_mm, left_mm);
    const double gone_mm = go_on(gripped, lead, lead.motion(), most_mm, outcome);
    left_mm -= gone_mm;
    // What contacts stopped short of a whole part goes on in the next tick.
    if (gone_mm + rounding_mm < most_mm || drive_mm) break;
  }
  gripped.wound_from_piece = from_centroid(lead.pose, gripped.centroid_mm);
  look_further(gripped);
  outcome.moved_mm = length_of(lead.pose.translation_mm - from_mm);
  outcome.pull = coupling_pull(motion_between(lead.wanted, lead.pose), settings);
  return outcome;
}

}  // namespace hallux::simulator

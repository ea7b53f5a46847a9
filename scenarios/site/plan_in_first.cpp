#include "scenarios/site/plan_in_first.h"

namespace hallux::scenarios {

namespace {

/// Says what is in a bone's frame in that of the first.
class Move {
 public:
  explicit Move(const RigidTransform& first_from_bone) : first_from_bone_(first_from_bone) {}

  void point(Vec3& point_mm) const { point_mm = transform_point(first_from_bone_, point_mm); }
  void direction(Vec3& direction) const {
    direction = transform_direction(first_from_bone_, direction);
  }
  void face(ReferenceFace& face) const {
    direction(face.normal);
    face.offset_mm += glm::dot(face.normal, first_from_bone_.translation_mm);
  }
  /// What carries something from where it was.
  void way(RigidTransform& way) const { way = first_from_bone_ * way * inverse(first_from_bone_); }

 private:
  RigidTransform first_from_bone_;
};

void say(PlannedCut& cut, const Move& move) {
  move.face(cut.face);
  for (Vec3* const direction : {&cut.axis, &cut.approach_in_bone, &cut.contained_in_bone})
    move.direction(*direction);
  for (Vec3* const point_mm :
       {&cut.depth_point_in_bone_mm, &cut.exit_point_in_bone_mm, &cut.entry_point_in_bone_mm})
    move.point(*point_mm);
  if (!cut.window) return;
  move.point(cut.window->from_in_bone_mm);
  move.direction(cut.window->along);
  move.direction(cut.window->across);
}

void say(PlannedHinge& hinge, const Move& move) {
  simulator::HingeLine& line = hinge.bridge.line;
  move.point(line.point_in_bone_mm);
  for (Vec3* const direction : {&line.axis, &line.outward, &hinge.bridge.toward_moved})
    move.direction(*direction);
}

void say(PlannedZone& zone, const Move& move) {
  move.point(zone.capsule.from_in_bone_mm);
  move.point(zone.capsule.to_in_bone_mm);
}

void say(PlannedJointSurface& joint, const Move& move) { move.point(joint.centre_in_bone_mm); }

void say(PlannedFragment& fragment, const Move& move) {
  move.point(fragment.holds_in_bone_mm);
  move.way(fragment.bone_from_rest);
  move.direction(fragment.foot_dorsal_in_bone);
}

void say(PlannedShift& shift, const Move& move) {
  move.way(shift.before_from_cut);
  move.way(shift.bone_from_before);
}

void say(PlannedImplant& implant, const Move& move) {
  move.point(implant.entry_in_bone_mm);
  move.point(implant.tip_in_bone_mm);
  move.direction(implant.direction_in_bone);
}

}  // namespace

Plan plan_in_first(Plan plan, const simulator::Bones& bones) {
  const auto say_all = [&](auto& parts) {
    for (auto& part : parts) {
      if (part.bone != 0) say(part, Move(first_from(bones, part.bone)));
    }
  };
  say_all(plan.cuts);
  say_all(plan.hinges);
  say_all(plan.danger_zones);
  say_all(plan.joint_surfaces);
  say_all(plan.fixation.fragments);
  say_all(plan.fixation.shifts);
  say_all(plan.fixation.implants);
  return plan;
}

}  // namespace hallux::scenarios

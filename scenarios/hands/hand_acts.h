/// The operation as a list of acts, made before the hand begins: turn to a cut, saw a stroke, wait,
/// say. Inside this corner only.
#pragma once

#include <cstdint>
#include <vector>

#include "scenarios/hands/bore_work.h"
#include "scenarios/hands/hand_aim.h"
#include "scenarios/hands/stroke_plan.h"
#include "simulator/record/record.h"

namespace hallux::scenarios {

/// What the hand does next.
struct Act {
  enum class Kind {
    /// Through the air into another plane.
    TurnTo,
    Saw,
    /// Along the feed through the air, with the tool running or not.
    Lead,
    /// A wire, drill or screw along its axis.
    Bore,
    Wait,
    /// The blade away from bone, until it has been idle for its share of the time.
    Idle,
    Say,
    TakeRest,
    /// The forceps take hold of the piece that lies nearest to a point.
    Grip
  };
  Kind kind = Kind::Wait;
  /// TurnTo: the plane in which the blade is to lie, x the feed, and where in it; in the frame of
  /// the first bone.
  RigidTransform bone_from_blade = {};
  double along_mm = 0.0;
  /// TurnTo, Lead: to there.
  double feed_mm = 0.0;
  /// TurnTo: 0 as fast as the hand comes to a cut.
  double speed_mm_s = 0.0;
  /// Lead.
  bool saw_runs = false;
  Stroke stroke = {};
  /// Saw: how well it comes back to the slot.
  double jitter_mm = 0.0, jitter_rad = 0.0;
  double wait_s = 0.0;
  /// Idle: for a second of work so many without.
  double idle_share = 0.0;
  simulator::Command command = {};
  BoreTask bore = {};
  /// TakeRest: the cuts whose waste is meant, by bits.
  std::uint32_t waste_of = 0;
  /// Grip: a point of the fragment, in the frame of its bone.
  Vec3 near_in_bone_mm{0.0, 0.0, 0.0};
  std::size_t near_bone = 0;
};

/// All that the acts follow from; borrowed.
struct Undertaking {
  const Scenario& scenario;
  simulator::Bones bones;
  const Plan& plan;
  /// As the plan has them.
  const std::vector<AimedCut>& cuts;
  const HandSkill& skill;
  std::uint64_t seed;
};

/// The scenario's steps in the order in which the hand does them, without those that it leaves out;
/// of alternatives the first.
std::vector<std::size_t> steps_to_do(const Scenario& scenario, const HandSkill& skill);
/// errors  ScenarioError where a zone that it is to touch is none of the plan's
std::vector<Act> plan_acts(const Undertaking& undertaking);
/// Where the hand is when it begins: far in front of its first cut.
Act starting_act(const Undertaking& undertaking);

}  // namespace hallux::scenarios

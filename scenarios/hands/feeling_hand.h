/// Scripted hands that feel: a plan carried out by an expert, by a novice or without any error, as
/// well as what they feel and see lets them.
///
///     force, pose of the blade
///       --> senses --a reaction time later--> stroke work --> handle --> device state
///                                          \-> held axes --/
///
/// A hand aims its blade at faces that are tilted and shifted against the plan, saws in overlapping
/// strokes from the approach side with a force it means to keep, stops at a hinge as well as it
/// sees, wanders out of the plane and undoes what it notices of that, and declares each step done.
/// All of its errors come from a seed; their sizes are the working expectation for freehand cuts in
/// small bones, not measured on people.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scenarios/hands/bore_work.h"
#include "scenarios/hands/hand_acts.h"
#include "scenarios/hands/hand_aim.h"
#include "scenarios/hands/held_axis.h"
#include "scenarios/hands/loose_pieces.h"
#include "scenarios/hands/stroke_work.h"
#include "simulator/device/haptic_device.h"
#include "simulator/loop/attempt_operator.h"

namespace hallux::scenarios {

class FeelingHand final : public simulator::HapticDevice, public simulator::AttemptOperator {
 public:
  /// The hand for all of the scenario's steps.
  /// ensures the same arguments and the same simulation give the same motion on every machine
  /// errors  ScenarioError where a planned plane misses the bone
  FeelingHand(const Scenario& scenario, simulator::Bones bones, const Plan& plan,
              const HandSkill& skill, std::uint64_t seed);

  /// As the plan has them.
  const std::vector<AimedCut>& cuts() const noexcept { return cuts_; }
  /// An attempt of few steps that is not done by then is finished as it is.
  static constexpr std::int64_t last_tick = 300'000;
  /// Likewise of this hand: later where there are more steps, or it is slow on purpose.
  std::int64_t end_tick() const noexcept { return end_tick_; }

  simulator::DeviceDescription description() const override {
    return {"scripted hand", "scripted"};
  }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                simulator::RawDeviceState& state) noexcept override;
  void observe(const simulator::StepOutput& output) noexcept override;
  bool take_command(simulator::Command& command) noexcept override;
  double fraction_done() const noexcept override;

 private:
  void begin_act() noexcept;
  bool goes_on(double span_s) noexcept;
  bool leads_on(const Act& act, double span_s) noexcept;
  bool idles_on(const Act& act, double span_s) noexcept;
  void begin_turn(const Act& act) noexcept;
  bool is_turning() const noexcept;
  bool take_rest(const Act& act) noexcept;
  void grip(const Act& act) noexcept;
  void feel(const Vec3& force_in_world_newton, std::int64_t ticks) noexcept;
  void hold_blade(double span_s) noexcept;
  void align_with_slot(const RigidTransform& world_from_slot) noexcept;
  void queue(const simulator::Command& command) noexcept;
  /// Once it has turned.
  RigidTransform held_pose() const noexcept;
  RigidTransform pose() const noexcept;

  HandSkill skill_;
  RigidTransform world_from_bone_;
  std::vector<AimedCut> cuts_;
  std::vector<Act> acts_;
  std::size_t next_act_ = 0;
  /// The act at hand.
  bool is_begun_ = false;

  /// The plane that the hand keeps to.
  RigidTransform world_from_blade_;
  /// As it was seen last.
  RigidTransform world_from_tool_;
  /// TurnTo: the pose in which it began.
  RigidTransform turned_from_;
  Handle handle_;
  HandSenses senses_;
  StrokeWork work_;
  BoreWork bore_;
  HeldAxis out_, tilt_x_, tilt_y_;
  /// Where they lie, as the hand sees it.
  simulator::FragmentPoses fragments_;
  LoosePieces loose_;
  double felt_newton_ = 0.0;
  /// As it was seen last.
  double engaged_mm_ = 0.0;
  double act_s_ = 0.0, turn_s_ = 0.0;
  /// In all Idle acts so far.
  double idled_s_ = 0.0;
  /// TakeRest: of the act, when the hand is free for the next piece.
  double free_at_s_ = 0.0;
  std::int64_t tick_ = -1, end_tick_ = last_tick;
  std::array<simulator::Command, simulator::commands_per_tick> queue_{};
  std::size_t queued_ = 0, taken_ = 0;
};

}  // namespace hallux::scenarios

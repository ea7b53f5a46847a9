/// The operation is a list of acts made beforehand (hand_acts.h). A tick feels, holds the blade,
/// and carries on with the act at hand; several short acts may end in one tick. The blade's plane
/// is the hand's own frame: once a kerf is frozen the hand lays that frame into the slot, and the
/// handle stays where it is.
#include "scenarios/hands/feeling_hand.h"

#include <algorithm>

#include "simulator/base/random.h"
#include "simulator/base/units.h"
#include "simulator/jobs/lying_bones.h"

namespace hallux::scenarios {

namespace {

using simulator::CommandKind;

/// What a hand takes a newton aside for: so far is the handle out of the slot [mm].
constexpr double give_mm_per_newton = 0.5;
/// From piece to piece.
constexpr double take_s = 0.5;
/// For each step beyond those of a short operation.
constexpr std::int64_t ticks_per_step = 45'000;
constexpr std::size_t short_operation_steps = 8;

std::int64_t last_tick_of(const Scenario& scenario) noexcept {
  const std::size_t steps = std::max(scenario.steps.size(), short_operation_steps);
  return FeelingHand::last_tick +
         ticks_per_step * static_cast<std::int64_t>(steps - short_operation_steps);
}

}  // namespace

FeelingHand::FeelingHand(const Scenario& scenario, simulator::Bones bones, const Plan& plan,
                         const HandSkill& skill, std::uint64_t seed)
    : skill_(skill),
      world_from_bone_(bones.first().world_from_bone),
      cuts_(aim(scenario, plan, KnownBones(bones), skill, seed)),
      senses_(skill.perception, Random(seed, "hand.eye")),
      work_(skill, seed),
      bore_(skill, seed),
      out_(Random(seed, "wander.out"), skill.wander_mm, skill.perception.steadying_per_s),
      tilt_x_(Random(seed, "wander.tilt_x"), skill.wander_rad, skill.perception.steadying_per_s),
      tilt_y_(Random(seed, "wander.tilt_y"), skill.wander_rad, skill.perception.steadying_per_s),
      fragments_(poses_of(bones)) {
  const Undertaking undertaking{scenario, bones, plan, cuts_, skill_, seed};
  const Act start = starting_act(undertaking);
  world_from_blade_ = world_from_bone_ * start.bone_from_blade;
  handle_.feed_mm = start.feed_mm;
  handle_.along_mm = start.along_mm;
  acts_ = plan_acts(undertaking);
  const double times = std::max(1.0, fault_size(skill_.faults, FaultKind::Slow));
  end_tick_ = static_cast<std::int64_t>(times * static_cast<double>(last_tick_of(scenario)));
  world_from_tool_ = pose();
}

bool FeelingHand::exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                           simulator::RawDeviceState& state) noexcept {
  const std::int64_t ticks =
      std::clamp<std::int64_t>(tick - tick_, 1, simulator::ticks_per_line_max);
  tick_ = tick;
  const double span_s = static_cast<double>(ticks) * step_s;
  queued_ = taken_ = 0;
  feel(force_in_world_newton, ticks);
  hold_blade(span_s);
  while (next_act_ < acts_.size() && goes_on(span_s)) {
    ++next_act_;
    is_begun_ = false;
  }
  if (tick + 1 >= end_tick_) queue({CommandKind::Finish, 0, 0});
  state.world_from_handle = pose();
  state.switches = (handle_.saw_runs ? bit(simulator::Switch::SawRuns) : 0U) |
                   (handle_.irrigates ? bit(simulator::Switch::Irrigates) : 0U);
  return true;
}

/// Whether the act at hand is done, so that the next begins within the same tick.
bool FeelingHand::goes_on(double span_s) noexcept {
  const Act& act = acts_[next_act_];
  if (!is_begun_) begin_act();
  is_begun_ = true;
  act_s_ += span_s;
  switch (act.kind) {
    case Act::Kind::TurnTo:
      return act_s_ >= turn_s_;
    case Act::Kind::Saw:
      work_.go_on(handle_, senses_, felt_newton_, span_s);
      return work_.is_done();
    case Act::Kind::Lead:
      return leads_on(act, span_s);
    case Act::Kind::Bore:
      bore_.go_on(handle_, senses_, felt_newton_, span_s);
      return bore_.is_done();
    case Act::Kind::Wait:
      return act_s_ >= act.wait_s;
    case Act::Kind::Idle:
      return idles_on(act, span_s);
    case Act::Kind::Say:
      if (queued_ == queue_.size()) return false;
      queue(act.command);
      return true;
    case Act::Kind::TakeRest:
      return take_rest(act);
    case Act::Kind::Grip:
      if (queued_ == queue_.size()) return false;
      grip(act);
      return true;
  }
  return true;
}

bool FeelingHand::leads_on(const Act& act, double span_s) noexcept {
  handle_.saw_runs = act.saw_runs;
  handle_.irrigates = act.saw_runs && skill_.cooling.has_water;
  return lead_to(handle_, act.feed_mm, skill_.approach_mm_s * span_s);
}

/// Until it has been idle for as long as its work so far asks.
bool FeelingHand::idles_on(const Act& act, double span_s) noexcept {
  idled_s_ += span_s;
  return idled_s_ >= act.idle_share * (second_from_tick(tick_) - idled_s_);
}

/// Bone that was sawn off in several pieces is taken out whole. True where none is left.
bool FeelingHand::take_rest(const Act& act) noexcept {
  if (act_s_ < free_at_s_ || queued_ == queue_.size()) return false;
  const std::optional<std::int32_t> piece = loose_.take_waste(cuts_, act.waste_of);
  if (!piece) return true;
  queue({CommandKind::PickUp, *piece, 0});
  free_at_s_ = act_s_ + take_s;
  return false;
}

/// The piece that lies nearest; where none was seen to come free, what came free last.
void FeelingHand::grip(const Act& act) noexcept {
  const std::optional<std::int32_t> piece = loose_.nearest(act.near_in_bone_mm, act.near_bone);
  queue({CommandKind::Grip, piece.value_or(simulator::piece_freed_last), 0});
}

void FeelingHand::begin_act() noexcept {
  const Act& act = acts_[next_act_];
  act_s_ = free_at_s_ = 0.0;
  if (act.kind == Act::Kind::TurnTo) begin_turn(act);
  if (act.kind == Act::Kind::Saw) {
    out_.mean(act.jitter_mm);
    tilt_x_.mean(act.jitter_rad);
    work_.begin(act.stroke);
  }
  if (act.kind == Act::Kind::Bore) bore_.begin(act.bore);
}

/// Straight through the air into another plane.
void FeelingHand::begin_turn(const Act& act) noexcept {
  turned_from_ = pose();
  world_from_blade_ = world_from_bone_ * act.bone_from_blade;
  handle_.feed_mm = act.feed_mm;
  handle_.along_mm = act.along_mm;
  out_.mean(0.0);
  tilt_x_.mean(0.0);
  const double way_mm = length_of(held_pose().translation_mm - turned_from_.translation_mm);
  const double speed_mm_s = act.speed_mm_s > 0.0 ? act.speed_mm_s : skill_.approach_mm_s;
  turn_s_ = std::max(step_s, way_mm / speed_mm_s);
}

bool FeelingHand::is_turning() const noexcept {
  return next_act_ < acts_.size() && acts_[next_act_].kind == Act::Kind::TurnTo && is_begun_;
}

void FeelingHand::queue(const simulator::Command& command) noexcept {
  if (queued_ < queue_.size()) queue_[queued_++] = command;
}

/// The senses in the blade's plane: the push from the force on the hand, the rest from where the
/// blade is seen.
void FeelingHand::feel(const Vec3& force_in_world_newton, std::int64_t ticks) noexcept {
  const RigidTransform blade_from_world = inverse(world_from_blade_);
  const Vec3 on_hand_newton = transform_direction(blade_from_world, force_in_world_newton);
  const Vec3 tool_mm = transform_point(blade_from_world, world_from_tool_.translation_mm);
  felt_newton_ = -on_hand_newton.x;
  senses_.observe({felt_newton_, on_hand_newton.z, engaged_mm_, tool_mm.x, tool_mm.z,
                   tilt_x_.value(), tilt_y_.value()},
                  ticks);
}

/// In bone a hand wanders and undoes what it sees of the blade and feels of the slot; in air it
/// looks where it holds it.
void FeelingHand::hold_blade(double span_s) noexcept {
  const double time_s = second_from_tick(tick_);
  if (work_.is_free()) {
    for (HeldAxis* axis : {&out_, &tilt_x_, &tilt_y_}) axis->bring(time_s, span_s);
    return;
  }
  const Sensed& noticed = senses_.noticed();
  const double out_mm = noticed.out_mm - give_mm_per_newton * noticed.aside_newton;
  out_.hold(time_s, span_s, out_mm);
  tilt_x_.hold(time_s, span_s, noticed.tilt_x_rad);
  tilt_y_.hold(time_s, span_s, noticed.tilt_y_rad);
}

RigidTransform FeelingHand::held_pose() const noexcept {
  const Quat tilt = normalised(Quat{1.0, 0.5 * tilt_x_.value(), 0.5 * tilt_y_.value(), 0.0});
  return world_from_blade_ *
         RigidTransform{tilt, Vec3{handle_.feed_mm, handle_.along_mm, out_.value()}};
}

RigidTransform FeelingHand::pose() const noexcept {
  if (!is_turning()) return held_pose();
  return interpolate(turned_from_, held_pose(), std::min(1.0, act_s_ / turn_s_));
}

void FeelingHand::observe(const simulator::StepOutput& output) noexcept {
  world_from_tool_ = simulator::transform_from(output.sample.world_from_tool);
  engaged_mm_ = output.engaged.width_mm();
  for (const simulator::CutEvent& event : output.events) {
    fragments_.apply(event);
    loose_.observe(event, fragments_);
    if (event.kind == simulator::CutEventKind::PlaneFrozen) {
      const auto fragment = static_cast<std::int32_t>(event.value);
      align_with_slot(fragments_[fragment].world_from_fragment *
                      simulator::transform_from(event.pose));
    }
  }
}

/// The slot that the blade has begun is the plane from now on; the handle stays where it is.
void FeelingHand::align_with_slot(const RigidTransform& world_from_slot) noexcept {
  const RigidTransform world_from_handle = held_pose();
  const Vec3 normal = axis_z(world_from_slot);
  const Vec3 ahead = axis_x(world_from_blade_);
  const Vec3 flat_ahead = ahead - glm::dot(ahead, normal) * normal;
  const Vec3& origin = world_from_blade_.translation_mm;
  const double off_mm = glm::dot(origin - world_from_slot.translation_mm, normal);
  world_from_blade_ = {rotation_from_axes(flat_ahead, glm::cross(normal, flat_ahead)),
                       origin - off_mm * normal};
  const RigidTransform blade_from_handle = inverse(world_from_blade_) * world_from_handle;
  handle_.feed_mm = blade_from_handle.translation_mm.x;
  handle_.along_mm = blade_from_handle.translation_mm.y;
  out_.put(blade_from_handle.translation_mm.z);
  tilt_x_.put(2.0 * blade_from_handle.rotation.x);
  tilt_y_.put(2.0 * blade_from_handle.rotation.y);
}

bool FeelingHand::take_command(simulator::Command& command) noexcept {
  if (taken_ == queued_) return false;
  command = queue_[taken_++];
  return true;
}

double FeelingHand::fraction_done() const noexcept {
  return static_cast<double>(next_act_) / static_cast<double>(acts_.size());
}

}  // namespace hallux::scenarios

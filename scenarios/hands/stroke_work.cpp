/// A stroke is a small machine: a phase has one way to move the handle and a few signs that end it.
/// All signs come from the senses, a reaction time late, and none from the simulation: a hand that
/// plunges through the far cortex does so because it noticed too late.
#include "scenarios/hands/stroke_work.h"

#include <algorithm>

#include "simulator/base/elementary.h"

namespace hallux::scenarios {

namespace {

/// How far in front of the bone a blade is that was drawn out and goes in again.
constexpr double left_bone_mm = 6.0;

constexpr double settle_mm = 2.0;  ///< in front of the bone before sawing
/// Through air and open slots a hand does not rush.
constexpr double seek_mm_s = 3.0;
constexpr double touch_newton = 1.0;    ///< a hand knows that it has met bone
constexpr double nothing_newton = 0.3;  ///< and that nothing holds the blade any more
/// Bone gave way where the push fell to this share of what it was, and was worth noticing.
constexpr double given_share = 0.35, given_newton = 3.0;
constexpr double used_to_s = 0.3;
constexpr double give_back_mm = 1.0;  ///< behind where bone gave way
constexpr double look_newton = 2.5;   ///< the push of a hand that looks
constexpr double rest_s = 0.3;
/// A blade is drawn back within the bone and laid back until just before where it was.
constexpr double least_in_bone_mm = 0.5, before_teeth_mm = 0.4;
/// A stroke that does not go on is tried anew, and given up.
constexpr double still_mm_s = 0.02, still_limit_s = 4.0, patience_s = 60.0;
/// Doubt matters where it is this many times what the eye leaves, and twice it reaches as far as
/// the bone that is left.
constexpr double doubt_times_eye = 1.5, doubt_deviations = 2.0;

}  // namespace

StrokeWork::StrokeWork(const HandSkill& skill, std::uint64_t seed)
    : skill_(skill), water_(seed, "hand.water"), wanted_(skill.push, Random(seed, "hand.push")) {}

void StrokeWork::begin(const Stroke& stroke) noexcept {
  stroke_ = stroke;
  stroke_s_ = still_s_ = unseen_s_ = 0.0;
  restarts_left_ = stroke.restarts;
  enter(Phase::Reach);
}

void StrokeWork::enter(Phase phase) noexcept {
  phase_ = phase;
  phase_s_ = 0.0;
  if (phase == Phase::Seek) burst_s_ = level_newton_ = 0.0;
  if (phase == Phase::Seek) wanted_.calm_down();
  if (phase == Phase::Push) level_newton_ = 0.0;
}

bool StrokeWork::goes_to(Handle& handle, double feed_mm, double speed_mm_s,
                         double span_s) const noexcept {
  return lead_to(handle, feed_mm, speed_mm_s * span_s);
}

void StrokeWork::go_on(Handle& handle, const HandSenses& senses, double felt_newton,
                       double span_s) noexcept {
  phase_s_ += span_s;
  stroke_s_ += span_s;
  mind_water(handle, span_s);
  switch (phase_) {
    case Phase::Reach:
      return reach(handle, span_s);
    case Phase::Lower:
      if (goes_to(handle, stroke_.first_mm - settle_mm, skill_.approach_mm_s, span_s)) {
        enter(Phase::Seek);
      }
      return;
    case Phase::Seek:
      return seek(handle, senses, span_s);
    case Phase::Push:
      push(handle, senses, felt_newton, span_s);
      return decide_while_pushing(senses);
    case Phase::Look:
      return look(handle, senses, felt_newton, span_s);
    case Phase::GiveBack:
    case Phase::Clear: {
      const double back_mm = phase_ == Phase::Clear ? skill_.cooling.clear_mm : give_back_mm;
      const double to_mm = std::max(turned_at_mm_ - back_mm, stroke_.first_mm + least_in_bone_mm);
      if (handle.feed_mm > to_mm && !goes_to(handle, to_mm, skill_.approach_mm_s, span_s)) return;
      return enter(phase_ == Phase::Clear ? Phase::Return : Phase::Seek);
    }
    case Phase::Leave:
      if (goes_to(handle, stroke_.first_mm - left_bone_mm, skill_.approach_mm_s, span_s)) {
        enter(Phase::Return);
      }
      return;
    case Phase::Return: {
      const double to_mm = turned_at_mm_ - before_teeth_mm;
      if (handle.feed_mm < to_mm && !goes_to(handle, to_mm, skill_.approach_mm_s, span_s)) return;
      return enter(Phase::Seek);
    }
    case Phase::LetGo:
      goes_to(handle, stroke_.first_mm, skill_.approach_mm_s, span_s);
      if (felt_newton <= nothing_newton) enter(Phase::Rest);
      return;
    case Phase::Rest:
      if (phase_s_ >= rest_s) enter(Phase::Withdraw);
      return;
    case Phase::Withdraw:
      if (!goes_to(handle, stroke_.first_mm - hover_mm, skill_.approach_mm_s, span_s)) return;
      handle.saw_runs = handle.irrigates = false;
      return enter(Phase::Done);
    case Phase::Done:
      return;
  }
}

/// In front of the bone, then the saw starts, with water or without.
void StrokeWork::reach(Handle& handle, double span_s) noexcept {
  const double most_mm = skill_.approach_mm_s * span_s;
  handle.along_mm += std::clamp(stroke_.along_mm - handle.along_mm, -most_mm, most_mm);
  const bool is_there = goes_to(handle, stroke_.first_mm - hover_mm, skill_.approach_mm_s, span_s);
  if (!is_there || handle.along_mm != stroke_.along_mm) return;
  handle.saw_runs = true;
  const bool forgets = water_.uniform() < skill_.cooling.forgets_water;
  dry_s_ = forgets ? -skill_.cooling.notices_dry_s * elementary::log(1.0 - water_.uniform()) : 0.0;
  enter(Phase::Lower);
}

/// Water runs once its lack is noticed, which needs teeth in bone.
void StrokeWork::mind_water(Handle& handle, double span_s) noexcept {
  if (!handle.saw_runs || handle.irrigates) return;
  if (phase_ == Phase::Push || phase_ == Phase::Look) dry_s_ -= span_s;
  handle.irrigates = skill_.cooling.has_water && dry_s_ <= 0.0;
}

void StrokeWork::seek(Handle& handle, const HandSenses& senses, double span_s) noexcept {
  handle.feed_mm += seek_mm_s * span_s;
  const Sensed& noticed = senses.noticed();
  if (noticed.feed_mm >= stroke_.end_mm) return enter(Phase::LetGo);
  // What it notices first is still what it felt before it began to seek.
  const bool is_of_now = phase_s_ > skill_.perception.reaction_s;
  if (is_of_now && noticed.push_newton >= touch_newton) enter(Phase::Push);
}

/// The handle goes where the push that is felt becomes the push that is meant.
void StrokeWork::lead(Handle& handle, double meant_newton, const HandSenses& senses,
                      double felt_newton, double span_s) noexcept {
  const double seen_mm_s = senses.noticed_feed_mm_s();
  const double wanted_newton = wanted_.next_newton(meant_newton, seen_mm_s, span_s);
  handle.feed_mm += span_s * handle_speed_mm_s(skill_.push, wanted_newton, felt_newton, seen_mm_s);
}

/// Less near the far side, and no more than the teeth in bone can take.
double StrokeWork::meant_newton(const Sensed& noticed) const noexcept {
  const Push& push = skill_.push;
  const bool is_near_exit = noticed.feed_mm > stroke_.last_mm - push.exit_mm;
  return push.extra_newton + std::min(is_near_exit ? push.exit_newton : push.steady_newton,
                                      push.most_newton_per_mm * noticed.engaged_mm);
}

void StrokeWork::push(Handle& handle, const HandSenses& senses, double felt_newton,
                      double span_s) noexcept {
  const Sensed& noticed = senses.noticed();
  lead(handle, meant_newton(noticed), senses, felt_newton, span_s);
  level_newton_ += (noticed.push_newton - level_newton_) * std::min(1.0, span_s / used_to_s);
  burst_s_ += span_s;
  unseen_s_ += span_s;
  still_s_ = senses.noticed_feed_mm_s() < still_mm_s ? still_s_ + span_s : 0.0;
}

/// The saw runs on with hardly a push while the hand looks how deep it is.
void StrokeWork::look(Handle& handle, const HandSenses& senses, double felt_newton,
                      double span_s) noexcept {
  lead(handle, look_newton, senses, felt_newton, span_s);
  turned_at_mm_ = senses.noticed().feed_mm;
  if (feels_nothing(senses)) return enter(Phase::GiveBack);
  if (phase_s_ < skill_.perception.look_s) return;
  unseen_s_ = 0.0;
  enter(Phase::Push);
}

/// A hand that has begun to lean on the blade feels nothing against it.
bool StrokeWork::feels_nothing(const HandSenses& senses) const noexcept {
  return phase_s_ > skill_.perception.reaction_s && senses.noticed().push_newton < nothing_newton;
}

bool StrokeWork::is_in_doubt(double remaining_mm) const noexcept {
  const double eye_mm = skill_.perception.eye_mm;
  const double doubt_mm = eye_mm + skill_.perception.doubt_mm_per_s * unseen_s_;
  return doubt_mm > doubt_times_eye * eye_mm && doubt_deviations * doubt_mm > remaining_mm;
}

void StrokeWork::decide_while_pushing(const HandSenses& senses) noexcept {
  const Sensed& noticed = senses.noticed();
  turned_at_mm_ = noticed.feed_mm;
  if (noticed.feed_mm >= stroke_.end_mm || stroke_s_ > patience_s) return enter(Phase::LetGo);
  const bool gave_way =
      level_newton_ > given_newton && noticed.push_newton < given_share * level_newton_;
  if (gave_way || feels_nothing(senses)) return enter(Phase::GiveBack);
  const bool is_deep = noticed.feed_mm > stroke_.first_mm + 2.0 * least_in_bone_mm;
  if (is_deep && restarts_left_ > 0) {
    --restarts_left_;
    // Each time it begins anew, with all its patience.
    stroke_s_ = 0.0;
    return enter(Phase::Leave);
  }
  if (is_deep && (burst_s_ > skill_.cooling.burst_s || still_s_ > still_limit_s)) {
    still_s_ = 0.0;
    return enter(Phase::Clear);
  }
  if (is_in_doubt(stroke_.last_mm - noticed.feed_mm)) enter(Phase::Look);
}

}  // namespace hallux::scenarios

#include "scenarios/hands/bore_work.h"

#include <algorithm>

namespace hallux::scenarios {

namespace {

constexpr double settle_mm = 2.0;       ///< in front of the bone before boring
constexpr double seek_mm_s = 3.0;       ///< through air and what is open
constexpr double touch_newton = 1.0;    ///< a hand knows that it has met bone
constexpr double nothing_newton = 0.3;  ///< and that nothing holds the tip any more
/// With less a tip stands still in cortex.
constexpr double least_newton = 6.0;
constexpr double still_mm_s = 0.02, still_limit_s = 1.5, patience_s = 60.0;
constexpr double rest_s = 0.3;

}  // namespace

BoreWork::BoreWork(const HandSkill& skill, std::uint64_t seed)
    : skill_(skill), wanted_(skill.push, Random(seed, "hand.bore_push")) {}

void BoreWork::begin(const BoreTask& task) noexcept {
  task_ = task;
  way_s_ = 0.0;
  enter(Phase::Reach);
}

void BoreWork::enter(Phase phase) noexcept {
  phase_ = phase;
  phase_s_ = still_s_ = 0.0;
  if (phase == Phase::Seek) wanted_.calm_down();
}

bool BoreWork::goes_to(Handle& handle, double feed_mm, double span_s) const noexcept {
  return lead_to(handle, feed_mm, skill_.approach_mm_s * span_s);
}

void BoreWork::go_on(Handle& handle, const HandSenses& senses, double felt_newton,
                     double span_s) noexcept {
  phase_s_ += span_s;
  way_s_ += span_s;
  switch (phase_) {
    case Phase::Reach:
      return reach(handle, span_s);
    case Phase::Lower:
      if (goes_to(handle, task_.first_mm - settle_mm, span_s)) enter(Phase::Seek);
      return;
    case Phase::Seek:
      return seek(handle, senses, span_s);
    case Phase::Push:
      return push(handle, senses, felt_newton, span_s);
    case Phase::LetGo:
      // The spring between hand and tool is let out; the tool stays where it is.
      goes_to(handle, task_.first_mm, span_s);
      if (felt_newton <= nothing_newton) enter(Phase::Rest);
      return;
    case Phase::Rest:
      if (phase_s_ < rest_s) return;
      handle.saw_runs = handle.irrigates = false;
      return enter(Phase::Done);
    case Phase::Done:
      return;
  }
}

void BoreWork::reach(Handle& handle, double span_s) noexcept {
  const double most_mm = skill_.approach_mm_s * span_s;
  handle.along_mm += std::clamp(-handle.along_mm, -most_mm, most_mm);
  const bool is_there = goes_to(handle, task_.first_mm - hover_mm, span_s);
  if (!is_there || handle.along_mm != 0.0) return;
  handle.saw_runs = true;
  handle.irrigates = skill_.cooling.has_water;
  enter(Phase::Lower);
}

bool BoreWork::is_deep_enough(const HandSenses& senses) const noexcept {
  return senses.noticed().feed_mm >= task_.stop_mm || way_s_ > patience_s;
}

void BoreWork::seek(Handle& handle, const HandSenses& senses, double span_s) noexcept {
  handle.feed_mm += seek_mm_s * span_s;
  if (is_deep_enough(senses)) return enter(Phase::LetGo);
  // What it notices first is still what it felt before it began to seek.
  const bool is_of_now = phase_s_ > skill_.perception.reaction_s;
  if (is_of_now && senses.noticed().push_newton >= touch_newton) enter(Phase::Push);
}

/// The handle goes where the push that is felt becomes the one that is meant; less of it near the
/// end.
void BoreWork::push(Handle& handle, const HandSenses& senses, double felt_newton,
                    double span_s) noexcept {
  const Sensed& noticed = senses.noticed();
  const double seen_mm_s = senses.noticed_feed_mm_s();
  const Push& push = skill_.push;
  const bool is_near_end = noticed.feed_mm > task_.stop_mm - push.exit_mm;
  const double meant_newton =
      push.extra_newton +
      std::max(least_newton, is_near_end ? push.exit_newton : push.steady_newton);
  const double wanted_newton = wanted_.next_newton(meant_newton, seen_mm_s, span_s);
  handle.feed_mm += span_s * handle_speed_mm_s(push, wanted_newton, felt_newton, seen_mm_s);
  still_s_ = seen_mm_s < still_mm_s ? still_s_ + span_s : 0.0;
  const bool is_seated = task_.ends_seated && still_s_ > still_limit_s;
  if (is_deep_enough(senses) || is_seated) return enter(Phase::LetGo);
  const bool is_of_now = phase_s_ > skill_.perception.reaction_s;
  if (is_of_now && noticed.push_newton < nothing_newton) enter(Phase::Seek);
}

}  // namespace hallux::scenarios

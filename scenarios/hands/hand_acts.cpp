#include "scenarios/hands/hand_acts.h"

#include <algorithm>

#include "scenarios/hands/cut_strokes.h"
#include "scenarios/hands/stroke_work.h"
#include "scenarios/hands/zone_touch.h"
#include "simulator/base/random.h"

namespace hallux::scenarios {

namespace {

using simulator::CommandKind;

constexpr double far_hovers = 3.0, turn_hovers = 2.0;  ///< how far off the bone, in hover_mm

std::size_t first_cut_of(const Undertaking& undertaking) {
  for (const std::size_t step : steps_to_do(undertaking.scenario, undertaking.skill)) {
    const OperationStep& at_hand = undertaking.scenario.steps[step];
    if (at_hand.kind == StepKind::Cut) return index_of_cut(undertaking.plan, at_hand.cut);
  }
  return 0;
}

std::vector<Stroke> strokes_of(const Undertaking& undertaking, std::size_t cut) {
  return cut_strokes(undertaking.cuts[cut], undertaking.scenario.saw.blade, undertaking.skill);
}

/// In front of the cut's first stroke, or of the bone where the hand means to stop before it.
Act turn_to_cut(const Undertaking& undertaking, std::size_t cut, double hovers) {
  const AimedCut& aimed = undertaking.cuts[cut];
  const std::vector<Stroke> strokes = strokes_of(undertaking, cut);
  const Stroke first =
      strokes.empty() ? Stroke{.first_mm = aimed.region.min_mm.x} : strokes.front();
  return {.kind = Act::Kind::TurnTo,
          .bone_from_blade = aimed.plane.bone_from_kerf,
          .along_mm = first.along_mm,
          .feed_mm = first.first_mm - hovers * hover_mm};
}

/// The list as it grows.
class ActList {
 public:
  explicit ActList(const Undertaking& undertaking)
      : undertaking_(undertaking), cut_at_hand_(first_cut_of(undertaking)) {}

  std::vector<Act> planned() {
    say(CommandKind::Start);
    bool has_touched = false;
    for (const std::size_t step : steps_to_do(undertaking_.scenario, undertaking_.skill)) {
      const bool is_verify = undertaking_.scenario.steps[step].kind == StepKind::Verify;
      if (!is_verify && !has_touched) touch_zones();
      has_touched = has_touched || !is_verify;
      do_step(step);
    }
    idle();
    say(CommandKind::Finish);
    return std::move(acts_);
  }

 private:
  void say(CommandKind kind, std::int32_t argument = 0) {
    acts_.push_back({.kind = Act::Kind::Say, .command = {kind, argument, 0}});
  }

  void wait(double time_s) { acts_.push_back({.kind = Act::Kind::Wait, .wait_s = time_s}); }

  void idle() {
    const double factor = fault_size(undertaking_.skill.faults, FaultKind::Slow);
    if (factor > 1.0) acts_.push_back({.kind = Act::Kind::Idle, .idle_share = factor - 1.0});
  }

  void lead(double feed_mm, bool saw_runs) {
    acts_.push_back({.kind = Act::Kind::Lead, .feed_mm = feed_mm, .saw_runs = saw_runs});
  }

  void do_step(std::size_t step) {
    const OperationStep& at_hand = undertaking_.scenario.steps[step];
    if (at_hand.kind == StepKind::Cut) saw(index_of_cut(undertaking_.plan, at_hand.cut));
    if (at_hand.kind == StepKind::Remove) say(CommandKind::PickUp, simulator::piece_freed_last);
    if (at_hand.kind == StepKind::Close) say(CommandKind::CloseHinge);
    wait(at_hand.kind == StepKind::Verify ? 1.0 : 0.5);
    if (at_hand.kind == StepKind::Remove) acts_.push_back({.kind = Act::Kind::TakeRest});
    say(CommandKind::StepDone, static_cast<std::int32_t>(step));
  }

  void saw(std::size_t cut) {
    const HandSkill& skill = undertaking_.skill;
    if (cut != cut_at_hand_) acts_.push_back(turn_to_cut(undertaking_, cut, turn_hovers));
    const std::string& name = undertaking_.plan.cuts[cut].name;
    Random jitter(undertaking_.seed, cut == 0 ? "hand.strokes" : "hand.strokes." + name);
    const std::vector<Stroke> strokes = strokes_of(undertaking_, cut);
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      Act act{.kind = Act::Kind::Saw, .stroke = strokes[i]};
      // The first stroke makes the plane; later ones come back to it as well as the hand can.
      if (i > 0) {
        act.jitter_mm = jitter.truncated_normal(0.0, skill.stroke_jitter_mm);
        act.jitter_rad = jitter.truncated_normal(0.0, skill.stroke_jitter_rad);
      } else if (cut == cut_at_hand_) {
        act.stroke.restarts =
            static_cast<std::int32_t>(fault_size(skill.faults, FaultKind::Restarts));
      }
      acts_.push_back(act);
      idle();
    }
  }

  void touch_zones() {
    for (const HandFault& fault : undertaking_.skill.faults) {
      if (fault.kind == FaultKind::TouchZone) touch_zone(fault);
    }
  }

  /// There through the air, in with the saw running, out, and back in front of the first cut.
  void touch_zone(const HandFault& fault) {
    const Act home = turn_to_cut(undertaking_, cut_at_hand_, turn_hovers);
    const ZoneTouch touch =
        plan_touch(undertaking_.bone, undertaking_.plan, undertaking_.scenario.saw.blade,
                   {fault.subject, home.bone_from_blade});
    const double away_mm = -turn_hovers * hover_mm;
    const Act there{
        .kind = Act::Kind::TurnTo, .bone_from_blade = touch.bone_from_blade, .feed_mm = away_mm};
    const auto go_round = [&] {
      if (!touch.bone_from_halfway) return;
      acts_.push_back({.kind = Act::Kind::TurnTo,
                       .bone_from_blade = *touch.bone_from_halfway,
                       .feed_mm = -far_hovers * hover_mm});
    };
    go_round();
    acts_.push_back(there);
    lead(0.0, true);
    wait(fault.size);
    lead(away_mm, true);
    lead(away_mm, false);
    go_round();
    acts_.push_back(home);
  }

  const Undertaking& undertaking_;
  std::size_t cut_at_hand_;
  std::vector<Act> acts_;
};

}  // namespace

std::vector<std::size_t> steps_to_do(const Scenario& scenario, const HandSkill& skill) {
  std::vector<std::size_t> steps, cuts;
  for (std::size_t step = 0; step < scenario.steps.size(); ++step) {
    if (scenario.steps[step].kind == StepKind::Cut) cuts.push_back(step);
    steps.push_back(step);
  }
  if (has_fault(skill.faults, FaultKind::Swap) && cuts.size() > 1) {
    std::swap(steps[cuts[0]], steps[cuts[1]]);
  }
  const auto is_left_out = [&](std::size_t step) {
    return is_skipped(skill.faults, scenario.steps[step]);
  };
  steps.erase(std::remove_if(steps.begin(), steps.end(), is_left_out), steps.end());
  return steps;
}

std::vector<Act> plan_acts(const Undertaking& undertaking) {
  return ActList(undertaking).planned();
}

Act starting_act(const Undertaking& undertaking) {
  return turn_to_cut(undertaking, first_cut_of(undertaking), far_hovers);
}

}  // namespace hallux::scenarios

#include "scenarios/hands/hand_acts.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "scenarios/hands/cut_strokes.h"
#include "scenarios/hands/hand_reach.h"
#include "scenarios/hands/stroke_work.h"
#include "scenarios/hands/zone_touch.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/random.h"

namespace hallux::scenarios {

namespace {

using simulator::CommandKind;

constexpr double far_hovers = 3.0, turn_hovers = 2.0;  ///< how far off the bone, in hover_mm

/// How fast a hand leads what its forceps hold, and how long it drives it home.
constexpr double carry_mm_s = 2.0, carried_s = 1.0, impact_s = 2.5;
/// What takes hold, or comes into the hand.
constexpr double settle_s = 0.3;
/// Bone may begin so far before a planned entry.
constexpr double before_entry_mm = 4.0;

std::size_t first_cut_of(const Undertaking& undertaking) {
  for (const std::size_t step : steps_to_do(undertaking.scenario, undertaking.skill)) {
    const OperationStep& at_hand = undertaking.scenario.steps[step];
    if (at_hand.kind == StepKind::Cut) return index_of_cut(undertaking.plan, at_hand.cut);
  }
  return 0;
}

/// With the planned blade, or on purpose the next one.
std::int32_t blade_for(const Undertaking& undertaking, std::size_t cut) {
  const PlannedCut& planned = undertaking.plan.cuts[cut];
  const std::int32_t place = blade_place(planned);
  const auto blades = static_cast<std::int32_t>(undertaking.scenario.blades.size());
  const bool is_wrong = is_faulty(undertaking.skill.faults, FaultKind::WrongBlade, planned.name);
  return is_wrong && blades > 1 ? (place + 1) % blades : place;
}

std::vector<Stroke> strokes_of(const Undertaking& undertaking, std::size_t cut) {
  const Scenario& scenario = undertaking.scenario;
  const auto place = static_cast<std::size_t>(blade_for(undertaking, cut));
  const simulator::Blade& blade =
      scenario.blades.empty() ? scenario.saw.blade : scenario.blades[place].saw.blade;
  return cut_strokes(undertaking.cuts[cut], blade, undertaking.skill);
}

/// A pose in the frame of one of the bones, as the first one says it.
RigidTransform in_first(const Undertaking& undertaking, std::size_t bone,
                        const RigidTransform& bone_from_blade) {
  return bone == 0 ? bone_from_blade : first_from(undertaking.bones, bone) * bone_from_blade;
}

/// In front of the cut's first stroke, or of the bone where the hand means to stop before it.
Act turn_to_cut(const Undertaking& undertaking, std::size_t cut, double hovers) {
  const AimedCut& aimed = undertaking.cuts[cut];
  const std::vector<Stroke> strokes = strokes_of(undertaking, cut);
  const Stroke first =
      strokes.empty() ? Stroke{.first_mm = aimed.region.min_mm.x} : strokes.front();
  return {.kind = Act::Kind::TurnTo,
          .bone_from_blade = in_first(undertaking, aimed.bone, aimed.plane.bone_from_kerf),
          .along_mm = first.along_mm,
          .feed_mm = first.first_mm - hovers * hover_mm};
}

/// Of a plan's implants or shifts.
template <typename Part>
std::size_t index_in(const std::vector<Part>& parts, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(parts, name, &Part::name) - parts.begin());
}

/// The list as it grows.
class ActList {
 public:
  explicit ActList(const Undertaking& undertaking)
      : undertaking_(undertaking),
        first_cut_(first_cut_of(undertaking)),
        tool_(0),
        is_at_first_cut_(true) {}

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

  void lead(double feed_mm, bool runs) {
    acts_.push_back({.kind = Act::Kind::Lead, .feed_mm = feed_mm, .saw_runs = runs});
  }

  void do_step(std::size_t step) {
    const OperationStep& at_hand = undertaking_.scenario.steps[step];
    switch (at_hand.kind) {
      case StepKind::Cut:
      case StepKind::Trim:
        take_out_temporary();
        saw(index_of_cut(undertaking_.plan, at_hand.cut));
        break;
      case StepKind::Remove:
        say(CommandKind::PickUp, simulator::piece_freed_last);
        break;
      case StepKind::Close:
        say(CommandKind::CloseHinge,
            static_cast<std::int32_t>(index_in(undertaking_.plan.hinges, at_hand.hinge)));
        break;
      case StepKind::Shift:
        take_out_temporary();
        shift(index_in(undertaking_.plan.fixation.shifts, at_hand.shift));
        break;
      case StepKind::GuideWire:
      case StepKind::TemporaryWire:
      case StepKind::Fix:
        for (const std::string& name : at_hand.implants)
          set(index_in(undertaking_.plan.fixation.implants, name));
        if (at_hand.kind == StepKind::Fix) take_out_temporary();
        break;
      default:
        break;
    }
    wait(at_hand.kind == StepKind::Verify ? 1.0 : 0.5);
    const bool leaves_waste = at_hand.kind == StepKind::Remove || at_hand.kind == StepKind::Trim;
    if (leaves_waste) acts_.push_back({.kind = Act::Kind::TakeRest, .waste_of = waste_of(at_hand)});
    say(CommandKind::StepDone, static_cast<std::int32_t>(step));
  }

  /// The step's cut, or both of its hinge.
  std::uint32_t waste_of(const OperationStep& step) const {
    const Plan& plan = undertaking_.plan;
    const auto bit_of = [&](const std::string& cut) { return 1U << index_of_cut(plan, cut); };
    const PlannedHinge* const hinge = find_hinge(plan, step.hinge);
    return hinge == nullptr ? bit_of(step.cut)
                            : bit_of(hinge->first_cut) | bit_of(hinge->second_cut);
  }

  void take_tool(std::int32_t place) {
    if (place == tool_) return;
    say(CommandKind::ChooseTool, place);
    wait(settle_s);
    tool_ = place;
  }

  void saw(std::size_t cut) {
    const HandSkill& skill = undertaking_.skill;
    if (!is_at_first_cut_ || cut != first_cut_)
      acts_.push_back(turn_to_cut(undertaking_, cut, turn_hovers));
    take_tool(blade_for(undertaking_, cut));
    const std::string& name = undertaking_.plan.cuts[cut].name;
    Random jitter(undertaking_.seed, cut == 0 ? "hand.strokes" : "hand.strokes." + name);
    const std::vector<Stroke> strokes = strokes_of(undertaking_, cut);
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      Act act{.kind = Act::Kind::Saw, .stroke = strokes[i]};
      // The first stroke makes the plane; later ones come back to it as well as the hand can.
      if (i > 0) {
        act.jitter_mm = jitter.truncated_normal(0.0, skill.stroke_jitter_mm);
        act.jitter_rad = jitter.truncated_normal(0.0, skill.stroke_jitter_rad);
      } else if (cut == first_cut_) {
        act.stroke.restarts =
            static_cast<std::int32_t>(fault_size(skill.faults, FaultKind::Restarts));
      }
      acts_.push_back(act);
      idle();
    }
  }

  /// In front of an implant's entry, its axis the feed.
  void turn_to(const AimedImplant& aimed) {
    is_at_first_cut_ = false;
    acts_.push_back({.kind = Act::Kind::TurnTo,
                     .bone_from_blade = aimed.bone_from_axis,
                     .feed_mm = -turn_hovers * hover_mm});
  }

  void bore(const AimedImplant& aimed, bool ends_seated) {
    acts_.push_back(
        {.kind = Act::Kind::Bore, .bore = {-before_entry_mm, aimed.depth_mm, ends_seated}});
  }

  /// A screw after its drill; the driver lets go of what stands in bone, and is drawn away.
  void set(std::size_t implant) {
    AimedImplant aimed = aim_implant(undertaking_.scenario, undertaking_.plan, implant,
                                     undertaking_.skill, undertaking_.seed);
    aimed.bone_from_axis = in_first(undertaking_, undertaking_.plan.fixation.implants[implant].bone,
                                    aimed.bone_from_axis);
    turn_to(aimed);
    if (aimed.drill) {
      take_tool(*aimed.drill);
      bore(aimed, false);
      lead(-turn_hovers * hover_mm, true);
      lead(-turn_hovers * hover_mm, false);
    }
    take_tool(aimed.tool);
    bore(aimed, aimed.drill.has_value());
    say(CommandKind::LeaveImplant);
    wait(settle_s);
    lead(-turn_hovers * hover_mm, false);
    idle();
    if (undertaking_.plan.fixation.implants[implant].is_temporary)
      to_take_out_.push_back({aimed, left_count_});
    ++left_count_;
  }

  /// Wires that have done what they were set for, each by its own driver along its own axis.
  void take_out_temporary() {
    for (const StandingWire& wire : to_take_out_) {
      turn_to(wire.aimed);
      take_tool(wire.aimed.tool);
      say(CommandKind::TakeImplant, wire.number);
      wait(settle_s);
      lead(-(turn_hovers + 1.0) * hover_mm - wire.aimed.depth_mm, false);
      // It still stands as far ahead of the hand as it did in the bone.
      take_tool(0);
    }
    to_take_out_.clear();
  }

  /// Holds the fragment, leads it, drives it home and lets it go.
  void shift(std::size_t index) {
    const Plan& plan = undertaking_.plan;
    const PlannedShift& planned = plan.fixation.shifts[index];
    const PlannedFragment& fragment = *find_fragment(plan.fixation, planned.fragment);
    const RigidTransform led = aim_shift(plan, index, undertaking_.skill, undertaking_.seed);
    Act hold = turn_to_cut(undertaking_, first_cut_, far_hovers);
    acts_.push_back(hold);
    acts_.push_back({.kind = Act::Kind::Grip,
                     .near_in_bone_mm = fragment.holds_in_bone_mm,
                     .near_bone = fragment.bone});
    wait(settle_s);
    hold.bone_from_blade = led_in_first(led, fragment.bone) * hold.bone_from_blade;
    hold.speed_mm_s = carry_mm_s;
    acts_.push_back(hold);
    wait(carried_s);
    if (planned.is_closed) {
      say(CommandKind::Impact);
      wait(impact_s);
    }
    say(CommandKind::Release);
    wait(settle_s);
    is_at_first_cut_ = false;
  }

  /// A way that is said in the frame of one of the bones.
  RigidTransform led_in_first(const RigidTransform& led, std::size_t bone) const {
    if (bone == 0) return led;
    const RigidTransform first_from_bone = first_from(undertaking_.bones, bone);
    return first_from_bone * led * inverse(first_from_bone);
  }

  void touch_zones() {
    for (const HandFault& fault : undertaking_.skill.faults) {
      if (fault.kind == FaultKind::TouchZone) touch_zone(fault);
    }
  }

  /// There through the air, in with the saw running, out, and back in front of the first cut.
  void touch_zone(const HandFault& fault) {
    const Act home = turn_to_cut(undertaking_, first_cut_, turn_hovers);
    const ZoneTouch touch =
        plan_touch(undertaking_.bones, undertaking_.plan, undertaking_.scenario.saw.blade,
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

  /// A wire that comes out again, and its number as an implant.
  struct StandingWire {
    AimedImplant aimed;
    std::int32_t number = 0;
  };

  const Undertaking& undertaking_;
  std::size_t first_cut_;
  /// On the tray, in the hand.
  std::int32_t tool_;
  /// The hand has not left the place in front of the first cut.
  bool is_at_first_cut_;
  std::vector<StandingWire> to_take_out_;
  std::int32_t left_count_ = 0;
  std::vector<Act> acts_;
};

}  // namespace

std::vector<std::size_t> steps_to_do(const Scenario& scenario, const HandSkill& skill) {
  std::vector<std::size_t> steps, cuts;
  std::set<std::string_view> chosen;
  for (std::size_t step = 0; step < scenario.steps.size(); ++step) {
    const std::string& group = scenario.steps[step].one_of;
    if (!group.empty() && !chosen.insert(group).second) continue;
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

// Errors are what the read-outs say less where they should be; each move of the hand changes them
// by a known amount, and the move that leaves least is asked for (matching pursuit). So the hint
// suits any view: seen from elsewhere the same error is mended by another key.
#include "ui/screens/operating/coach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "scenarios/planned_guide.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/elementary.h"
#include "simulator/base/units.h"
#include "ui/screens/operating/fixation_hints.h"
#include "ui/screens/operating/hand/steering.h"
#include "ui/screens/operating/hud/operating_hud.h"
#include "ui/screens/operating/levers.h"
#include "ui/screens/pictures/rotation_vector.h"

namespace hallux::ui {

namespace {

using scenarios::HeldCut;
using scenarios::PlannedCut;
using scenarios::PlannedPasses;
using scenarios::StepKind;

/// Within these nothing more is asked.
constexpr double tilt_good_rad = 0.0079, offset_good_mm = 0.25, along_good_mm = 0.5;
/// A push that would move the blade, were it free.
constexpr double caught_newton = 2.0;
/// What is left of a cut is to lie so far inside the ends of the tooth line.
constexpr double inside_mm = 0.75;
/// Teeth that cut are not called back for less along the cut.
constexpr double along_at_work_mm = 2.0;
/// Nearer to bone the saw is not moved aside, and may be a little less right: who aimed well in air
/// is not called back for a push that went a little aside.
constexpr double clear_mm = 1.0, slack_at_bone = 1.7;
/// What stands at bone is drawn back so far before it is moved aside.
constexpr double clear_by_mm = 3.0;
/// Out of the bone again: so far before the cut's entry.
constexpr double out_mm = -2.0;
/// Before a hinge pushes are gentler, which stop in time, and before the far side they are eased.
constexpr double gentle_from_mm = 3.0, before_hinge_mm = 0.5, done_mm = 0.15;
/// A strip before the hinge's stop that is not worth a push where the cut holds elsewhere, or
/// nowhere.
constexpr double strip_mm = 1.2;
/// Beyond what holds deepest the teeth go so far before the stroke counts as through.
constexpr double crumb_mm = 0.3;
constexpr double at_bone_mm = 0.6, pushed_at_once_mm = 4.0;
/// Where the best move mends less, the view looks along what is to be mended.
constexpr double least_mended_share = 0.02;
/// A turn in the face counts less: it tilts no wall, and only moves the teeth aside as they go in.
constexpr double yaw_weight = 0.5, yaw_good_rad = 0.035;

/// Where the middle of the blade is to lie; the normal looks to the waste.
struct GoalPlane {
  Vec3 normal{0.0, 0.0, 1.0};
  double offset_mm = 0.0;
};

/// The cut at hand with all that is known of it.
struct Aim {
  const PlannedCut& cut;
  const PlannedPasses& passes;
  const HeldCut* held = nullptr;
  GoalPlane goal;
  /// Of the pass to be sawn, from the entry along the tooth line.
  double middle_mm = 0.0;
  const scenarios::PlannedHinge* hinge = nullptr;
};

GoalPlane goal_of(const CoachView& view, const PlannedCut& cut, const HeldCut* held) {
  const Vec3& waste = cut.face.normal;
  if (held == nullptr || !held->is_begun())
    return {waste, cut.face.offset_mm + 0.5 * blade_of(view).kerf_mm};
  const RigidTransform bone_from_kerf = held->bone_from_kerf_now();
  const Vec3 normal = axis_z(bone_from_kerf);
  const Vec3 to_waste = glm::dot(normal, waste) < 0.0 ? -normal : normal;
  return {to_waste, glm::dot(to_waste, bone_from_kerf.translation_mm)};
}

double nearest_middle_mm(const PlannedPasses& passes, double wanted_mm) {
  return *std::min_element(
      passes.middles_mm.begin(), passes.middles_mm.end(),
      [&](double a, double b) { return std::abs(a - wanted_mm) < std::abs(b - wanted_mm); });
}

/// Before the first pass the nearest; then the one over the place that holds deepest, moved on
/// where its ends would only graze that.
double middle_of_pass(const CoachView& view, const PlannedCut& cut, const PlannedPasses& passes,
                      const HeldCut* held) {
  const auto along_mm = [&](const Vec3& place_mm) {
    return glm::dot(passes.along_in_bone, place_mm - cut.entry_point_in_bone_mm);
  };
  if (held == nullptr || !held->is_begun())
    return nearest_middle_mm(passes, along_mm(view.bone_from_tool.translation_mm));
  const double deepest_mm = along_mm(held->deepest_in_bone_mm);
  const double reach_mm = 0.5 * blade_of(view).width_mm - inside_mm;
  return std::clamp(nearest_middle_mm(passes, deepest_mm), deepest_mm - reach_mm,
                    deepest_mm + reach_mm);
}

Aim aim_at(const CoachView& view, const PlannedCut& cut) {
  const std::size_t index = index_of_cut(view.plan, cut.name);
  const HeldCut* held =
      view.site != nullptr && index < view.site->cuts.size() ? &view.site->cuts[index] : nullptr;
  const PlannedPasses& passes = view.passes[index];
  return {cut,
          passes,
          held,
          goal_of(view, cut, held),
          middle_of_pass(view, cut, passes, held),
          find_hinge(view.plan, cut.hinge)};
}

std::string degree_text(double rad) { return signed_text(degree_from_radian(rad)) + "°"; }
std::string mm_text(double mm) { return signed_text(mm) + " mm"; }

/// Of the blade against the goal, as PlanReading against the plan.
struct Tilt {
  double pitch_rad = 0.0, roll_rad = 0.0, side = 1.0;
};

Tilt tilt_off(const CoachView& view, const Aim& aim) {
  const Vec3 feed = axis_x(view.bone_from_tool), along = axis_y(view.bone_from_tool);
  Tilt tilt;
  tilt.side = glm::dot(axis_z(view.bone_from_tool), aim.goal.normal) < 0.0 ? -1.0 : 1.0;
  tilt.pitch_rad = elementary::asin(glm::dot(aim.goal.normal, feed));
  tilt.roll_rad = elementary::asin(tilt.side * glm::dot(aim.goal.normal, along));
  return tilt;
}

/// The blade as it is to lie, by the axes of its pass; z of the blade, so on its own side.
struct Wanted {
  Vec3 feed, along, normal;
};

Wanted wanted_pose(const Aim& aim, double side) {
  const Vec3 normal = side * aim.goal.normal;
  const Vec3& planned = aim.passes.feed_in_bone;
  const Vec3 feed = unit(planned - glm::dot(planned, normal) * normal);
  return {feed, glm::cross(normal, feed), normal};
}

/// The turn from the blade as it is held to the blade as it is to lie.
Vec3 turn_left_rad(const CoachView& view, const Wanted& wanted) {
  return rotation_vector(rotation_from_axes(wanted.feed, wanted.along) *
                         glm::conjugate(view.bone_from_tool.rotation));
}

/// The turn that leaves least, told along the axes of the blade as it is to lie: the read-outs bend
/// where much is left, and one who follows them from there turns in circles.
Chosen best_turn(const CoachView& view, const Wanted& wanted) {
  const auto told = [&](const Vec3& turn) {
    return std::array<double, 3>{glm::dot(turn, wanted.feed), glm::dot(turn, wanted.along),
                                 yaw_weight * glm::dot(turn, wanted.normal)};
  };
  const auto levers =
      turning_levers<3>(view.bone_from_view, [&](const Vec3& axis) { return told(-axis); });
  return best_move<3>(told(turn_left_rad(view, wanted)), levers);
}

Hint tilted_hint(const Tilt& off, const PlanReading& reading) {
  Hint hint{.text_id = "operate.hint.tilt"};
  hint.values = {{"pitch", degree_text(reading.pitch_rad)},
                 {"roll", degree_text(reading.roll_rad)},
                 {"pitch_goal", degree_text(reading.pitch_rad - off.pitch_rad)},
                 {"roll_goal", degree_text(reading.roll_rad - off.roll_rad)}};
  hint.read_outs = {"plan.pitch", "plan.roll"};
  return hint;
}

/// No read-out tells it, so the sentence does.
Hint turned_hint(double yaw_rad) {
  Hint hint{.text_id = "operate.hint.turned"};
  hint.values = {{"turned", degree_text(yaw_rad)}};
  return hint;
}

std::optional<Hint> tilt_hint(const CoachView& view, const Aim& aim, const PlanReading& reading,
                              double slack) {
  const Tilt off = tilt_off(view, aim);
  const Wanted wanted = wanted_pose(aim, off.side);
  const double yaw_rad = -glm::dot(turn_left_rad(view, wanted), wanted.normal);
  const bool is_tilted = std::hypot(off.pitch_rad, off.roll_rad) >= slack * tilt_good_rad;
  if (!is_tilted && std::abs(yaw_rad) < slack * yaw_good_rad) return std::nullopt;
  Hint hint = is_tilted ? tilted_hint(off, reading) : turned_hint(yaw_rad);
  set_amount(hint, best_turn(view, wanted), key_turn_rad);
  return hint;
}

Hint turn_view_hint() {
  Hint hint{.text_id = "operate.hint.view"};
  hint.move = HandMove::ResetView;
  return hint;
}

std::optional<Hint> place_hint(const CoachView& view, const Aim& aim, const PlanReading& reading,
                               double slack) {
  const Vec3& tip_mm = view.bone_from_tool.translation_mm;
  const double off_mm = glm::dot(aim.goal.normal, tip_mm) - aim.goal.offset_mm;
  const double along_mm =
      glm::dot(aim.passes.along_in_bone, tip_mm - aim.cut.entry_point_in_bone_mm) - aim.middle_mm;
  const double along_slack_mm = view.is_touching ? along_at_work_mm : slack * along_good_mm;
  if (std::abs(off_mm) < slack * offset_good_mm && std::abs(along_mm) < along_slack_mm)
    return std::nullopt;
  const auto levers = levers_across<2>(view.bone_from_view, [&](const Vec3& way) {
    return std::array<double, 2>{glm::dot(aim.goal.normal, way),
                                 glm::dot(aim.passes.along_in_bone, way)};
  });
  Hint hint{.text_id = "operate.hint.place"};
  hint.values = {{"offset", mm_text(reading.distance_mm)},
                 {"offset_goal", mm_text(reading.distance_mm - off_mm)},
                 {"along", mm_text(along_mm)}};
  hint.read_outs = {"plan.distance", "plan.along"};
  const Chosen chosen = best_move<2>({off_mm, along_mm}, levers);
  if (chosen.mended_share < least_mended_share) return turn_view_hint();
  set_amount(hint, chosen, key_step_mm);
  return hint;
}

/// Keeps the push within its limits; the blade does the rest.
Hint push_hint(const CoachView& view, const PushRange& push, const std::string& left) {
  Hint hint{.text_id = left.empty() ? "operate.hint.saw" : "operate.hint.saw_left"};
  hint.values = {{"force", decimal_text(view.force_newton) + " N"},
                 {"least", decimal_text(push.least_newton)},
                 {"most", decimal_text(push.most_newton) + " N"},
                 {"left", left}};
  hint.push = push;
  hint.read_outs = {"force", "ahead"};
  if (view.force_newton < push.least_newton) {
    hint.move = HandMove::Push;
    hint.times = std::max(1, static_cast<int>(std::lround(push.least_newton - view.force_newton)));
  } else if (view.force_newton > push.most_newton) {
    hint.move = HandMove::DrawBack;
    hint.times = std::max(1, static_cast<int>(std::lround(view.force_newton - push.most_newton)));
  }
  return hint;
}

bool is_through(const Aim& aim) { return aim.held != nullptr && aim.held->is_through(); }

/// What still holds most is before these teeth.
bool is_deepest_ahead(const CoachView& view, const Aim& aim) {
  if (aim.held == nullptr) return true;
  const Vec3 away_mm = aim.held->deepest_in_bone_mm - view.bone_from_tool.translation_mm;
  return std::abs(glm::dot(aim.passes.along_in_bone, away_mm)) < 0.5 * blade_of(view).width_mm;
}

/// Of the bone ahead, what is to be sawn: on to the far side, or to just before the hinge. Nothing
/// where the teeth have opened all of it, also where they were drawn back since.
std::optional<double> left_to_saw_mm(const CoachView& view, const Aim& aim) {
  const simulator::BladeAhead& ahead = view.site->ahead;
  if (aim.hinge == nullptr || !ahead.to_bone_mm) return ahead.to_far_side_mm;
  const std::optional<double> hinge_mm = way_to_hinge_mm(*aim.hinge, view.bone_from_tool);
  const double left_mm = hinge_mm.value_or(0.0) - before_hinge_mm;
  // Who is at it saws all of it; who was drawn back comes again only for what holds.
  const bool is_at_it = *ahead.to_bone_mm < at_bone_mm;
  const bool is_meant = is_at_it || (is_deepest_ahead(view, aim) && !is_through(aim));
  const double least_mm = is_meant ? done_mm : strip_mm;
  if (*ahead.to_bone_mm > left_mm - least_mm) return std::nullopt;
  return left_mm;
}

/// Right before the teeth something stands that is smaller than what is asked between them.
bool is_crumb_ahead(const CoachView& view, const Aim& aim) {
  if (aim.held == nullptr || !is_deepest_ahead(view, aim)) return false;
  const Vec3 away_mm = aim.held->deepest_in_bone_mm - view.bone_from_tool.translation_mm;
  return glm::dot(aim.passes.feed_in_bone, away_mm) > -crumb_mm;
}

PushRange stroke_push(const Aim& aim, double left_mm) {
  if (left_mm >= gentle_from_mm) return usual_push;
  return aim.hinge != nullptr ? gentle_push : easing_push;
}

/// In a kerf: on, until the stroke is through or at the hinge; then out.
Hint stroke_hint(const CoachView& view, const Aim& aim) {
  std::optional<double> left_mm = left_to_saw_mm(view, aim);
  if (!left_mm && aim.hinge == nullptr && is_crumb_ahead(view, aim)) left_mm = crumb_mm;
  if (!left_mm) {
    const double depth_mm = read_passes(aim.cut, aim.passes, view.bone_from_tool).depth_mm;
    return draw_back_hint(aim.hinge == nullptr ? "operate.hint.through" : "operate.hint.at_hinge",
                          depth_mm - out_mm);
  }
  const std::string left = decimal_text(*left_mm) + " mm";
  return push_hint(view, stroke_push(aim, *left_mm), left);
}

Hint approach_hint(double to_bone_mm) {
  Hint hint{.text_id = "operate.hint.approach"};
  hint.values = {{"way", decimal_text(to_bone_mm) + " mm"}};
  hint.move = HandMove::Push;
  const double way_mm = to_bone_mm > pushed_at_once_mm ? to_bone_mm - 2.0 : to_bone_mm;
  hint.times = std::max(1, static_cast<int>(std::lround(way_mm / key_step_mm)));
  hint.read_outs = {"ahead"};
  return hint;
}

/// Pushed, and yet the teeth touch nothing: a face of the blade rests on the rim of its own kerf,
/// or a corner of it on an edge of the bone.
bool is_caught(const CoachView& view) {
  return !view.is_touching && view.force_newton > caught_newton &&
         view.site->ahead.beside_mm < clear_mm;
}

/// A little aside, under the push: across its kerf the blade finds its slot, and along the cut, to
/// the middle of it, its teeth find bone. A saw that stands finds neither at an edge of the bone.
Hint caught_hint(const CoachView& view, const Aim& aim) {
  const Vec3& tip_mm = view.bone_from_tool.translation_mm;
  const bool is_in_slot = aim.held != nullptr && aim.held->is_begun();
  if (!is_in_slot && !view.is_saw_on) return draw_back_hint("operate.hint.clear", clear_by_mm);
  const Vec3& aside = is_in_slot ? aim.goal.normal : aim.passes.along_in_bone;
  const double middle_mm = glm::dot(aside, aim.cut.entry_point_in_bone_mm) +
                           0.5 * (aim.passes.low_mm + aim.passes.high_mm);
  const double off_mm = glm::dot(aside, tip_mm) - (is_in_slot ? aim.goal.offset_mm : middle_mm);
  const auto levers = levers_across<1>(
      view.bone_from_view, [&](const Vec3& way) { return std::array{glm::dot(aside, way)}; });
  Hint hint{.text_id = is_in_slot ? "operate.hint.caught" : "operate.hint.caught_corner"};
  hint.read_outs = {is_in_slot ? "plan.distance" : "plan.along"};
  Chosen chosen = best_move<1>({off_mm}, levers);
  chosen.amount = simulator::fine_share * key_step_mm;
  set_amount(hint, chosen, key_step_mm);
  return hint;
}

/// Outside a kerf: first out of the bone's way, then tilt, place, saw, and on to the bone.
Hint aiming_hint(const CoachView& view, const Aim& aim) {
  const PlanReading reading = read_against(aim.cut, blade_of(view), view.bone_from_tool);
  const simulator::BladeAhead& ahead = view.site->ahead;
  const bool is_at_bone = ahead.beside_mm < clear_mm;
  const double slack = is_at_bone ? slack_at_bone : 1.0;
  if (is_caught(view)) return caught_hint(view, aim);
  const std::optional<Hint> tilt = tilt_hint(view, aim, reading, slack);
  const std::optional<Hint> place = place_hint(view, aim, reading, slack);
  if ((tilt || place) && is_at_bone) return draw_back_hint("operate.hint.clear", clear_by_mm);
  if (tilt) return *tilt;
  if (place) return *place;
  if (!view.is_saw_on && !view.is_irrigated)
    return switch_hint("operate.hint.water_on", HandMove::SwitchWater);
  if (!view.is_saw_on) return switch_hint("operate.hint.saw_on");
  const double depth_mm = read_passes(aim.cut, aim.passes, view.bone_from_tool).depth_mm;
  if (!ahead.to_bone_mm && depth_mm > out_mm && !is_crumb_ahead(view, aim))
    return draw_back_hint("operate.hint.clear", depth_mm - out_mm + 1.0);
  const double way_mm = ahead.to_bone_mm.value_or(-depth_mm);
  if (way_mm > at_bone_mm) return approach_hint(way_mm);
  return push_hint(view, usual_push, {});
}

Hint cut_hint(const CoachView& view, const PlannedCut& cut) {
  const Aim aim = aim_at(view, cut);
  if (view.is_in_kerf && !is_through(aim) && !view.is_saw_on)
    return switch_hint("operate.hint.saw_on");
  if (view.is_in_kerf) return stroke_hint(view, aim);
  if (is_through(aim)) return press_hint("operate.hint.cut_done");
  if (view.site->is_blade_in_bone && !view.is_touching)
    return draw_back_hint("operate.hint.not_held", blade_of(view).depth_mm);
  return aiming_hint(view, aim);
}

/// The first done step whose cut still holds.
std::optional<std::size_t> step_that_holds(const CoachView& view) {
  for (std::size_t step = 0; step < view.scenario.steps.size(); ++step) {
    const scenarios::OperationStep& done = view.scenario.steps[step];
    if (done.kind != StepKind::Cut || !view.steps.can_reopen(step)) continue;
    const std::size_t index = index_of_cut(view.plan, done.cut);
    if (index < view.site->cuts.size() && !view.site->cuts[index].is_through()) return step;
  }
  return std::nullopt;
}

Hint take_up_hint(const CoachView& view, std::size_t step) {
  Hint hint{.text_id = "operate.hint.take_up"};
  hint.values = {{"number", std::to_string(step + 1)}, {"step", view.scenario.steps[step].title}};
  hint.move = HandMove::TakeUpStep;
  hint.read_outs = {"step"};
  return hint;
}

/// Nothing where the pieces are known and nothing that holds is seen: why the button is off tells
/// that.
std::optional<Hint> freeing_hint(const CoachView& view) {
  if (view.is_in_kerf) return draw_back_hint("operate.hint.draw_out", 30.0);
  if (const std::optional<std::size_t> held = step_that_holds(view))
    return take_up_hint(view, *held);
  if (!view.site->are_pieces_due) return std::nullopt;
  return Hint{.text_id = "operate.hint.wait"};
}

std::optional<Hint> removal_hint(const CoachView& view) {
  if (view.steps.is_ready()) return press_hint("operate.hint.take_out");
  return freeing_hint(view);
}

/// Of a step that is done by a word; empty for the others.
std::string_view word_of(StepKind kind) noexcept {
  switch (kind) {
    case StepKind::Verify:
      return "operate.hint.verify";
    case StepKind::Close:
      return "operate.hint.close";
    case StepKind::Finish:
      return "operate.hint.finish";
    case StepKind::Mark:
      return "operate.hint.mark";
    case StepKind::Retract:
      return "operate.hint.retract";
    case StepKind::Complete:
      return "operate.hint.complete";
    default:
      return {};
  }
}

bool is_of_implants(StepKind kind) noexcept {
  return kind == StepKind::GuideWire || kind == StepKind::TemporaryWire || kind == StepKind::Fix;
}

/// While no fragment is free, the cut that holds it.
std::optional<Hint> shift_step_hint(const CoachView& view) {
  if (std::optional<Hint> hint = shift_hint(view)) return hint;
  return freeing_hint(view);
}

/// The planned blade comes into the hand, and wires that are done with come out first.
std::optional<Hint> hand_hint(const CoachView& view, const PlannedCut& cut) {
  if (view.tools == nullptr || view.tools->tray().size() < 2 || view.is_in_kerf)
    return std::nullopt;
  if (std::optional<Hint> wire = temporary_wire_hint(view)) return wire;
  return tool_hint(view, blade_place(cut));
}

}  // namespace

const PlannedCut* cut_of_step(const CoachView& view) {
  return cut_at_step(view.scenario, view.plan, view.steps.step());
}

std::optional<std::size_t> step_to_take_up(const CoachView& view) {
  if (view.site != nullptr && view.steps.kind() == StepKind::Remove) {
    if (const std::optional<std::size_t> held = step_that_holds(view)) return held;
  }
  for (std::size_t step = view.steps.step(); step-- > 0;)
    if (view.steps.can_reopen(step)) return step;
  return std::nullopt;
}

std::optional<Hint> next_hint(const CoachView& view) {
  if (view.is_paused) return std::nullopt;
  const std::optional<StepKind> kind = view.steps.kind();
  if (!kind || view.steps.is_waiting()) return std::nullopt;
  if (const std::string_view word = word_of(*kind); !word.empty()) return press_hint(word);
  if (view.site == nullptr) return std::nullopt;
  if (*kind == StepKind::Remove) return removal_hint(view);
  if (view.tools != nullptr && !view.tools->tray().empty()) {
    if (is_of_implants(*kind)) return implant_hint(view);
    if (*kind == StepKind::Shift) return shift_step_hint(view);
  }
  const PlannedCut* cut = cut_of_step(view);
  if (cut == nullptr) return std::nullopt;
  if (std::optional<Hint> hint = hand_hint(view, *cut)) return hint;
  return cut_hint(view, *cut);
}

const simulator::Blade& blade_of(const CoachView& view) noexcept {
  const simulator::Saw* const saw = view.tools == nullptr ? nullptr : view.tools->saw();
  return saw == nullptr ? view.scenario.saw.blade : saw->blade;
}

}  // namespace hallux::ui

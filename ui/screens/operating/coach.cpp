// Errors are what the read-outs say less where they should be; each move of the hand changes them
// by a known amount, and the move that leaves least is asked for (matching pursuit). So the hint
// suits any view: seen from elsewhere the same error is mended by another key.
#include "ui/screens/operating/coach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "scenarios/planned_guide.h"
#include "simulator/base/elementary.h"
#include "simulator/base/units.h"
#include "ui/screens/operating/hand/steering.h"
#include "ui/screens/operating/hud/operating_hud.h"

namespace hallux::ui {

namespace {

using scenarios::HeldCut;
using scenarios::PlannedCut;
using scenarios::PlannedPasses;
using scenarios::StepKind;
using Led = simulator::SteeredDevice::Led;

/// Within these nothing more is asked.
constexpr double tilt_good_rad = 0.0079, offset_good_mm = 0.25, along_good_mm = 0.5;
/// What is left of a cut is to lie so far inside the ends of the tooth line.
constexpr double inside_mm = 0.75;
/// Nearer to bone the saw is not moved aside, and may be a little less right: who aimed well in air
/// is not called back for a push that went a little aside.
constexpr double clear_mm = 1.0, slack_at_bone = 1.7;
/// Out of the bone again: so far before the cut's entry.
constexpr double out_mm = -2.0;
/// Before a hinge pushes are gentler, which stop in time.
constexpr double gentle_from_mm = 3.0, before_hinge_mm = 0.5, done_mm = 0.15;
/// A strip before the hinge's stop that is not worth a push where the cut holds elsewhere, or
/// nowhere.
constexpr double strip_mm = 1.2;
/// Beyond what holds deepest the teeth go so far before the stroke counts as through.
constexpr double crumb_mm = 0.3;
/// Of a key's step: below, Shift is held.
constexpr double fine_below = 0.6;
constexpr double at_bone_mm = 0.6, pushed_at_once_mm = 4.0;
/// Where the best move mends less, the view looks along what is to be mended.
constexpr double least_mended_share = 0.02;
/// A turn in the face counts less: no read-out tells it.
constexpr double yaw_weight = 0.5;

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

/// One move, and what a step of it does to the errors.
template <std::size_t count>
struct Lever {
  HandMove more, less;
  std::array<double, count> change;
};

/// The move that leaves least of the errors, how much of it, and what share of them it mends.
struct Chosen {
  HandMove move = HandMove::Wait;
  double amount = 0.0, mended_share = 0.0;
};

template <std::size_t count>
Chosen best_move(const std::array<double, count>& errors, std::span<const Lever<count>> levers) {
  Chosen chosen;
  double most = 0.0, all = 0.0;
  for (const double error : errors) all += error * error;
  for (const Lever<count>& lever : levers) {
    double along = 0.0, size = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      along += errors[i] * lever.change[i];
      size += lever.change[i] * lever.change[i];
    }
    if (!(size > 1.0e-6) || along * along / size <= most) continue;
    most = along * along / size;
    const double amount = -along / size;
    chosen = {amount > 0.0 ? lever.more : lever.less, std::abs(amount), most / all};
  }
  return chosen;
}

/// As key presses: fine ones where little is left.
void set_amount(Hint& hint, const Chosen& chosen, double key_step) {
  hint.move = chosen.move;
  hint.is_fine = chosen.amount < fine_below * key_step;
  const double step = hint.is_fine ? simulator::fine_share * key_step : key_step;
  hint.times = std::max(1, static_cast<int>(std::lround(chosen.amount / step)));
}

GoalPlane goal_of(const CoachView& view, const PlannedCut& cut, const HeldCut* held) {
  const Vec3& waste = cut.face.normal;
  if (held == nullptr || !held->is_begun())
    return {waste, cut.face.offset_mm + 0.5 * view.scenario.saw.blade.kerf_mm};
  const Vec3 normal = axis_z(held->bone_from_kerf);
  const Vec3 to_waste = glm::dot(normal, waste) < 0.0 ? -normal : normal;
  return {to_waste, glm::dot(to_waste, held->bone_from_kerf.translation_mm)};
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
  const double reach_mm = 0.5 * view.scenario.saw.blade.width_mm - inside_mm;
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
  double pitch_rad = 0.0, roll_rad = 0.0, yaw_rad = 0.0, side = 1.0;
};

Tilt tilt_off(const CoachView& view, const Aim& aim) {
  const Vec3 feed = axis_x(view.bone_from_tool), along = axis_y(view.bone_from_tool);
  Tilt tilt;
  tilt.side = glm::dot(axis_z(view.bone_from_tool), aim.goal.normal) < 0.0 ? -1.0 : 1.0;
  tilt.pitch_rad = elementary::asin(glm::dot(aim.goal.normal, feed));
  tilt.roll_rad = elementary::asin(tilt.side * glm::dot(aim.goal.normal, along));
  tilt.yaw_rad = elementary::asin(std::clamp(glm::dot(aim.passes.along_in_bone, feed), -1.0, 1.0));
  return tilt;
}

std::optional<Hint> tilt_hint(const CoachView& view, const Aim& aim, const PlanReading& reading,
                              double slack) {
  const Tilt off = tilt_off(view, aim);
  if (std::hypot(off.pitch_rad, off.roll_rad) < slack * tilt_good_rad) return std::nullopt;
  const Vec3 feed = axis_x(view.bone_from_tool), along = axis_y(view.bone_from_tool);
  const auto change_of = [&](const Vec3& axis_in_view) {
    const Vec3 axis = view.bone_from_view * axis_in_view;
    return std::array<double, 3>{
        glm::dot(aim.goal.normal, glm::cross(axis, feed)),
        off.side * glm::dot(aim.goal.normal, glm::cross(axis, along)),
        yaw_weight * glm::dot(aim.passes.along_in_bone, glm::cross(axis, feed))};
  };
  const std::array<Lever<3>, 3> levers{
      {{HandMove::TurnRight, HandMove::TurnLeft, change_of(Vec3(0.0, 1.0, 0.0))},
       {HandMove::TurnDown, HandMove::TurnUp, change_of(Vec3(1.0, 0.0, 0.0))},
       {HandMove::RollLeft, HandMove::RollRight, change_of(Vec3(0.0, 0.0, 1.0))}}};
  Hint hint{.text_id = "operate.hint.tilt"};
  hint.values = {{"pitch", degree_text(reading.pitch_rad)},
                 {"roll", degree_text(reading.roll_rad)},
                 {"pitch_goal", degree_text(reading.pitch_rad - off.pitch_rad)},
                 {"roll_goal", degree_text(reading.roll_rad - off.roll_rad)}};
  hint.read_outs = {"plan.pitch", "plan.roll"};
  const std::array errors{off.pitch_rad, off.roll_rad, yaw_weight * off.yaw_rad};
  set_amount(hint, best_move<3>(errors, levers), key_turn_rad);
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
  if (std::abs(off_mm) < slack * offset_good_mm && std::abs(along_mm) < slack * along_good_mm)
    return std::nullopt;
  const auto change_of = [&](const Vec3& axis_in_view) {
    const Vec3 axis = view.bone_from_view * axis_in_view;
    return std::array<double, 2>{glm::dot(aim.goal.normal, axis),
                                 glm::dot(aim.passes.along_in_bone, axis)};
  };
  const std::array<Lever<2>, 2> levers{
      {{HandMove::Right, HandMove::Left, change_of(Vec3(1.0, 0.0, 0.0))},
       {HandMove::Up, HandMove::Down, change_of(Vec3(0.0, 1.0, 0.0))}}};
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
  return std::abs(glm::dot(aim.passes.along_in_bone, away_mm)) <
         0.5 * view.scenario.saw.blade.width_mm;
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
  const bool is_gentle = aim.hinge != nullptr && *left_mm < gentle_from_mm;
  if (is_gentle) return push_hint(view, gentle_push, left);
  return push_hint(view, usual_push, left);
}

Hint saw_on_hint() {
  Hint hint{.text_id = "operate.hint.saw_on"};
  hint.move = HandMove::SwitchSaw;
  return hint;
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

Hint press_hint(std::string_view text_id) {
  Hint hint{.text_id = text_id};
  hint.move = HandMove::PressStep;
  hint.read_outs = {"step"};
  return hint;
}

/// Outside a kerf: first out of the bone's way, then tilt, place, saw, and on to the bone.
Hint aiming_hint(const CoachView& view, const Aim& aim) {
  const PlanReading reading = read_against(aim.cut, view.scenario.saw.blade, view.bone_from_tool);
  const simulator::BladeAhead& ahead = view.site->ahead;
  const bool is_at_bone = ahead.beside_mm < clear_mm;
  const double slack = is_at_bone ? slack_at_bone : 1.0;
  const std::optional<Hint> tilt = tilt_hint(view, aim, reading, slack);
  const std::optional<Hint> place = place_hint(view, aim, reading, slack);
  if ((tilt || place) && is_at_bone) return draw_back_hint("operate.hint.clear", 3.0);
  if (tilt) return *tilt;
  if (place) return *place;
  if (!view.is_saw_on) return saw_on_hint();
  const double depth_mm = read_passes(aim.cut, aim.passes, view.bone_from_tool).depth_mm;
  if (!ahead.to_bone_mm && depth_mm > out_mm && !is_crumb_ahead(view, aim))
    return draw_back_hint("operate.hint.clear", depth_mm - out_mm + 1.0);
  const double way_mm = ahead.to_bone_mm.value_or(-depth_mm);
  if (way_mm > at_bone_mm) return approach_hint(way_mm);
  return push_hint(view, usual_push, {});
}

Hint cut_hint(const CoachView& view, const PlannedCut& cut) {
  const Aim aim = aim_at(view, cut);
  if (view.is_in_kerf && !is_through(aim) && !view.is_saw_on) return saw_on_hint();
  if (view.is_in_kerf) return stroke_hint(view, aim);
  if (is_through(aim)) return press_hint("operate.hint.cut_done");
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
std::optional<Hint> removal_hint(const CoachView& view) {
  if (view.steps.is_ready()) return press_hint("operate.hint.take_out");
  if (view.is_in_kerf) return draw_back_hint("operate.hint.draw_out", 30.0);
  if (const std::optional<std::size_t> held = step_that_holds(view))
    return take_up_hint(view, *held);
  if (!view.site->are_pieces_due) return std::nullopt;
  return Hint{.text_id = "operate.hint.wait"};
}

/// A move in words: by keys, by the mouse, and by the hand that holds a device.
struct MoveTexts {
  HandMove move;
  std::string_view keys_id, mouse_id;
  std::string_view hand_id = {};
  /// A device that turns nothing itself is turned by the window.
  bool is_turn = false;
};

constexpr std::array<MoveTexts, 18> move_texts{{
    {HandMove::Left, "move.left.keys", "move.left.mouse", "move.left.hand"},
    {HandMove::Right, "move.right.keys", "move.right.mouse", "move.right.hand"},
    {HandMove::Up, "move.up.keys", "move.up.mouse", "move.up.hand"},
    {HandMove::Down, "move.down.keys", "move.down.mouse", "move.down.hand"},
    {HandMove::Push, "move.push.keys", "move.push.mouse", "move.push.hand"},
    {HandMove::DrawBack, "move.draw_back.keys", "move.draw_back.mouse", "move.draw_back.hand"},
    {HandMove::TurnLeft, "move.turn_left.keys", "move.turn_left.mouse", "move.turn_left.hand",
     true},
    {HandMove::TurnRight, "move.turn_right.keys", "move.turn_right.mouse", "move.turn_right.hand",
     true},
    {HandMove::TurnUp, "move.turn_up.keys", "move.turn_up.mouse", "move.turn_up.hand", true},
    {HandMove::TurnDown, "move.turn_down.keys", "move.turn_down.mouse", "move.turn_down.hand",
     true},
    {HandMove::RollLeft, "move.roll_left.keys", "move.roll_left.mouse", "move.roll_left.hand",
     true},
    {HandMove::RollRight, "move.roll_right.keys", "move.roll_right.mouse", "move.roll_right.hand",
     true},
    {HandMove::SwitchSaw, "move.saw.keys", "move.saw.mouse"},
    {HandMove::LookAround, "move.look.keys", "move.look.mouse"},
    {HandMove::ResetView, "move.reset_view.keys", "move.reset_view.mouse"},
    {HandMove::PressStep, "move.step.keys", "move.step.mouse"},
    {HandMove::TakeUpStep, "move.take_up.keys", "move.take_up.mouse"},
    {HandMove::Wait, "move.wait", "move.wait"},
}};

/// The hand on the device makes it, not keys and mouse.
bool is_by_hand(const MoveTexts& move, Led led) noexcept {
  if (led == Led::Pose || move.hand_id.empty()) return false;
  return led == Led::Nothing || !move.is_turn;
}

std::string keys_text(const Texts& texts, const Hint& hint, const MoveTexts& move) {
  std::string keys;
  if (hint.is_fine) keys = std::string(texts.text("key.shift")) + "+";
  keys += texts.text(move.keys_id);
  if (hint.times == 1) return keys;
  return texts.say("operate.hint.times", {{"keys", keys}, {"count", std::to_string(hint.times)}});
}

}  // namespace

Hint draw_back_hint(std::string_view text_id, double way_mm) {
  Hint hint{.text_id = text_id};
  hint.values = {{"way", decimal_text(std::max(0.0, way_mm)) + " mm"}};
  hint.move = HandMove::DrawBack;
  hint.times = std::clamp(static_cast<int>(std::ceil(way_mm)), 1, 30);
  hint.read_outs = {"ahead"};
  return hint;
}

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
  if (*kind == StepKind::Verify) return press_hint("operate.hint.verify");
  if (*kind == StepKind::Close) return press_hint("operate.hint.close");
  if (*kind == StepKind::Finish) return press_hint("operate.hint.finish");
  if (view.site == nullptr) return std::nullopt;
  if (*kind == StepKind::Remove) return removal_hint(view);
  const PlannedCut* cut = cut_of_step(view);
  return cut == nullptr ? std::nullopt : std::optional(cut_hint(view, *cut));
}

std::string hint_text(const Texts& texts, const Hint& hint, Led led) {
  std::string what = texts.say(hint.text_id, hint.values);
  const auto* move = std::find_if(move_texts.begin(), move_texts.end(),
                                  [&](const MoveTexts& each) { return each.move == hint.move; });
  if (move == move_texts.end() || hint.move == HandMove::Wait) return what;
  if (is_by_hand(*move, led)) {
    return what + " " +
           texts.say("operate.hint.by_hand", {{"hand", std::string(texts.text(move->hand_id))}});
  }
  return what + " " +
         texts.say("operate.hint.by", {{"keys", keys_text(texts, hint, *move)},
                                       {"mouse", texts.say(move->mouse_id, hint.values)}});
}

}  // namespace hallux::ui

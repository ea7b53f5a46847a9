// As the coach of the saw: errors are what the read-outs say, and the move that leaves least of
// them is asked for. What stands in bone tells what is done: nothing is remembered here.
#include "ui/screens/operating/fixation_hints.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/tray/fitting_tools.h"
#include "simulator/base/elementary.h"
#include "simulator/base/units.h"
#include "ui/screens/operating/hand/steering.h"
#include "ui/screens/operating/hud/operating_hud.h"
#include "ui/screens/operating/levers.h"

namespace hallux::ui {

namespace {

using scenarios::OperationStep;
using scenarios::PlannedImplant;
using scenarios::StepKind;

/// Within these nothing more is asked of an axis in the air, and of one that is at the bone.
constexpr double direction_good_rad = 0.026, entry_good_mm = 0.4, slack_at_bone = 2.0;
/// What stands in bone so near to a plan was meant for it.
constexpr double meant_within_mm = 6.0, meant_within_rad = 0.45, meant_share = 0.5;
/// A hole that ends nearer to the planned tip is deep enough.
constexpr double pilot_short_mm = 1.5;
/// Nearer to the bone the tip is not moved aside; so far before the planned entry it is clear.
constexpr double near_bone_mm = 1.0, clear_mm = -3.5;
constexpr double out_of_hole_mm = 1.0, longest_way_out_mm = 30.0;
constexpr double deep_enough_mm = 0.3, gentle_from_mm = 3.0, approach_mm = 0.6;
/// Of a fragment that is led, and of one that was driven home.
constexpr double led_good_mm = 0.4, home_good_mm = 2.0, turned_good_rad = 0.035;

const OperationStep& step_of(const CoachView& view) {
  return view.scenario.steps[view.steps.step()];
}

bool is_meant_for(const PlannedImplant& planned, const RigidTransform& bone_from_axis) {
  const ImplantReading reading = read_implant(planned, bone_from_axis);
  return reading.entry_mm < meant_within_mm && reading.direction_rad < meant_within_rad;
}

bool is_of_kind(const PlannedImplant& planned, const simulator::Tool& tool) {
  return planned.kind == scenarios::ImplantKind::Wire
             ? std::holds_alternative<simulator::WireDriver>(tool)
             : std::holds_alternative<simulator::Screwdriver>(tool);
}

const simulator::Tool& tool_at(const CoachView& view, std::int32_t place) {
  return view.tools->tray()[static_cast<std::size_t>(place)].tool;
}

bool is_set(const CoachView& view, const PlannedImplant& planned) {
  return std::ranges::any_of(view.site->implants, [&](const StandingImplant& standing) {
    const double depth_mm = read_implant(planned, standing.bone_from_tool).depth_mm;
    return is_of_kind(planned, tool_at(view, standing.tool)) &&
           is_meant_for(planned, standing.bone_from_tool) &&
           depth_mm > meant_share * planned.length_mm;
  });
}

bool is_bored(const CoachView& view, const PlannedImplant& planned, std::int32_t drill) {
  const double radius_mm = bored_radius_mm(tool_at(view, drill));
  return std::ranges::any_of(view.site->bores, [&](const BoredHole& bore) {
    return bore.radius_mm >= radius_mm && is_meant_for(planned, bore.bone_from_bore) &&
           bore.depth_mm > planned.length_mm - pilot_short_mm;
  });
}

std::string degree_text(double rad) { return decimal_text(degree_from_radian(rad)) + "°"; }
std::string mm_text(double mm) { return decimal_text(mm) + " mm"; }

using Errors = std::array<double, 3>;
Errors errors_of(const Vec3& vector) { return {vector.x, vector.y, vector.z}; }

/// Across the view, and along the sight.
template <typename Change>
std::array<Lever<3>, 3> leading_levers(const CoachView& view, const Change& change_of) {
  const auto [right, up] = levers_across<3>(view.bone_from_view, change_of);
  const Vec3 near = view.bone_from_view * Vec3(0.0, 0.0, 1.0);
  return {{right, up, {HandMove::Nearer, HandMove::Deeper, change_of(near)}}};
}

Hint direction_hint(const CoachView& view, const PlannedImplant& planned,
                    const ImplantReading& reading) {
  const Vec3 axis = axis_x(view.bone_from_tool);
  Hint hint{.text_id = "operate.hint.direction"};
  hint.values = {{"direction", degree_text(reading.direction_rad)}};
  hint.read_outs = {"aim.direction"};
  const auto levers = turning_levers<3>(
      view.bone_from_view, [&](const Vec3& about) { return errors_of(glm::cross(about, axis)); });
  set_amount(hint, best_move<3>(errors_of(axis - planned.direction_in_bone), levers), key_turn_rad);
  return hint;
}

Hint entry_hint(const CoachView& view, const PlannedImplant& planned,
                const ImplantReading& reading) {
  const Vec3& along = planned.direction_in_bone;
  Hint hint{.text_id = "operate.hint.entry"};
  hint.values = {{"entry", mm_text(reading.entry_mm)}};
  hint.read_outs = {"aim.entry"};
  const auto levers = leading_levers(
      view, [&](const Vec3& way) { return errors_of(way - glm::dot(way, along) * along); });
  set_amount(hint, best_move<3>(errors_of(reading.off_in_bone_mm), levers), key_step_mm);
  return hint;
}

Hint bore_push_hint(const CoachView& view, double left_mm) {
  const PushRange push = left_mm < gentle_from_mm ? gentle_push : usual_push;
  Hint hint{.text_id = "operate.hint.bore"};
  hint.values = {{"force", decimal_text(view.force_newton) + " N"},
                 {"least", decimal_text(push.least_newton)},
                 {"most", decimal_text(push.most_newton) + " N"},
                 {"left", mm_text(left_mm)}};
  hint.push = push;
  hint.read_outs = {"force", "aim.depth"};
  if (view.force_newton < push.least_newton) {
    hint.move = HandMove::Push;
    hint.times = std::max(1, static_cast<int>(std::lround(push.least_newton - view.force_newton)));
  } else if (view.force_newton > push.most_newton) {
    hint.move = HandMove::DrawBack;
    hint.times = std::max(1, static_cast<int>(std::lround(view.force_newton - push.most_newton)));
  }
  return hint;
}

Hint move_hint(std::string_view text_id, HandMove move) {
  Hint hint{.text_id = text_id};
  hint.move = move;
  return hint;
}

/// In the air before the entry: direction, place, drive, and on to the bone.
Hint before_bone_hint(const CoachView& view, const ImplantTask& task,
                      const ImplantReading& reading) {
  const bool is_at_bone = view.site->ahead.beside_mm < near_bone_mm;
  const double slack = is_at_bone ? slack_at_bone : 1.0;
  const bool is_leaning = reading.direction_rad > slack * direction_good_rad;
  const bool is_beside = reading.entry_mm > slack * entry_good_mm;
  if ((is_leaning || is_beside) && is_at_bone) return draw_back_hint("operate.hint.clear_tip", 3.0);
  if (is_leaning) return direction_hint(view, *task.implant, reading);
  // Aside only in front of the bone, as the plan sees it.
  if (is_beside && reading.depth_mm > clear_mm)
    return draw_back_hint("operate.hint.clear_tip", reading.depth_mm - clear_mm + 0.5);
  if (is_beside) return entry_hint(view, *task.implant, reading);
  if (!view.is_saw_on) return switch_hint("operate.hint.drive_on");
  if (reading.depth_mm < -approach_mm) {
    Hint hint{.text_id = "operate.hint.approach_tip"};
    hint.values = {{"way", mm_text(-reading.depth_mm)}};
    hint.move = HandMove::Push;
    hint.times = std::max(1, static_cast<int>(std::lround(-reading.depth_mm / key_step_mm)));
    hint.read_outs = {"aim.depth"};
    return hint;
  }
  return bore_push_hint(view, task.implant->length_mm - reading.depth_mm);
}

/// On to the planned depth; then what stays is let go, and what does not is drawn back.
Hint in_bone_hint(const CoachView& view, const ImplantTask& task, const ImplantReading& reading) {
  const double left_mm = task.implant->length_mm - reading.depth_mm;
  const bool is_deep = left_mm < deep_enough_mm || view.tools->is_seated();
  if (!is_deep)
    return view.is_saw_on ? bore_push_hint(view, left_mm) : switch_hint("operate.hint.drive_on");
  if (task.is_pilot) return draw_back_hint("operate.hint.bored", reading.depth_mm - clear_mm);
  if (view.is_saw_on) return switch_hint("operate.hint.drive_off");
  return move_hint("operate.hint.leave", HandMove::LeaveOrTake);
}

/// A wire that is to come out again, and stands.
const StandingImplant* temporary_standing(const CoachView& view) {
  for (const StandingImplant& standing : view.site->implants) {
    for (const PlannedImplant& planned : view.plan.fixation.implants) {
      if (planned.is_temporary && is_of_kind(planned, tool_at(view, standing.tool)) &&
          is_meant_for(planned, standing.bone_from_tool))
        return &standing;
    }
  }
  return nullptr;
}

/// Of the tip in the hand, out of the hole of the wire that it is; as far as any where that is not
/// known.
double way_out_mm(const CoachView& view) {
  for (const PlannedImplant& planned : view.plan.fixation.implants) {
    if (planned.is_temporary && is_meant_for(planned, view.bone_from_tool))
      return read_implant(planned, view.bone_from_tool).depth_mm + out_of_hole_mm;
  }
  return longest_way_out_mm;
}

Hint turn_fragment_hint(const CoachView& view, const ShiftReading& reading) {
  Hint hint{.text_id = "operate.hint.turn_fragment"};
  hint.values = {{"turned", degree_text(reading.turned_rad)}};
  hint.read_outs = {"aim.turned"};
  const auto levers = turning_levers<3>(view.bone_from_view, errors_of);
  set_amount(hint, best_move<3>(errors_of(-reading.turn_left_in_bone_rad), levers), key_turn_rad);
  return hint;
}

Hint lead_fragment_hint(const CoachView& view, const ShiftReading& reading) {
  Hint hint{.text_id = "operate.hint.lead_fragment"};
  hint.values = {{"off", mm_text(reading.off_mm)}};
  hint.read_outs = {"aim.off"};
  const auto levers = leading_levers(view, errors_of);
  set_amount(hint, best_move<3>(errors_of(-reading.off_in_bone_mm), levers), key_step_mm);
  return hint;
}

Hint holding_hint(const CoachView& view, std::size_t shift, const ShiftReading& reading) {
  if (!view.tools->was_driven_home()) {
    if (reading.turned_rad > turned_good_rad) return turn_fragment_hint(view, reading);
    if (reading.off_mm > led_good_mm) return lead_fragment_hint(view, reading);
    if (view.plan.fixation.shifts[shift].is_closed)
      return move_hint("operate.hint.drive_home", HandMove::DriveHome);
  }
  return move_hint("operate.hint.let_go", HandMove::WorkForceps);
}

/// Null before the site knows.
const FreedFragment* freed_by(const CoachView& view, std::size_t shift) {
  const auto& fragments = view.plan.fixation.fragments;
  const auto number = static_cast<std::size_t>(
      std::ranges::find(fragments, view.plan.fixation.shifts[shift].fragment,
                        &scenarios::PlannedFragment::name) -
      fragments.begin());
  return number < view.site->freed.size() ? &view.site->freed[number] : nullptr;
}

}  // namespace

std::optional<ImplantTask> implant_at_hand(const CoachView& view) {
  if (view.steps.step() >= view.scenario.steps.size()) return std::nullopt;
  const std::vector<scenarios::LaidOutTool>& tray = view.tools->tray();
  for (const std::string& name : step_of(view).implants) {
    const PlannedImplant& planned = *find_implant(view.plan.fixation, name);
    if (is_set(view, planned)) continue;
    const std::optional<std::int32_t> tool = fitting_tool(tray, planned);
    if (!tool) continue;
    const std::optional<std::int32_t> drill = pilot_drill(tray, *tool);
    if (drill && !is_bored(view, planned, *drill)) return ImplantTask{&planned, *drill, true};
    return ImplantTask{&planned, *tool, false};
  }
  return std::nullopt;
}

std::optional<Hint> tool_hint(const CoachView& view, std::int32_t place) {
  if (view.tools->place() == place) return std::nullopt;
  if (view.is_in_bore || view.is_in_kerf) return draw_back_hint("operate.hint.clear_tip", 5.0);
  Hint hint = move_hint("operate.hint.take_tool", HandMove::OpenTray);
  hint.place = place;
  hint.read_outs = {"tray"};
  return hint;
}

std::optional<Hint> implant_hint(const CoachView& view) {
  const std::optional<ImplantTask> task = implant_at_hand(view);
  if (!task) {
    if (view.is_in_bore) return draw_back_hint("operate.hint.clear_tip", 5.0);
    if (step_of(view).kind == StepKind::Fix) {
      if (std::optional<Hint> wire = temporary_wire_hint(view)) return wire;
    }
    return press_hint("operate.hint.implant_done");
  }
  const ImplantReading reading = read_implant(*task->implant, view.bone_from_tool);
  if (std::optional<Hint> tool = tool_hint(view, task->tool)) {
    // A drill that has bored its hole is drawn out of it first.
    if (tool->move == HandMove::DrawBack)
      return draw_back_hint("operate.hint.bored", reading.depth_mm - clear_mm);
    return tool;
  }
  return view.is_in_bore ? in_bone_hint(view, *task, reading)
                         : before_bone_hint(view, *task, reading);
}

std::optional<Hint> temporary_wire_hint(const CoachView& view) {
  if (view.is_in_bore) return draw_back_hint("operate.hint.wire_out", way_out_mm(view));
  const StandingImplant* const standing = temporary_standing(view);
  if (standing == nullptr) return std::nullopt;
  if (std::optional<Hint> tool = tool_hint(view, standing->tool)) return tool;
  return move_hint("operate.hint.take_wire", HandMove::LeaveOrTake);
}

std::optional<std::size_t> shift_at_hand(const CoachView& view) {
  if (view.steps.kind() != StepKind::Shift) return std::nullopt;
  const auto& shifts = view.plan.fixation.shifts;
  const auto found = std::ranges::find(shifts, step_of(view).shift, &scenarios::PlannedShift::name);
  if (found == shifts.end()) return std::nullopt;
  return static_cast<std::size_t>(found - shifts.begin());
}

std::optional<std::int32_t> piece_of_shift(const CoachView& view, std::size_t shift) {
  const FreedFragment* const freed = freed_by(view, shift);
  return freed == nullptr ? std::nullopt : freed->piece;
}

ShiftReading shift_reading(const CoachView& view, std::size_t shift) {
  const FreedFragment* const freed = freed_by(view, shift);
  const bool is_fragment = freed != nullptr && freed->fragment.has_value();
  const RigidTransform lies =
      is_fragment ? view.site->moved[static_cast<std::size_t>(*freed->fragment)] : RigidTransform();
  return read_shift(view.plan, shift, lies);
}

std::optional<Hint> shift_hint(const CoachView& view) {
  if (std::optional<Hint> wire = temporary_wire_hint(view)) return wire;
  const std::optional<std::size_t> shift = shift_at_hand(view);
  if (!shift || !piece_of_shift(view, *shift)) return std::nullopt;
  const ShiftReading reading = shift_reading(view, *shift);
  if (view.tools->forceps() == Forceps::Holding) return holding_hint(view, *shift, reading);
  if (view.tools->forceps() == Forceps::Closing) return Hint{.text_id = "operate.hint.wait"};
  if (reading.off_mm < home_good_mm) return press_hint("operate.hint.shift_done");
  if (view.is_in_kerf) return draw_back_hint("operate.hint.clear_tip", 5.0);
  return move_hint("operate.hint.grip", HandMove::WorkForceps);
}

}  // namespace hallux::ui

#include "tests/ui/screens/operating/obedient_hand.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ui/screens/operating/fixation_hints.h"
#include "ui/screens/operating/hand/start_place.h"
#include "ui/screens/operating/hand/steering.h"

namespace hallux::ui {

namespace {

using simulator::PointerMotion;

constexpr int at_once = 8;
/// Who drives something home waits until it is.
constexpr int ticks_of_driving = 2500;
/// Of a drag that turns the view.
constexpr double look_rad = 0.1;

/// What one step of that move is for the hand.
PointerMotion motion_of(const Hint& hint) {
  PointerMotion motion;
  motion.is_fine = hint.is_fine;
  const double count = std::min(hint.times, at_once);
  const double way_mm = count * key_step_mm, turn_rad = count * key_turn_rad;
  switch (hint.move) {
    case HandMove::Left:
      motion.across_mm.x = -way_mm;
      break;
    case HandMove::Right:
      motion.across_mm.x = way_mm;
      break;
    case HandMove::Up:
      motion.across_mm.y = way_mm;
      break;
    case HandMove::Down:
      motion.across_mm.y = -way_mm;
      break;
    case HandMove::Push:
      motion.pushed_mm = way_mm;
      break;
    case HandMove::DrawBack:
      motion.pushed_mm = -way_mm;
      break;
    case HandMove::TurnLeft:
      motion.turned_rad.x = -turn_rad;
      break;
    case HandMove::TurnRight:
      motion.turned_rad.x = turn_rad;
      break;
    case HandMove::TurnUp:
      motion.turned_rad.y = turn_rad;
      break;
    case HandMove::TurnDown:
      motion.turned_rad.y = -turn_rad;
      break;
    case HandMove::RollLeft:
      motion.rolled_rad = turn_rad;
      break;
    case HandMove::RollRight:
      motion.rolled_rad = -turn_rad;
      break;
    case HandMove::Nearer:
      motion.deeper_mm = -way_mm;
      break;
    case HandMove::Deeper:
      motion.deeper_mm = way_mm;
      break;
    default:
      break;
  }
  return motion;
}

/// As the keys of the tray and of the forceps do.
void work(VirtualOperation& operation, const Hint& hint) {
  OperatingSession& session = operation.session();
  const CoachView view = coach_view(operation.sources());
  switch (hint.move) {
    case HandMove::OpenTray:
      session.open_tray();
      session.close_tray(hint.place);
      break;
    case HandMove::WorkForceps: {
      const std::optional<std::size_t> shift = shift_at_hand(view);
      session.work_forceps(shift ? piece_of_shift(view, *shift) : view.site->reach.piece);
      break;
    }
    case HandMove::DriveHome:
      session.drive_home();
      operation.advance(ticks_of_driving);
      break;
    case HandMove::LeaveOrTake:
      session.leave_or_take(view.is_in_bore, view.site->reach.implant);
      break;
    default:
      break;
  }
}

}  // namespace

/// Does what the hint says, a few key presses at a time.
void obey(VirtualOperation& operation, const Hint& hint) {
  if (hint.move == HandMove::SwitchSaw)
    operation.session().set_saw_on(!operation.session().saw().is_on());
  if (hint.move == HandMove::SwitchWater)
    operation.session().set_irrigated(!operation.session().saw().is_irrigated());
  if (hint.move == HandMove::LookAround)
    operation.world_from_view =
        operation.world_from_view * glm::angleAxis(look_rad, Vec3(0.0, 1.0, 0.0));
  if (hint.move == HandMove::ResetView)
    operation.world_from_view = start_camera(operation.prepared_case()).world_from_view;
  if (hint.move == HandMove::PressStep) operation.press_step();
  if (hint.move == HandMove::TakeUpStep) {
    const auto step = step_to_take_up(coach_view(operation.sources()));
    ASSERT_TRUE(step.has_value()) << "a hint for what cannot be done";
    operation.session().take_up_step(*step);
  }
  work(operation, hint);
  operation.advance(ticks_per_look, motion_of(hint));
}

}  // namespace hallux::ui

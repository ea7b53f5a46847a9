#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "tests/ui/screens/operating/virtual_operation.h"
#include "ui/screens/operating/hand/steering.h"

namespace hallux::ui {
namespace {

using simulator::CutEventKind;
using simulator::PointerMotion;

constexpr int ticks_per_look = 300, at_once = 8;

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
    default:
      break;
  }
  return motion;
}

/// Does what the hint says, a few key presses at a time.
void obey(VirtualOperation& operation, const Hint& hint) {
  if (hint.move == HandMove::SwitchSaw)
    operation.session().set_saw_on(!operation.session().saw().is_on());
  if (hint.move == HandMove::PressStep) operation.press_step();
  if (hint.move == HandMove::TakeUpStep) {
    for (std::size_t step = operation.session().steps().step(); step-- > 0;)
      if (operation.session().steps().can_reopen(step))
        return operation.session().reopen_step(step);
  }
  operation.advance(ticks_per_look, motion_of(hint));
}

int count_of(const VirtualOperation& operation, CutEventKind kind) {
  return static_cast<int>(std::ranges::count(operation.events(), kind, &simulator::CutEvent::kind));
}

class Coach : public testing::TestWithParam<std::tuple<std::string, int>> {};

TEST_P(Coach, LeadsOneWhoOnlyObeysToTheEnd) {
  const auto& [scenario, turn] = GetParam();
  VirtualOperation operation(scenario);
  operation.world_from_view =
      operation.world_from_view * glm::angleAxis(0.7 * turn, unit(Vec3(0.2, 1.0, 0.1)));
  while (operation.session().asked() == Asked::Nothing && operation.time_s() < 240.0) {
    const std::optional<Hint> hint = next_hint(coach_view(operation.sources()));
    if (!hint) {
      operation.advance(ticks_per_look);
      continue;
    }
    obey(operation, *hint);
  }
  EXPECT_EQ(operation.session().asked(), Asked::Finish) << "within four minutes";
  EXPECT_GE(count_of(operation, CutEventKind::PieceRemoved), 1);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Coach,
                         testing::Combine(testing::Values(std::string("silver"),
                                                          std::string("akin")),
                                          testing::Values(0, 1, -1, -2, 3)));

}  // namespace
}  // namespace hallux::ui

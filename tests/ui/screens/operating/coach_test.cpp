#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

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
    case HandMove::Left: motion.across_mm.x = -way_mm; break;
    case HandMove::Right: motion.across_mm.x = way_mm; break;
    case HandMove::Up: motion.across_mm.y = way_mm; break;
    case HandMove::Down: motion.across_mm.y = -way_mm; break;
    case HandMove::Push: motion.pushed_mm = way_mm; break;
    case HandMove::DrawBack: motion.pushed_mm = -way_mm; break;
    case HandMove::TurnLeft: motion.turned_rad.x = -turn_rad; break;
    case HandMove::TurnRight: motion.turned_rad.x = turn_rad; break;
    case HandMove::TurnUp: motion.turned_rad.y = turn_rad; break;
    case HandMove::TurnDown: motion.turned_rad.y = -turn_rad; break;
    case HandMove::RollLeft: motion.rolled_rad = turn_rad; break;
    case HandMove::RollRight: motion.rolled_rad = -turn_rad; break;
    default: break;
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
      if (operation.session().steps().can_reopen(step)) return operation.session().reopen_step(step);
  }
  operation.advance(ticks_per_look, motion_of(hint));
}

int count_of(const VirtualOperation& operation, CutEventKind kind) {
  return static_cast<int>(std::ranges::count(operation.events(), kind, &simulator::CutEvent::kind));
}

class Coach : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(Coach, LeadsOneWhoOnlyObeysToTheEnd) {
  const auto [scenario, turn] = GetParam();
  VirtualOperation operation(scenario);
  operation.world_from_view = operation.world_from_view *
                              glm::angleAxis(0.7 * turn, unit(Vec3(0.2, 1.0, 0.1)));
  const Texts texts = english_texts();
  std::string last;
  while (operation.session().asked() == Asked::Nothing && operation.time_s() < 240.0) {
    const std::optional<Hint> hint = next_hint(coach_view(operation.sources()));
    if (!hint) {
      operation.advance(ticks_per_look);
      continue;
    }
    std::printf("%6.1f s  %s\n", operation.time_s(), hint_text(texts, *hint).c_str());
    if (getenv("DBG") && operation.site()) for (auto& c : operation.site()->cuts) std::printf("   held %.3f side %s deepest %.1f %.1f %.1f begun %d\n", c.share, c.side.c_str(), c.deepest_in_bone_mm.x,c.deepest_in_bone_mm.y,c.deepest_in_bone_mm.z,c.is_begun());
    if (getenv("DBG") && operation.site()) for (size_t k=0;k<operation.site()->cuts.size();++k){auto src=operation.sources(); auto& c=operation.site()->cuts[k]; auto&pc=src.prepared_case.plan.cuts[k]; Vec3 d=c.deepest_in_bone_mm-pc.entry_point_in_bone_mm; auto bt=coach_view(src).bone_from_tool; Vec3 tt=bt.translation_mm-pc.entry_point_in_bone_mm; std::printf("   low cut%zu deepest along %.2f feed %.2f; tip along %.2f feed %.2f inkerf %d\n",k,glm::dot(src.passes[k].along_in_bone,d),glm::dot(src.passes[k].feed_in_bone,d),glm::dot(src.passes[k].along_in_bone,tt),glm::dot(src.passes[k].feed_in_bone,tt), coach_view(src).is_in_kerf);}
    if (getenv("DBG")) for (auto& q : operation.sources().passes) {std::printf("   low %.1f high %.1f:", q.low_mm,q.high_mm); for (double m: q.middles_mm) std::printf(" %.1f",m); std::printf(" ahead %f beside %f\n", operation.site()?operation.site()->ahead.to_bone_mm.value_or(-1):-2, operation.site()?operation.site()->ahead.beside_mm:-1);}
    obey(operation, *hint);
  }
  EXPECT_EQ(operation.session().asked(), Asked::Finish) << "within four minutes";
  EXPECT_GE(count_of(operation, CutEventKind::PieceRemoved), 1);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Coach,
                         testing::Combine(testing::Values("silver", "akin"),
                                          testing::Values(0, 1, -1)));

}  // namespace
}  // namespace hallux::ui

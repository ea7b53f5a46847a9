// A chevron from the first look to the last, by somebody who only obeys what the coach says: no
// operation is known by name, so whoever follows the hints of another comes as far.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "assessment/assess.h"
#include "tests/ui/screens/operating/fixation/chevron_case.h"
#include "tests/ui/screens/operating/obedient_hand.h"
#include "ui/screens/operating/fixation_hints.h"

namespace hallux::ui {
namespace {

using simulator::CutEvent;
using simulator::CutEventKind;

constexpr double patience_s = 900.0;

class ChevronByHints : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    operation = new VirtualOperation(chevron_case());
    while (operation->time_s() < patience_s && operation->session().asked() != Asked::Finish) {
      const Hint hint = next_hint(coach_view(operation->sources())).value_or(Hint{});
      if (hint.text_id == "operate.hint.wire_out") ways_out.push_back(hint.times);
      obey(*operation, hint);
    }
  }
  static void TearDownTestSuite() {
    delete operation;
    operation = nullptr;
  }
  static long count(CutEventKind kind) {
    return std::ranges::count(operation->events(), kind, &CutEvent::kind);
  }

  static VirtualOperation* operation;
  /// Millimetres that a wire was to be drawn out by, in turn.
  static std::vector<int> ways_out;
};

VirtualOperation* ChevronByHints::operation = nullptr;
std::vector<int> ChevronByHints::ways_out;

TEST_F(ChevronByHints, ComesToTheLastStep) {
  EXPECT_EQ(operation->session().asked(), Asked::Finish);
  for (std::size_t step = 0; step + 1 < operation->prepared_case().scenario.steps.size(); ++step)
    EXPECT_TRUE(operation->session().steps().is_done(step)) << step;
}

/// Its end was not declared, so the points for the time are lost.
TEST_F(ChevronByHints, IsWorthEightyPointsAndSetsOffNoGate) {
  const PreparedCase& prepared = operation->prepared_case();
  const database::ScoreCard card =
      assessment::assess_fully(prepared.scenario, prepared.bones, operation->recording(), "mouse")
          .card;
  EXPECT_GE(card.score_milli, 80000);
  for (const database::GateResult& gate : card.gates) EXPECT_FALSE(gate.is_triggered) << gate.text;
}

TEST_F(ChevronByHints, PartsTheHeadLeadsItToItsPlaceAndDrivesItHome) {
  EXPECT_EQ(count(CutEventKind::FragmentParted), 1);
  EXPECT_EQ(count(CutEventKind::Gripped), 1);
  const SiteFacts& site = *operation->site();
  ASSERT_EQ(site.bone_from_fragments.size(), 2U);
  const ShiftReading lies =
      read_shift(operation->prepared_case().plan, 0, site.bone_from_fragments[1]);
  EXPECT_NEAR(lies.moved_mm, 5.0, 1.0);
  EXPECT_LT(lies.turned_rad, 0.1);
}

TEST_F(ChevronByHints, LeavesTheScrewAndTakesTheWiresOut) {
  const SiteFacts& site = *operation->site();
  ASSERT_EQ(site.implants.size(), 1U);
  const scenarios::LaidOutTool& tool =
      operation->session().tools().tray()[static_cast<std::size_t>(site.implants[0].tool)];
  EXPECT_TRUE(std::holds_alternative<simulator::Screwdriver>(tool.tool)) << tool.name;
  EXPECT_EQ(count(CutEventKind::ImplantTaken), 2);
}

TEST_F(ChevronByHints, TellsHowFarAWireIsStillToBeDrawnOut) {
  ASSERT_GE(ways_out.size(), 2U) << "some millimetres at a time";
  EXPECT_GT(ways_out.front(), 18) << "as deep as it was set";
  EXPECT_LT(ways_out.front(), 30);
  EXPECT_LT(ways_out.back(), 10);
}

/// Turns the blade about its normal.
void turn_in_plane(VirtualOperation& operation, double angle_rad) {
  const CoachView view = coach_view(operation.sources());
  const Vec3 turn = angle_rad * (glm::conjugate(view.bone_from_view) * axis_z(view.bone_from_tool));
  simulator::PointerMotion motion;
  motion.turned_rad = Vec2(turn.y, -turn.x);
  motion.rolled_rad = turn.z;
  operation.advance(2 * ticks_per_look, motion);
}

TEST(TurnedInItsPlane, ABladeIsTurnedBackBeforeItSaws) {
  VirtualOperation operation(chevron_case());
  const auto look = [&] { return next_hint(coach_view(operation.sources())).value_or(Hint{}); };
  while (look().text_id != "operate.hint.saw_on" && operation.time_s() < patience_s)
    obey(operation, look());
  const std::size_t step = operation.session().steps().step();
  turn_in_plane(operation, -0.2);
  EXPECT_NE(look().text_id, "operate.hint.saw_on");
  while (operation.session().steps().step() == step && operation.time_s() < patience_s)
    obey(operation, look());
  EXPECT_TRUE(operation.session().steps().is_done(step));
}

}  // namespace
}  // namespace hallux::ui

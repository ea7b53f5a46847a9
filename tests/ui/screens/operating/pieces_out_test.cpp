// A part that comes off in several pieces, operated on by a hand that only obeys.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "assessment/assess.h"
#include "assessment/ledger.h"
#include "scenarios/practice_block.h"
#include "simulator/loop/replay.h"
#include "tests/ui/screens/operating/forked_block.h"
#include "tests/ui/screens/operating/obedient_hand.h"

namespace hallux::ui {
namespace {

using scenarios::StepKind;
using simulator::CommandKind;
using simulator::CutEvent;
using simulator::CutEventKind;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double broad_blade_mm = 40.0, narrow_blade_mm = 12.0;
constexpr double patience_s = 240.0;
constexpr auto practice = database::AttemptKind::Practice;

class ForkedOperation {
 public:
  explicit ForkedOperation(double blade_width_mm, database::AttemptKind kind = practice)
      : ForkedOperation(forked_case(blade_width_mm), kind) {}

  std::optional<Hint> hint() const { return next_hint(coach_view(operation.sources())); }
  std::string reason() const { return hud_of(operation.sources(), true).why_step_off; }
  const StepProgress& steps() { return operation.session().steps(); }

  void obey_once() {
    if (const std::optional<Hint> told = hint()) {
      obey(operation, *told);
    } else {
      operation.advance(ticks_per_look);
    }
  }
  template <typename Holds>
  bool obey_until(Holds&& holds) {
    while (!holds() && operation.time_s() < patience_s) obey_once();
    return holds();
  }
  std::vector<CutEvent> events(CutEventKind kind) const {
    std::vector<CutEvent> found;
    std::ranges::copy_if(operation.events(), std::back_inserter(found),
                         [kind](const CutEvent& event) { return event.kind == kind; });
    return found;
  }
  bool is_at(StepKind kind) { return steps().kind() == kind; }
  /// Ends the cut though bone holds.
  void end_cut_unfinished() {
    operation.press_step();
    EXPECT_EQ(operation.session().asked(), Asked::EndUnfinished);
    operation.session().answer(Decided::Act, operation.time_s());
    operation.advance(ticks_per_look);
  }

  VirtualOperation operation;

 private:
  ForkedOperation(PreparedCase prepared, database::AttemptKind kind)
      : operation(std::move(prepared), chain_of(scenarios::make_practice_block().scenario), kind) {}
};

TEST(PiecesOut, OfAPartThatComesOffInTwoBothAreTakenOutTheLargestFirst) {
  ForkedOperation forked(broad_blade_mm);
  ASSERT_TRUE(forked.obey_until([&] { return forked.is_at(StepKind::Remove); }));
  ASSERT_TRUE(forked.obey_until([&] { return forked.steps().is_ready(); }));
  const std::vector<CutEvent> freed = forked.events(CutEventKind::PieceFreed);
  ASSERT_EQ(freed.size(), 2U);
  EXPECT_EQ(freed[0].tick, freed[1].tick) << "of one result";
  EXPECT_GT(freed[0].value, 2 * freed[1].value);
  forked.operation.press_step();
  ASSERT_TRUE(forked.obey_until([&] { return forked.is_at(StepKind::Finish); }));
  const std::vector<CutEvent> removed = forked.events(CutEventKind::PieceRemoved);
  ASSERT_EQ(removed.size(), 2U);
  EXPECT_EQ(removed[0].subject, freed[0].subject);
  EXPECT_EQ(removed[1].subject, freed[1].subject);
  EXPECT_GT(forked.events(CutEventKind::StepDone).back().tick, removed[1].tick);
}

TEST(PiecesOut, OfAnAttemptThatNamesItsPiecesTheReplayIsIdentical) {
  ForkedOperation forked(broad_blade_mm);
  ASSERT_TRUE(forked.obey_until([&] { return forked.is_at(StepKind::Finish); }));
  std::vector<std::int32_t> named;
  for (const simulator::TapeLine& line : forked.operation.recording().tape)
    for (std::size_t i = 0; i < line.command_count; ++i)
      if (line.commands[i].kind == CommandKind::PickUp) named.push_back(line.commands[i].argument);
  EXPECT_THAT(named, ElementsAre(1, 2));
  const simulator::ReplayResult again =
      replay(forked.operation.recording(), forked.operation.setup());
  EXPECT_TRUE(again.is_identical) << again.difference;
}

/// Somebody who ended the cut as soon as the thin prong was free.
class ACrumbAlone : public testing::TestWithParam<database::AttemptKind> {
 protected:
  ACrumbAlone() : forked_(narrow_blade_mm, GetParam()) {
    EXPECT_TRUE(
        forked_.obey_until([&] { return !forked_.events(CutEventKind::PieceFreed).empty(); }));
    forked_.end_cut_unfinished();
  }
  ForkedOperation forked_;
};

TEST_P(ACrumbAlone, IsNoPieceAndTheButtonSaysSo) {
  ASSERT_EQ(forked_.events(CutEventKind::PieceFreed).size(), 1U);
  ASSERT_TRUE(forked_.is_at(StepKind::Remove));
  EXPECT_FALSE(forked_.steps().is_ready());
  EXPECT_THAT(forked_.reason(), HasSubstr("only a crumb"));
  EXPECT_THAT(forked_.reason(), HasSubstr("till held")) << "and why the piece is not free";
  EXPECT_NE(forked_.hint()->move, HandMove::PressStep) << "there is nothing to take out";
  forked_.operation.press_step();
  forked_.operation.advance(ticks_per_look);
  EXPECT_TRUE(forked_.events(CutEventKind::PieceRemoved).empty());
  EXPECT_TRUE(forked_.is_at(StepKind::Remove));
}

TEST_P(ACrumbAlone, IsSawnOnFromAndGoesWithThePiece) {
  ASSERT_TRUE(forked_.obey_until([&] { return forked_.is_at(StepKind::Finish); }));
  const std::vector<CutEvent> removed = forked_.events(CutEventKind::PieceRemoved);
  ASSERT_EQ(removed.size(), 2U);
  EXPECT_EQ(removed[0].subject, 2) << "the piece, which came free last";
  EXPECT_EQ(removed[1].subject, 1);
  const PreparedCase& prepared = forked_.operation.prepared_case();
  const assessment::Examination examination = assessment::assess_fully(
      prepared.scenario, prepared.bones, forked_.operation.recording(), "mouse");
  EXPECT_EQ(assessment::find_measurement(examination.measurements, "piece_out", "across")->value,
            1.0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ACrumbAlone,
                         testing::Values(practice, database::AttemptKind::Assessment));

}  // namespace
}  // namespace hallux::ui

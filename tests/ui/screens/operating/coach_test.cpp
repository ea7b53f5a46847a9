#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "assessment/assess.h"
#include "tests/ui/screens/operating/obedient_hand.h"

namespace hallux::ui {
namespace {

using simulator::CutEventKind;

int count_of(const VirtualOperation& operation, CutEventKind kind) {
  return static_cast<int>(std::ranges::count(operation.events(), kind, &simulator::CutEvent::kind));
}

/// piece_out and wedge_closed as they are scored.
std::vector<double> deeds_of(const VirtualOperation& operation) {
  const PreparedCase& prepared = operation.prepared_case();
  const assessment::Examination examination =
      assessment::assess_fully(prepared.scenario, prepared.bones, operation.recording(), "mouse");
  std::vector<double> deeds;
  for (const assessment::Measurement& made : examination.measurements)
    if (made.metric == "piece_out" || made.metric == "wedge_closed") deeds.push_back(made.value);
  EXPECT_FALSE(deeds.empty());
  return deeds;
}

/// Of the view, by 40 degrees each, from that in which the operation begins.
#ifdef HALLUX_LONG_RUNS
constexpr int turns[] = {1, -1, 3};
#else
constexpr int turns[] = {0, -2};
#endif

class Coach : public testing::TestWithParam<std::tuple<std::string, int>> {};

TEST_P(Coach, LeadsOneWhoOnlyObeysToTheEnd) {
  const auto& [scenario, turn] = GetParam();
  VirtualOperation operation(scenario);
  operation.world_from_view =
      operation.world_from_view * glm::angleAxis(0.7 * turn, unit(Vec3(0.2, 1.0, 0.1)));
  while (operation.session().asked() == Asked::Nothing && operation.time_s() < 600.0) {
    const std::optional<Hint> hint = next_hint(coach_view(operation.sources()));
    if (!hint) {
      operation.advance(ticks_per_look);
      continue;
    }
    obey(operation, *hint);
  }
  EXPECT_EQ(operation.session().asked(), Asked::Finish) << "within ten minutes";
  EXPECT_GE(count_of(operation, CutEventKind::PieceRemoved), 1);
  for (const double done : deeds_of(operation)) EXPECT_EQ(done, 1.0) << "as the score asks it";
}

/// Obeys until it holds, or too much time has gone by.
template <typename Holds>
bool obey_until(VirtualOperation& operation, Holds&& holds) {
  while (!holds() && operation.time_s() < 300.0) {
    if (const std::optional<Hint> hint = next_hint(coach_view(operation.sources()))) {
      obey(operation, *hint);
    } else {
      operation.advance(ticks_per_look);
    }
  }
  return holds();
}

/// The first cut of a wedge was ended half sawn, and the second is open.
TEST(CoachOfAWedge, NamesTheCutThatHoldsAndHasItTakenUp) {
  VirtualOperation operation("akin");
  const auto step = [&] { return operation.session().steps().step(); };
  ASSERT_TRUE(obey_until(operation, [&] {
    return operation.site() != nullptr && operation.site()->cuts[0].share < 0.6;
  }));
  for (int i = 0; i < 4; ++i) obey(operation, draw_back_hint("operate.hint.clear", 8.0));
  operation.press_step();
  ASSERT_EQ(operation.session().asked(), Asked::EndUnfinished);
  operation.session().answer(Decided::Act, operation.time_s());
  ASSERT_TRUE(obey_until(operation, [&] { return step() == 3; })) << "the second cut is open";
  ASSERT_TRUE(obey_until(operation, [&] {
    const std::optional<Hint> hint = next_hint(coach_view(operation.sources()));
    return hint && hint->move == HandMove::TakeUpStep;
  }));
  const std::string words = hint_text(english_texts(), *next_hint(coach_view(operation.sources())));
  EXPECT_THAT(words, testing::HasSubstr("step 2, First cut"));
  EXPECT_THAT(words, testing::HasSubstr("press the number 2"));
  EXPECT_EQ(step_to_take_up(coach_view(operation.sources())), 1U);
  CoachView blind = coach_view(operation.sources());
  blind.site = nullptr;
  EXPECT_EQ(step_to_take_up(blind), 2U) << "who does not know takes up the last";
  EXPECT_TRUE(obey_until(operation, [&] { return operation.session().asked() == Asked::Finish; }));
  EXPECT_EQ(count_of(operation, CutEventKind::StepReopened), 1);
  EXPECT_EQ(deeds_of(operation), (std::vector{1.0, 1.0}));
}

/// However the blade is held, who obeys turns it to its plane, and not in circles.
TEST(CoachOfATurnedBlade, LeadsBackFromWhereverTheHandHoldsIt) {
  VirtualOperation operation("silver");
  operation.press_step();
  operation.advance(ticks_per_look);
  for (const Vec3& turn : {Vec3(1.2, 0.9, -0.8), Vec3(-1.4, 0.3, 1.1), Vec3(0.2, -1.3, 1.5)}) {
    simulator::PointerMotion motion;
    motion.turned_rad = Vec2(turn.x, turn.y);
    motion.rolled_rad = turn.z;
    operation.advance(1500, motion);
    const double begun_s = operation.time_s();
    const auto is_tilted = [&] {
      const std::optional<Hint> hint = next_hint(coach_view(operation.sources()));
      return hint && hint->text_id == "operate.hint.tilt";
    };
    EXPECT_TRUE(is_tilted());
    while (is_tilted() && operation.time_s() < begun_s + 30.0)
      obey(operation, *next_hint(coach_view(operation.sources())));
    EXPECT_FALSE(is_tilted()) << turn.x << " " << turn.y << " " << turn.z;
  }
}

TEST(HintWords, SayWhatTheHandDoesThatHoldsADevice) {
  using Led = simulator::SteeredDevice::Led;
  const Hint push{.text_id = "operate.hint.wait", .move = HandMove::Push};
  const Hint turn{.text_id = "operate.hint.wait", .move = HandMove::TurnUp};
  const auto words = [](const Hint& hint, Led led) {
    return hint_text(english_texts(), hint, led);
  };
  EXPECT_THAT(words(push, Led::Pose), testing::HasSubstr("Page up"));
  EXPECT_THAT(words(push, Led::Rotation), testing::HasSubstr("Your hand: push"));
  EXPECT_THAT(words(push, Led::Rotation), testing::Not(testing::HasSubstr("Page up")));
  EXPECT_THAT(words(turn, Led::Rotation), testing::HasSubstr("Ctrl+Up"))
      << "an arm of three joints turns nothing";
  EXPECT_THAT(words(turn, Led::Nothing), testing::HasSubstr("Your hand: tip"));
  EXPECT_THAT(words({.text_id = "operate.hint.wait", .move = HandMove::SwitchSaw}, Led::Nothing),
              testing::HasSubstr("Space"));
}

TEST(HintWords, SayHowFarTheMouseGoesAndHoldShiftForLittle) {
  const auto words = [](HandMove move, int times, bool is_fine) {
    return hint_text(
        english_texts(),
        {.text_id = "operate.hint.wait", .move = move, .times = times, .is_fine = is_fine});
  };
  EXPECT_THAT(words(HandMove::RollRight, 2, false),
              testing::EndsWith("Keys: Ctrl+Page down, 2 times. Mouse: hold the left button and "
                                "turn the wheel towards you, 2 notches."));
  EXPECT_THAT(words(HandMove::RollLeft, 1, true),
              testing::EndsWith("Mouse: hold Shift, hold the left button and turn the wheel away "
                                "from you, 1 notch."));
  EXPECT_THAT(words(HandMove::Push, 5, false),
              testing::EndsWith("Mouse: turn the wheel away from you, 5 notches."));
  EXPECT_THAT(words(HandMove::TurnUp, 3, true),
              testing::EndsWith("Mouse: hold Shift, drag up with the left button by 0.6°."));
  EXPECT_THAT(words(HandMove::TurnLeft, 2, false),
              testing::EndsWith("Mouse: hold Shift, drag left with the left button by 2.0°."))
      << "a drag of few pixels is a click";
  EXPECT_THAT(words(HandMove::TurnLeft, 9, false),
              testing::EndsWith("Mouse: drag left with the left button by 9.0°."));
  EXPECT_THAT(words(HandMove::Left, 3, true), testing::EndsWith("Mouse: move left by 0.6 mm."));
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Coach,
                         testing::Combine(testing::Values(std::string("silver"),
                                                          std::string("akin")),
                                          testing::ValuesIn(turns)));

}  // namespace
}  // namespace hallux::ui

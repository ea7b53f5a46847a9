#include "assessment/pass_mark.h"

#include <gtest/gtest.h>

namespace hallux::assessment {
namespace {

database::ScoreCard whole_card(std::int64_t safety_earned_milli) {
  database::ScoreCard card;
  card.rubric_milli = card.measured_milli = 100'000;
  card.groups = {{"accuracy", 78'000, 78'000, 70'000},
                 {"safety", 22'000, 22'000, safety_earned_milli}};
  card.gates = {{"plunge", 59'000, false, 0.0, 2.0, "mm", ""}};
  return card;
}

TEST(PassMark, IsReachedFromSixtyOn) {
  EXPECT_EQ(pass_answer(whole_card(22'000), 60'000), PassAnswer::Reached);
  EXPECT_EQ(pass_answer(whole_card(22'000), 59'999), PassAnswer::NotReached);
}

TEST(PassMark, SafetyIsNotAveragedAway) {
  EXPECT_EQ(pass_answer(whole_card(13'200), 90'000), PassAnswer::Reached);
  EXPECT_EQ(pass_answer(whole_card(13'199), 90'000), PassAnswer::NotReached);
}

TEST(PassMark, AGateIsNeverAPassWhateverWasMeasured) {
  database::ScoreCard card = whole_card(22'000);
  card.gates.front().is_triggered = true;
  EXPECT_EQ(pass_answer(card, 100'000), PassAnswer::NotReached);
  card.measured_milli = 50'000;
  EXPECT_EQ(pass_answer(card, 100'000), PassAnswer::NotReached);
}

TEST(PassMark, APartialScoreDecidesNothing) {
  database::ScoreCard card = whole_card(22'000);
  card.measured_milli = 99'999;
  EXPECT_EQ(pass_answer(card, 100'000), PassAnswer::NotDecided);
  EXPECT_EQ(pass_answer(card, 10'000), PassAnswer::NotDecided);
}

}  // namespace
}  // namespace hallux::assessment

#include "assessment/ledger.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <numeric>
#include <string>

#include "tests/assessment/any_card.h"

namespace hallux::assessment {
namespace {

using database::LedgerKind;
using database::LedgerLine;
using database::ScoreCard;
using scenarios::Rubric;

/// Accuracy 60, efficiency 40; a value of v loses the share v of its item.
Rubric two_groups() {
  Rubric rubric;
  rubric.groups = {{"accuracy", "Accuracy", 60000, ""}, {"efficiency", "Efficiency", 40000, ""}};
  rubric.items = {item("a", "accuracy", 60000), item("e", "efficiency", 40000)};
  return rubric;
}

std::int64_t sum_of_losses(const ScoreCard& card) {
  std::int64_t sum = 0;
  for (const LedgerLine& line : card.ledger) sum += line.points_lost_milli;
  return sum;
}

std::int64_t sum_of_shown_losses(const ScoreCard& card) {
  return std::accumulate(card.shown_losses_milli.begin(), card.shown_losses_milli.end(),
                         std::int64_t{0});
}

TEST(Ledger, ScoresWhatWasEarnedOfWhatCouldBeMeasured) {
  const std::vector<Measurement> measurements{measured("a_mm", 0.25)};
  const ScoreCard card = score_rubric(two_groups(), measurements);
  EXPECT_EQ(card.rubric_milli, 100000);
  EXPECT_EQ(card.measured_milli, 60000);
  EXPECT_EQ(card.earned_milli, 45000);
  EXPECT_EQ(card.score_milli, 75000);
  ASSERT_EQ(card.groups.size(), 2U);
  EXPECT_EQ(card.groups[1].measured_milli, 0);
}

TEST(Ledger, AnItemWhoseCutWasNotMadeLosesAllOfIt) {
  std::vector<Measurement> measurements{measured("a_mm", 0.0)};
  measurements[0].absence = Absence::NotMade;
  const ScoreCard card = score_rubric(two_groups(), measurements);
  EXPECT_EQ(card.measured_milli, 60000);
  EXPECT_EQ(card.score_milli, 0);
  EXPECT_EQ(sum_of_losses(card), 60000);
}

TEST(Ledger, AnUnfinishedCutEarnsTheShareThatWasCut) {
  std::vector<Measurement> measurements{measured("a_mm", 0.5)};
  measurements[0].done_fraction = 0.1;
  EXPECT_EQ(score_rubric(two_groups(), measurements).earned_milli, 3000);
}

TEST(Ledger, NothingMeasuredIsScoreNoughtWithoutLosses) {
  const ScoreCard card = score_rubric(two_groups(), {});
  EXPECT_EQ(card.measured_milli, 0);
  EXPECT_EQ(card.score_milli, 0);
  EXPECT_TRUE(card.ledger.empty());
}

TEST(Ledger, SpeedEarnsNothingWithoutAccuracy) {
  const std::vector<Measurement> measurements{measured("a_mm", 1.0), measured("e_mm", 0.0)};
  const ScoreCard card = score_rubric(two_groups(), measurements);
  EXPECT_EQ(card.score_milli, 0);
  ASSERT_EQ(card.ledger.size(), 3U);
  EXPECT_EQ(card.ledger[2].kind, LedgerKind::Damping);
  EXPECT_EQ(card.ledger[2].points_lost_milli, 40000);
}

TEST(Ledger, HalfOfTheNeededAccuracyHalvesEfficiency) {
  const std::vector<Measurement> measurements{measured("a_mm", 0.7), measured("e_mm", 0.5)};
  const ScoreCard card = score_rubric(two_groups(), measurements);
  EXPECT_EQ(card.ledger[2].points_lost_milli, 10000);
  EXPECT_EQ(card.earned_milli, 18000 + 10000);
  EXPECT_EQ(card.groups[1].earned_milli, 10000);
}

TEST(Ledger, SixTenthsOfTheAccuracyDampNothing) {
  const std::vector<Measurement> measurements{measured("a_mm", 0.4), measured("e_mm", 0.0)};
  const ScoreCard card = score_rubric(two_groups(), measurements);
  EXPECT_EQ(card.ledger[2].points_lost_milli, 0);
  EXPECT_EQ(card.earned_milli, 36000 + 40000);
}

TEST(Ledger, TheLowestTriggeredCapTakesWhatStandsAboveIt) {
  Rubric rubric = two_groups();
  rubric.gates = {gate("g_mm", 1.0, 69000), gate("h_mm", 1.0, 59000), gate("i_mm", 1.0, 10000)};
  const std::vector<Measurement> measurements{measured("a_mm", 0.0), measured("g_mm", 1.5),
                                              measured("h_mm", 1.5), measured("i_mm", 1.0)};
  const ScoreCard card = score_rubric(rubric, measurements);
  EXPECT_EQ(card.score_milli, 59000);
  EXPECT_TRUE(card.gates[0].is_triggered);
  EXPECT_TRUE(card.gates[1].is_triggered);
  EXPECT_FALSE(card.gates[2].is_triggered);
  ASSERT_EQ(card.ledger.size(), 3U);
  EXPECT_EQ(card.ledger[1].item, "gate h_mm");
  EXPECT_EQ(card.ledger[1].points_lost_milli, 60000 * 41 / 100);
  EXPECT_EQ(card.ledger[2].points_lost_milli, 0);
}

TEST(Ledger, AGateOfACutThatWasNotMadeStaysShut) {
  Rubric rubric = two_groups();
  rubric.gates = {gate("g_mm", 1.0, 0)};
  std::vector<Measurement> measurements{measured("a_mm", 0.0), measured("g_mm", 9.0)};
  measurements[1].absence = Absence::NotMade;
  EXPECT_EQ(score_rubric(rubric, measurements).score_milli, 100000);
}

TEST(Ledger, AGateThatAsksForTheLeastCapsWhatStaysBelowIt) {
  Rubric rubric = two_groups();
  rubric.gates = {gate("g_mm", 1.0, 39000)};
  rubric.gates[0].is_at_least = true;
  const auto score_at = [&](double value) {
    const std::vector<Measurement> measurements{measured("a_mm", 0.0), measured("g_mm", value)};
    return score_rubric(rubric, measurements).score_milli;
  };
  EXPECT_EQ(score_at(0.0), 39000);
  EXPECT_EQ(score_at(1.0), 100000);
}

TEST(Ledger, ScalingGivesTheRestToTheLargestRemainders) {
  const std::vector<std::int64_t> thirds{1, 1, 1, 0};
  const std::vector<std::int64_t> scaled = scale_to_total(thirds, 100, 3, 100);
  EXPECT_EQ(scaled, (std::vector<std::int64_t>{34, 33, 33, 0}));
}

TEST(Ledger, EarnedAndLostAreMeasuredExactly) {
  rc::check([] {
    const ScoreCard card = any_card();
    RC_ASSERT(card.earned_milli + sum_of_losses(card) == card.measured_milli);
    RC_ASSERT(card.earned_milli >= 0 && card.score_milli >= 0 && card.score_milli <= 100000);
  });
}

TEST(Ledger, ShownLossesAddUpToWhatTheScoreLacks) {
  rc::check([] {
    const ScoreCard card = any_card();
    RC_ASSERT(card.shown_losses_milli.size() == card.ledger.size());
    const std::int64_t lacking = card.measured_milli == 0 ? 0 : 100000 - card.score_milli;
    RC_ASSERT(sum_of_shown_losses(card) == lacking);
    for (std::size_t index = 0; index < card.ledger.size(); ++index) {
      RC_ASSERT(card.shown_losses_milli[index] >= 0);
      const bool is_loss = card.ledger[index].points_lost_milli > 0;
      RC_ASSERT(is_loss || card.shown_losses_milli[index] == 0);
    }
  });
}

TEST(Ledger, NoScoreStandsAboveATriggeredCap) {
  rc::check([] {
    const ScoreCard card = any_card();
    for (const database::GateResult& result : card.gates) {
      RC_ASSERT(!result.is_triggered || card.score_milli <= result.cap_milli);
    }
  });
}

}  // namespace
}  // namespace hallux::assessment

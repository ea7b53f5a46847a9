#include "assessment/shown_points.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdlib>

#include "tests/assessment/any_card.h"

namespace hallux::assessment {
namespace {

using database::LedgerKind;
using database::ScoreCard;
using scenarios::Rubric;

std::int64_t lost_of_kind(const ScoreCard& card, const ShownPoints& shown, bool is_of_gates) {
  std::int64_t sum = 0;
  for (std::size_t line = 0; line < card.ledger.size(); ++line)
    if ((card.ledger[line].kind == LedgerKind::Gate) == is_of_gates)
      sum += shown.lines[line].lost_milli;
  return sum;
}

/// What the lines of one group lost, gates left out.
std::int64_t lost_in(const ScoreCard& card, const ShownPoints& shown, const std::string& group) {
  std::int64_t sum = 0;
  for (std::size_t line = 0; line < card.ledger.size(); ++line) {
    const bool is_gate = card.ledger[line].kind == LedgerKind::Gate;
    if (!is_gate && card.ledger[line].group == group) sum += shown.lines[line].lost_milli;
  }
  return sum;
}

/// Of 100, exactly.
double exact(const ScoreCard& card, std::int64_t rubric_milli) {
  return 100.0 * static_cast<double>(rubric_milli) / static_cast<double>(card.measured_milli);
}

double points(std::int64_t milli) { return static_cast<double>(milli) / 1000.0; }

/// What Silver measures: 50 of 100 points, one group of five items.
ScoreCard silver_card(double angle_mm) {
  Rubric rubric;
  rubric.groups = {{"accuracy", "Accuracy", 50000, ""}, {"safety", "Safety", 50000, ""}};
  rubric.items = {item("A1", "accuracy", 16000), item("A2", "accuracy", 34000)};
  return score_rubric(rubric, std::vector{measured("A1_mm", angle_mm), measured("A2_mm", 0.0)});
}

TEST(ShownPoints, AreOfAHundredAlthoughHalfOfTheRubricIsMeasured) {
  const ShownPoints shown = shown_points(silver_card(0.55));
  EXPECT_EQ(shown.lines[0].lost_milli, 17600);
  EXPECT_EQ(shown.lines[0].possible_milli, 32000);
  EXPECT_EQ(shown.lines[1].lost_milli, 0);
  EXPECT_EQ(shown.lines[1].possible_milli, 68000);
  EXPECT_EQ(shown.groups[0].earned_milli, 82400);
  EXPECT_EQ(shown.groups[0].possible_milli, 100000);
  EXPECT_EQ(shown.groups[1].possible_milli, 0);
  EXPECT_EQ(shown.score_milli, 82400);
}

TEST(ShownPoints, ALossTooSmallToShowIsStillSaid) {
  const ScoreCard card = silver_card(0.001);
  const ShownPoints shown = shown_points(card);
  EXPECT_EQ(shown.score_milli + shown.lines[0].lost_milli, 100000);
  EXPECT_EQ(lost_points_text(card.ledger[0], shown.lines[0]), "less than 0.1");
  EXPECT_EQ(lost_points_text(card.ledger[1], shown.lines[1]), "0");
}

TEST(ShownPoints, WithNothingMeasuredThereIsNothingToShow) {
  const ShownPoints shown = shown_points(score_rubric(Rubric{}, {}));
  EXPECT_EQ(shown.score_milli, 0);
  EXPECT_TRUE(shown.lines.empty());
}

TEST(ShownPoints, OfThreeThirdsTheOneThatIsLostEarnsNothing) {
  Rubric rubric;
  for (const std::string name : {"a", "b", "c"}) {
    rubric.groups.push_back({name, name, 10000, ""});
    rubric.items.push_back(item(name, name, 10000));
  }
  const ScoreCard card = score_rubric(
      rubric, std::vector{measured("a_mm", 1.0), measured("b_mm", 0.0), measured("c_mm", 0.0)});
  const ShownPoints shown = shown_points(card);
  EXPECT_EQ(shown.score_milli, 66700);
  EXPECT_EQ(shown.lines[0].lost_milli, 33300);
  EXPECT_EQ(shown.groups[0].earned_milli, 0);
  EXPECT_EQ(shown.groups[1].earned_milli + shown.groups[2].earned_milli, 66700);
}

TEST(ShownPoints, WeightsBeforeAnAttemptAreThoseAfterIt) {
  Rubric rubric;
  rubric.groups = {{"accuracy", "", 50000, ""}, {"tools", "", 42000, ""}, {"safety", "", 8000, ""}};
  rubric.items = {item("A1", "accuracy", 8000), item("A2", "accuracy", 42000),
                  item("H1", "safety", 8000)};
  const ShownWeights weights = shown_weights(rubric);
  EXPECT_EQ(weights.groups_milli, (std::vector<std::int64_t>{86200, 0, 13800}));
  const ShownPoints shown = shown_points(score_rubric(
      rubric, std::vector{measured("A1_mm", 0.5), measured("A2_mm", 0.2), measured("H1_mm", 0.1)}));
  for (std::size_t line = 0; line < 3; ++line)
    EXPECT_EQ(shown.lines[line].possible_milli, weights.items_milli[line]);
}

TEST(ShownPoints, TheShareThatWasMeasuredIsNoNumberOfPoints) {
  EXPECT_EQ(measured_share_text(silver_card(0.0)), "50 %");
}

TEST(ShownPoints, LostAndScoreAreAHundredAsPrinted) {
  rc::check([] {
    const ScoreCard card = any_card();
    const ShownPoints shown = shown_points(card);
    const std::int64_t whole = card.measured_milli == 0 ? 0 : 100000;
    const std::int64_t lost = lost_of_kind(card, shown, false) + lost_of_kind(card, shown, true);
    RC_ASSERT(lost + shown.score_milli == whole);
    for (const ShownLine& line : shown.lines) RC_ASSERT(line.lost_milli % 100 == 0);
  });
}

TEST(ShownPoints, GroupsAddUpToTheScoreBeforeGates) {
  rc::check([] {
    const ScoreCard card = any_card();
    const ShownPoints shown = shown_points(card);
    std::int64_t possible = 0, earned = 0;
    for (std::size_t group = 0; group < card.groups.size(); ++group) {
      const ShownGroup& each = shown.groups[group];
      RC_ASSERT(each.earned_milli >= 0 && each.earned_milli % 100 == 0);
      RC_ASSERT(each.possible_milli ==
                each.earned_milli + lost_in(card, shown, card.groups[group].name));
      possible += each.possible_milli;
      earned += each.earned_milli;
    }
    RC_ASSERT(possible == (card.measured_milli == 0 ? 0 : 100000));
    RC_ASSERT(earned == shown.score_milli + lost_of_kind(card, shown, true));
  });
}

TEST(ShownPoints, NoughtsStayNoughtsAndNothingIsFarFromTheExactNumber) {
  rc::check([] {
    const ScoreCard card = any_card();
    const ShownPoints shown = shown_points(card);
    if (card.measured_milli == 0) return;
    for (std::size_t line = 0; line < card.ledger.size(); ++line) {
      const ShownLine& each = shown.lines[line];
      const database::LedgerLine& exactly = card.ledger[line];
      RC_ASSERT(exactly.points_lost_milli > 0 || each.lost_milli == 0);
      RC_ASSERT(std::abs(points(each.lost_milli) - exact(card, exactly.points_lost_milli)) < 0.3);
      if (exactly.kind == LedgerKind::Gate) continue;
      RC_ASSERT(each.lost_milli <= each.possible_milli);
      RC_ASSERT(std::abs(points(each.possible_milli) - exact(card, exactly.weight_milli)) < 0.3);
      if (exactly.points_lost_milli == exactly.weight_milli)
        RC_ASSERT(each.lost_milli == each.possible_milli);
    }
    for (std::size_t group = 0; group < card.groups.size(); ++group) {
      const database::GroupScore& exactly = card.groups[group];
      const ShownGroup& each = shown.groups[group];
      RC_ASSERT(exactly.earned_milli > 0 || each.earned_milli == 0);
      RC_ASSERT(std::abs(points(each.earned_milli) - exact(card, exactly.earned_milli)) < 0.3);
      RC_ASSERT(std::abs(points(each.possible_milli) - exact(card, exactly.measured_milli)) < 0.3);
    }
  });
}

}  // namespace
}  // namespace hallux::assessment

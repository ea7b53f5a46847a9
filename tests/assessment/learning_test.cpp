#include "assessment/learning.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hallux::assessment {
namespace {

std::vector<bool> runs(std::size_t count, bool has_passed = true) {
  return std::vector<bool>(count, has_passed);
}

TEST(Learning, TheWeightsOfARunAreThePublishedOnes) {
  EXPECT_NEAR(gain_of_pass(), 0.2513, 5e-5);
  EXPECT_NEAR(loss_of_failure(), 1.0986, 5e-5);
  EXPECT_EQ(clean_runs_needed(), 12);
}

TEST(Learning, TwelveCleanRunsAreNeededAndElevenAreNotEnough) {
  EXPECT_FALSE(learning_state(runs(11)).is_competent);
  EXPECT_EQ(learning_state(runs(11)).clean_runs(), 11);
  EXPECT_TRUE(learning_state(runs(12)).is_competent);
  EXPECT_EQ(learning_state(runs(12)).clean_runs(), 12);
}

TEST(Learning, AFailureCostsMoreThanFourCleanRunsAndNeverGoesBelowNothing) {
  std::vector<bool> passed = runs(5);
  passed.push_back(false);
  EXPECT_EQ(learning_state(passed).clean_runs(), 1);
  passed.push_back(false);
  EXPECT_EQ(learning_state(passed).evidence, 0.0);
  passed.push_back(true);
  EXPECT_NEAR(learning_state(passed).evidence, gain_of_pass(), 1e-12);
  EXPECT_EQ(learning_state(passed).evidence_by_run.size(), passed.size());
}

TEST(Learning, ThreeFailuresAfterTheDeclarationAreASlip) {
  std::vector<bool> passed = runs(12);
  passed.insert(passed.end(), 2, false);
  EXPECT_TRUE(learning_state(passed).is_competent);
  passed.push_back(false);
  EXPECT_TRUE(learning_state(passed).has_slipped);
  EXPECT_FALSE(learning_state(passed).is_competent);
  EXPECT_EQ(learning_state(passed).evidence, 0.0);
  passed.insert(passed.end(), 12, true);
  EXPECT_TRUE(learning_state(passed).is_competent);
  EXPECT_FALSE(learning_state(passed).has_slipped);
}

TEST(Learning, NobodyIsCompetentWithoutARun) {
  EXPECT_FALSE(learning_state({}).is_competent);
  EXPECT_FALSE(learning_state({}).has_slipped);
  EXPECT_EQ(learning_state({}).clean_runs(), 0);
}

TEST(Learning, AMedianRunsOverTheLastFew) {
  EXPECT_EQ(running_median({3.0, 1.0, 2.0, 10.0, 4.0, 5.0}, 5),
            (std::vector<double>{3.0, 2.0, 2.0, 2.5, 3.0, 4.0}));
  EXPECT_TRUE(running_median({}, 5).empty());
}

}  // namespace
}  // namespace hallux::assessment

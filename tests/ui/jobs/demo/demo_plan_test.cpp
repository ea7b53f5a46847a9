#include "ui/jobs/demo/demo_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace hallux::ui {

namespace {

TEST(DemoPlan, TellsWhatHappenedInOrderAndWithinTheCourse) {
  const std::vector<DemoAttempt> attempts = plan_demo_attempts(2, 6);
  ASSERT_EQ(attempts.size(), 26U);
  std::int64_t before = 0;
  for (const DemoAttempt& attempt : attempts) {
    EXPECT_GE(attempt.minute, before);
    EXPECT_LT(attempt.minute + 60, demo_minutes) << "nothing of it lies in the future";
    before = attempt.minute;
  }
}

TEST(DemoPlan, GivesEachTraineeACurveAndEachAttemptAHandOfItsOwn) {
  std::map<int, double> skill;
  std::set<std::uint64_t> seeds;
  std::set<std::size_t> scenarios;
  std::map<int, int> last;
  for (const DemoAttempt& attempt : plan_demo_attempts(2, 6)) {
    EXPECT_GE(attempt.skill, skill[attempt.trainee]);
    EXPECT_LE(attempt.skill, 1.0);
    skill[attempt.trainee] = std::min(attempt.skill + 0.05, 1.0);
    EXPECT_TRUE(seeds.insert(attempt.seed).second);
    scenarios.insert(attempt.scenario);
    last[attempt.trainee] += attempt.is_last;
    EXPECT_TRUE(attempt.kind == database::AttemptKind::Practice || attempt.is_last);
  }
  EXPECT_EQ(skill.size(), static_cast<std::size_t>(demo_trainees));
  EXPECT_EQ(scenarios.size(), 2U);
  for (const auto& [trainee, count] : last) EXPECT_EQ(count, 1) << trainee;
}

TEST(DemoPlan, IsTheSameEachTimeAndCanBeShortened) {
  const std::vector<DemoAttempt> one = plan_demo_attempts(2, 1);
  ASSERT_EQ(one.size(), 8U);
  for (const DemoAttempt& attempt : one) {
    EXPECT_TRUE(attempt.is_last);
    EXPECT_EQ(attempt.kind, database::AttemptKind::Practice);
  }
  EXPECT_EQ(plan_demo_attempts(2, 6)[13].seed, plan_demo_attempts(2, 6)[13].seed);
}

TEST(DemoPlan, MixesHandsFromNoviceToExpert) {
  const scenarios::HandSkill novice = scenarios::hand_skill("novice");
  const scenarios::HandSkill expert = scenarios::hand_skill("expert");
  EXPECT_DOUBLE_EQ(skill_between(0.0).angle_mean_deg, novice.angle_mean_deg);
  EXPECT_DOUBLE_EQ(skill_between(1.0).angle_mean_deg, expert.angle_mean_deg);
  EXPECT_DOUBLE_EQ(skill_between(0.0).push.exit_newton, novice.push.exit_newton);
  EXPECT_DOUBLE_EQ(skill_between(1.0).meet_deviation_mm, expert.meet_deviation_mm);
  EXPECT_DOUBLE_EQ(skill_between(0.0).perception.reaction_s, novice.perception.reaction_s);
  EXPECT_DOUBLE_EQ(skill_between(1.0).cooling.forgets_water, expert.cooling.forgets_water);
  EXPECT_DOUBLE_EQ(skill_between(0.5).wander_mm, (novice.wander_mm + expert.wander_mm) / 2);
  EXPECT_EQ(demo_hand_name(0.349), "scripted, skill 0.35");
}

}  // namespace

}  // namespace hallux::ui

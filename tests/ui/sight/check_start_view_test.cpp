#include "ui/sight/check_start_view.h"

#include <gtest/gtest.h>

#include "scenarios/scenario_error.h"

namespace hallux::ui {
namespace {

class Checked : public testing::Test {
 protected:
  scenarios::Scenario scenario_ = [] {
    scenarios::Scenario scenario = scenarios::load_shipped_scenario("silver");
    scenario.patient.edge_mm = 1.0;
    return scenario;
  }();
  simulator::Bone bone_ = make_patient_bones(scenario_).front();
  scenarios::Plan plan_ = plan_on(scenario_, bone_);

  StartViewCheck check() { return check_start_view(scenario_, bone_, plan_, "mine.json"); }
  std::string refusal() {
    try {
      check();
    } catch (const scenarios::ScenarioError& error) {
      return error.what();
    }
    return {};
  }
};

TEST_F(Checked, AShippedStartShowsItsCut) {
  const StartViewCheck checked = check();
  ASSERT_TRUE(checked.judgement) << checked.why_not_drawn;
  EXPECT_TRUE(is_good(*checked.judgement));
}

TEST_F(Checked, AViewFromBehindTheBoneIsRefusedWithWhatHidesTheCut) {
  scenario_.start->eye_in_bone = -scenario_.start->eye_in_bone;
  const std::string sentence = refusal();
  EXPECT_TRUE(sentence.starts_with("mine.json: start: this view hides its own cut: ")) << sentence;
  EXPECT_NE(sentence.find("the bone hides the most; choose another eye_in_bone"), std::string::npos)
      << sentence;
}

TEST_F(Checked, AViewThatEndsBeforeItsCutIsRefusedWithItsRadius) {
  scenario_.start->radius_mm = 5.0;
  EXPECT_NE(refusal().find("picture's edge hides the most; raise radius_mm"), std::string::npos)
      << refusal();
}

TEST_F(Checked, WhatSaysNoStartIsJudgedByTheViewThatItOpensWith) {
  scenario_.start.reset();
  const std::string sentence = refusal();
  EXPECT_TRUE(
      sentence.starts_with("mine.json: no start is said, and the default view hides the cut: "))
      << sentence;
  EXPECT_NE(sentence.find("the bone hides the most; say a start: choose another eye_in_bone"),
            std::string::npos)
      << sentence;
}

}  // namespace
}  // namespace hallux::ui

// The whole of a chevron by the hand without errors: sawn, wired, shifted, screwed, trimmed.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "assessment/rebuild/bodies.h"
#include "assessment/rebuild/implants.h"
#include "scenarios/faces/windowed_region.h"
#include "scenarios/tray/laid_out_tools.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::scenarios {
namespace {

using simulator::CutEventKind;

/// On a coarse patient.
class Chevron : public testing::Test {
 protected:
  static Scenario coarse() {
    Scenario scenario = load_shipped_scenario("chevron");
    scenario.patient.edge_mm = 0.9;
    return scenario;
  }
  void operate(std::vector<HandFault> faults = {}) {
    FeelingHand hand(scenario_, bone_, plan_, with_faults(hand_skill("perfect"), std::move(faults)),
                     1);
    recording_ = tests::run_hand(scenario_, bone_, plan_, hand).recording;
  }
  std::ptrdiff_t count(CutEventKind kind) const {
    return std::ranges::count(recording_.events, kind, &simulator::CutEvent::kind);
  }

  Scenario scenario_ = coarse();
  simulator::Bone bone_ = make_patient_bones(scenario_).front();
  Plan plan_ = plan_on(scenario_, bone_);
  simulator::Recording recording_;
};

TEST_F(Chevron, IsCarriedOutWhole) {
  operate();
  EXPECT_EQ(count(CutEventKind::StepDone), std::ssize(scenario_.steps));
  EXPECT_EQ(count(CutEventKind::ToolRefused), 0);
  EXPECT_EQ(count(CutEventKind::GripRefused), 0);
  EXPECT_EQ(count(CutEventKind::ImplantRefused), 0);
  EXPECT_EQ(count(CutEventKind::MetalMet), 0);
  EXPECT_EQ(count(CutEventKind::ImplantLeft), 3);
  EXPECT_EQ(count(CutEventKind::ImplantTaken), 2) << "both wires come out again";
  EXPECT_EQ(count(CutEventKind::ScrewSeated), 1);
  const auto rebuilt = assessment::rebuild(bone_, tray_of(scenario_), recording_);
  const auto bodies = assessment::bodies_of(rebuilt, plan_, bone_);
  const auto placements = assessment::placements_of(bodies, rebuilt, plan_);
  const auto fixation = assessment::fixation_of(recording_, rebuilt, bodies, bone_, plan_);
  const auto held = assessment::held_by(fixation, bodies);
  const auto head = std::ranges::find(bodies, "head", &assessment::Body::name);
  ASSERT_NE(head, bodies.end());
  const auto index = static_cast<std::size_t>(head - bodies.begin());
  EXPECT_NEAR(placements[index].moved_mm, 5.1, 0.1) << "5 mm to lateral, 1 mm as the kerfs close";
  EXPECT_NEAR(*placements[index].error_mm, 1.0, 0.1);
  EXPECT_LT(*placements[index].error_deg, 0.5);
  for (const auto& placement : placements) EXPECT_LT(placement.overlap_max_mm, 0.05);
  ASSERT_EQ(fixation.implants.size(), 1U);
  EXPECT_EQ(fixation.implants[0].engages.size(), 2U);
  EXPECT_TRUE(held[index]);
  ASSERT_EQ(fixation.taken.size(), 2U);
  for (const auto& wire : fixation.taken) EXPECT_TRUE(wire.planned.has_value());
}

TEST_F(Chevron, AHandWithFaultsDoesWhatTheySay) {
  operate({{FaultKind::ShiftBy, "head", 2.0},
           {FaultKind::WrongBlade, "dorsal_arm", 0.0},
           {FaultKind::Skip, "fix", 0.0}});
  EXPECT_EQ(count(CutEventKind::ScrewSeated), 0);
  const auto chosen =
      std::ranges::find(recording_.events, CutEventKind::ToolChosen, &simulator::CutEvent::kind);
  ASSERT_NE(chosen, recording_.events.end());
  const auto rebuilt = assessment::rebuild(bone_, tray_of(scenario_), recording_);
  const auto bodies = assessment::bodies_of(rebuilt, plan_, bone_);
  const auto placements = assessment::placements_of(bodies, rebuilt, plan_);
  const auto head = std::ranges::find(bodies, "head", &assessment::Body::name);
  ASSERT_NE(head, bodies.end());
  EXPECT_NEAR(placements[static_cast<std::size_t>(head - bodies.begin())].moved_mm, 7.1, 0.15);
}

TEST(WindowedRegion, IsCutOffAtTheWindowsBorders) {
  simulator::SectionRegion square;
  square.contours = {{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}}};
  square.min_mm = {0.0, 0.0};
  square.max_mm = {4.0, 4.0};
  square.area_mm2 = 16.0;
  FaceWindow window;
  window.from_in_bone_mm = {1.0, 0.0, 0.0};
  EXPECT_NEAR(within_window(square, {}, window).area_mm2, 12.0, 1e-12);
  EXPECT_EQ(within_window(square, {}, window).min_mm.x, 1.0);
  window.low_mm = 1.0;
  window.high_mm = 2.0;
  const simulator::SectionRegion strip = within_window(square, {}, window);
  EXPECT_NEAR(strip.area_mm2, 3.0, 1e-12);
  EXPECT_EQ(strip.max_mm, Vec2(4.0, 2.0));
  window.from_in_bone_mm = {5.0, 0.0, 0.0};
  EXPECT_TRUE(within_window(square, {}, window).contours.empty());
}

}  // namespace
}  // namespace hallux::scenarios

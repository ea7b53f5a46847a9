// A novice whose wedge, opened medially, lies nearest to the plan when it is turned over.
#include <gtest/gtest.h>

#include <cmath>

#include "assessment/assess.h"
#include "assessment/ledger.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::assessment {
namespace {

constexpr std::uint64_t seed = 85574;

TEST(NoviceWedge, AWedgeThatIsOpenMediallyIsNotScoredAsTurnedOver) {
  const scenarios::Scenario scenario = scenarios_test::format_1("akin");
  const simulator::Bone bone = make_patient_bones(scenario).front();
  const simulator::Recording recording = tests::run_hand(scenario, bone, "novice", seed).recording;
  const Examination examination = assess_fully(scenario, bone, recording, "scripted");
  const std::string hinge = scenario.hinges.at(0).name;
  const Measurement* error =
      find_measurement(examination.measurements, "wedge_error_deg", "", hinge);
  ASSERT_NE(error, nullptr);
  // 7.95 degrees were taken out of ten; turned over they would be 17.95 off.
  EXPECT_NEAR(std::abs(error->value), 2.05, 0.05);
  const auto kerf_of = [&](std::size_t cut) { return examination.faces.at(cut).at(0).kerf; };
  EXPECT_EQ(kerf_of(0), 0);
  EXPECT_EQ(kerf_of(1), 1);
}

}  // namespace
}  // namespace hallux::assessment

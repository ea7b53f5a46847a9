/// What a scenario says of its saw is what an attempt and its replay are made with.
#include "scenarios/simulation_setup.h"
#include "tests/scenarios/format_1/format_1.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace hallux::scenarios {
namespace {

using simulator::Guidance;

simulator::SimulationSetup setup_of(const nlohmann::json& json,
                                    Guidance guidance = Guidance::None) {
  const simulator::Bone bone;
  return simulation_setup(parse_scenario(json.dump(), "altered.json"), bone, {}, guidance);
}

nlohmann::json silver() { return nlohmann::json::parse(scenarios_test::format_1("silver").text); }

TEST(SimulationSetup, HasTheSawOfTheScenario) {
  nlohmann::json scenario = silver();
  EXPECT_EQ(setup_of(scenario).tray.first_saw().cycles_per_minute, 12000.0);
  EXPECT_EQ(setup_of(scenario).tray.first_saw().sharpness, 1.0);
  scenario["blade"]["sharpness"] = 0.6;
  scenario["blade"]["width_mm"] = 7.5;
  scenario["blade"]["thickness_mm"] = 0.3;
  EXPECT_EQ(setup_of(scenario).tray.first_saw().sharpness, 0.6);
  EXPECT_EQ(setup_of(scenario).tray.first_saw().blade.width_mm, 7.5);
  EXPECT_EQ(setup_of(scenario).tray.first_saw().blade.thickness_mm, 0.3);
}

TEST(SimulationSetup, HasTheQualityOfThePatientsBone) {
  nlohmann::json scenario = silver();
  EXPECT_EQ(setup_of(scenario).contact.bone_quality, 1.0);
  scenario["patient"]["bone_quality"] = 0.7;
  EXPECT_EQ(setup_of(scenario).contact.bone_quality, 0.7);
}

TEST(SimulationSetup, GuidesOnlyWhereItIsAskedTo) {
  EXPECT_EQ(setup_of(silver()).contact.guide.guidance, Guidance::None);
  EXPECT_EQ(setup_of(silver(), Guidance::Slot).contact.guide.guidance, Guidance::Slot);
}

}  // namespace
}  // namespace hallux::scenarios

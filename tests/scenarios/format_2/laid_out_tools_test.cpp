#include "scenarios/tray/laid_out_tools.h"

#include <gtest/gtest.h>

#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/format_2/fixtures.h"

namespace hallux::scenarios {
namespace {

TEST(LaidOutTools, AreTheOneBladeOfAnOperationThatSetsNoImplants) {
  const Scenario scenario = scenarios_test::format_1("silver");
  const auto tools = laid_out_tools(scenario);
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_EQ(std::get<simulator::Saw>(tools[0].tool).blade, scenario.saw.blade);
  EXPECT_EQ(tray_of(scenario).count(), 1);
}

TEST(LaidOutTools, BeginWithTheBladesAndGoOnWithWhatSetsImplants) {
  const Scenario chevron = scenarios_test::fixture("chevron");
  const auto tools = laid_out_tools(chevron);
  EXPECT_EQ(tools[0].name, "wide");
  EXPECT_EQ(tools[1].name, "narrow");
  EXPECT_EQ(tools[2].name, "wire 0.9");
  const simulator::Tray tray = tray_of(chevron);
  ASSERT_EQ(tray.count(), static_cast<std::int32_t>(tools.size()));
  for (const char* name : {"wire 1.25", "wire 2.0", "drill 2.0", "screw 2.7x24", "screw 3.5x40"}) {
    const auto place = place_of(tools, name);
    ASSERT_TRUE(place) << name;
    EXPECT_GT(simulator::bored_radius_mm(tray[*place]), 0.0) << name;
  }
  const auto& driver = std::get<simulator::Screwdriver>(tray[*place_of(tools, "screw 2.7x24")]);
  EXPECT_EQ(driver.screw.length_mm, 24.0);
  EXPECT_TRUE(is_made(driver.screw));
  EXPECT_FALSE(place_of(tools, "screw 9x1"));
}

}  // namespace
}  // namespace hallux::scenarios

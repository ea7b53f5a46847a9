/// What a scenario says of its saw is what an attempt and its replay are made with.
#include "ui/jobs/attempt_jobs.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace hallux::ui {
namespace {

using simulator::Guidance;

scenarios::Scenario silver_with_sharpness(double sharpness) {
  nlohmann::json silver = nlohmann::json::parse(scenarios::load_shipped_scenario("silver").text);
  silver["blade"]["sharpness"] = sharpness;
  return scenarios::parse_scenario(silver.dump(), "dull.json");
}

TEST(ContactSettingsOfAScenario, AreThoseOfItsBlade) {
  const scenarios::Scenario silver = scenarios::load_shipped_scenario("silver");
  EXPECT_EQ(contact_settings(silver, {}, Guidance::None).cycles_per_minute, 12000.0);
  EXPECT_EQ(contact_settings(silver, {}, Guidance::None).sharpness, 1.0);
  EXPECT_EQ(contact_settings(silver_with_sharpness(0.6), {}, Guidance::None).sharpness, 0.6);
}

TEST(ContactSettingsOfAScenario, AreThoseOfItsPatientsBone) {
  nlohmann::json silver = nlohmann::json::parse(scenarios::load_shipped_scenario("silver").text);
  const auto quality = [&] {
    const auto scenario = scenarios::parse_scenario(silver.dump(), "soft.json");
    return contact_settings(scenario, {}, Guidance::None).bone_quality;
  };
  EXPECT_EQ(quality(), 1.0);
  silver["patient"]["bone_quality"] = 0.7;
  EXPECT_EQ(quality(), 0.7);
}

TEST(ContactSettingsOfAnAttempt, GuideOnlyWhereItAsksForIt) {
  const scenarios::Scenario silver = scenarios::load_shipped_scenario("silver");
  EXPECT_EQ(contact_settings(silver, {}, Guidance::None).guide.guidance, Guidance::None);
  const simulator::GuidePlan guide = contact_settings(silver, {}, Guidance::Slot).guide;
  EXPECT_EQ(guide.guidance, Guidance::Slot);
}

}  // namespace
}  // namespace hallux::ui

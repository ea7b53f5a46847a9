// What the panels say of a blade against the plan is what the rubric scores, value by value.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "assessment/points.h"
#include "scenarios/metric_names.h"
#include "simulator/base/units.h"
#include "tests/ui/screens/operating/shown_panels.h"

namespace hallux::ui {
namespace {

using scenarios::Metric;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr double step = 0.29, most = 10.0, at_edge = 0.02;

std::string words_of_points(const scenarios::RubricItem& item, double value) {
  const std::int64_t points = assessment::points_milli(item, value);
  if (points == item.weight_milli) return ": full points";
  return points > 0 ? ": some points are lost" : ": no points are left";
}

struct PlanPanels : ShownPanels {
  using ShownPanels::ShownPanels;

  void show(const scenarios::Rubric& rubric, const std::string& cut, const PlanReading& blade) {
    hud.plan = {blade, {}, bands_of(rubric, cut)};
    driver.frame();
  }
};

/// Each item of a scenario's cuts that a panel shows, at values from nothing to beyond its band.
void expect_scored(PlanPanels& panels, const scenarios::Scenario& scenario,
                   const scenarios::RubricItem& item) {
  const bool is_angle = item.metric == name_of(Metric::AngleDeg);
  if (item.cut.empty() || (!is_angle && item.metric != name_of(Metric::LocationMm))) return;
  for (double value = 0.01; value < most; value += step) {
    if (std::abs(value - item.full) < at_edge || std::abs(value - item.zero) < at_edge) continue;
    PlanReading blade;
    // Most of the angle is about one axis: the other reads next to nothing.
    blade.angle_rad = blade.roll_rad = radian_from_degree(value);
    blade.distance_mm = -value;
    panels.show(scenario.rubric, item.cut, blade);
    const std::string told = panels.told(is_angle ? "operate.plan.angle" : "operate.plan.distance");
    EXPECT_THAT(told, EndsWith(words_of_points(item, value))) << item.id << " at " << value;
    for (const char* part : {"operate.plan.pitch", "operate.plan.roll", "operate.plan.along"})
      EXPECT_THAT(panels.told(part), testing::Not(HasSubstr("points"))) << part;
  }
}

class PlanPanel : public testing::TestWithParam<float> {};

TEST_P(PlanPanel, SaysOfEachValueWhatTheRubricScores) {
  PlanPanels panels(GetParam(), {1280.0F, 720.0F});
  for (const auto& shipped : scenarios::shipped_scenarios()) {
    const scenarios::Scenario scenario =
        scenarios::load_shipped_scenario(std::filesystem::path(shipped.name).stem().string());
    for (const scenarios::RubricItem& item : scenario.rubric.items)
      expect_scored(panels, scenario, item);
  }
}

TEST_P(PlanPanel, IsWholeWithTheWidestValues) {
  PlanPanels panels(GetParam(), {1280.0F, 720.0F});
  const scenarios::Scenario scenario = scenarios::load_shipped_scenario("silver");
  PlanReading blade;
  blade.pitch_rad = blade.roll_rad = -1.5;
  blade.angle_rad = 1.5;
  blade.distance_mm = -88.8;
  panels.show(scenario.rubric, scenario.cuts.front().name, blade);
  ASSERT_TRUE(panels.driver.has("operate.panel.plan"));
  EXPECT_THAT(panels.driver.faults(), IsEmpty());
  EXPECT_THAT(panels.told("operate.plan.roll"), StartsWith("Tilt across −85.9°"));
  EXPECT_THAT(panels.told("operate.plan.distance"), StartsWith("Offset −88.8 mm"));
  for (const char* words : {"Angle", "Tilt along", "Tilt across", "Offset", "Along", "−88.8 mm"})
    EXPECT_TRUE(panels.driver.sees(words)) << words;
}

INSTANTIATE_TEST_SUITE_P(Scales, PlanPanel, testing::Values(0.8F, 1.0F, 1.25F, 1.5F));

TEST(PlanPanel, HasNoSignsWhereNothingIsScored) {
  PlanPanels panels;
  PlanReading blade;
  blade.roll_rad = blade.angle_rad = 0.5;
  panels.show({}, "first", blade);
  EXPECT_EQ(panels.told("operate.plan.angle"), "Angle 28.6°");
  EXPECT_FALSE(panels.driver.sees("full "));
}

TEST(ForceMeter, ShowsTheRangeThatTheHintsAskFor) {
  ShownPanels panels;
  panels.hud.force_newton = 8.5;
  panels.driver.frame();
  EXPECT_EQ(panels.told("operate.force"), "Push force 8.5 N (usual 6 to 14 N)");
  panels.hud.push = gentle_push;
  panels.driver.frame();
  EXPECT_EQ(panels.told("operate.force"), "Push force 8.5 N (usual 2.5 to 5 N)");
  EXPECT_THAT(panels.driver.faults(), IsEmpty());
}

}  // namespace
}  // namespace hallux::ui

// The bands that are shown while somebody saws are those by which the score is made.
#include "ui/screens/operating/hud/cut_bands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "assessment/points.h"
#include "scenarios/metric_names.h"

namespace hallux::ui {
namespace {

constexpr double step = 0.01, most = 12.0;

BandState state_of(const scenarios::RubricItem& item, double value) {
  const std::int64_t points = assessment::points_milli(item, value);
  if (points == item.weight_milli) return BandState::Full;
  return points > 0 ? BandState::Partial : BandState::None;
}

/// From nothing to beyond every band; the last thousandth of a point may be rounded away or up.
void expect_alike(const LiveBand& band, const scenarios::RubricItem& item) {
  for (double value = 0.5 * step; value < most; value += step) {
    const bool is_at_edge =
        std::abs(value - band.full) < step || std::abs(value - band.zero) < step;
    if (is_at_edge) continue;
    EXPECT_EQ(state_in(band, value), state_of(item, value)) << item.id << " at " << value;
    EXPECT_EQ(state_in(band, -value), state_in(band, value));
  }
}

TEST(CutBands, ShowWhatTheRubricOfEachShippedOperationScores) {
  for (const auto& shipped : scenarios::shipped_scenarios()) {
    const scenarios::Scenario scenario =
        scenarios::load_shipped_scenario(std::filesystem::path(shipped.name).stem().string());
    int of_all = 0;
    for (const scenarios::ReferenceCut& cut : scenario.cuts) {
      const CutBands bands = bands_of(scenario.rubric, cut.name);
      int shown = 0;
      for (const scenarios::RubricItem& item : scenario.rubric.items) {
        if (item.cut != cut.name) continue;
        if (item.metric == name_of(scenarios::Metric::AngleDeg)) {
          ASSERT_TRUE(bands.angle_deg) << item.id;
          expect_alike(*bands.angle_deg, item);
          ++shown;
        }
        if (item.metric == name_of(scenarios::Metric::LocationMm)) {
          ASSERT_TRUE(bands.location_mm) << item.id;
          expect_alike(*bands.location_mm, item);
          ++shown;
        }
      }
      EXPECT_EQ(shown, bands.angle_deg.has_value() + bands.location_mm.has_value()) << cut.name;
      of_all += shown;
    }
    EXPECT_GT(of_all, 0) << shipped.name;
  }
}

TEST(CutBands, AreNoneWhereTheRubricMeasuresNothingOfTheCut) {
  const CutBands bands = bands_of(scenarios::Rubric(), "first");
  EXPECT_FALSE(bands.angle_deg);
  EXPECT_FALSE(bands.location_mm);
}

}  // namespace
}  // namespace hallux::ui

/// The rubrics that come with the program, on random sets of measurements.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "assessment/ledger.h"
#include "assessment/number_text.h"
#include "simulator/device/device_class.h"

namespace hallux::assessment {
namespace {

using scenarios::Gate;
using scenarios::Rubric;
using scenarios::RubricItem;

/// RapidCheck draws a hundred times: with both operations ten thousand sets.
constexpr int sets_per_draw = 50;

/// Of the whole range from the first draw on, where RapidCheck begins with small ones.
int any_below(int count) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, count)); }

double any_between(double low, double high) {
  return low + (high - low) * any_below(1001) / 1000.0;
}

/// About the knots and beyond both ends of them.
double any_value(const RubricItem& item) {
  const double low = item.is_band ? item.zero_low : std::min(item.full, item.zero);
  const double high = item.is_band ? item.zero_high : std::max(item.full, item.zero);
  const double beyond = 0.3 * (high - low) + 0.1;
  return rounded_to_micro(any_between(low - beyond, high + beyond));
}

template <typename Part>
Measurement of(const Part& part, double value) {
  Measurement made;
  made.metric = part.metric;
  made.cut = part.cut;
  made.hinge = part.hinge;
  made.zone = part.zone;
  made.fragment = part.fragment;
  made.implant = part.implant;
  made.value = value;
  return made;
}

Absence any_absence() {
  return *rc::gen::element(Absence::NotMade, Absence::NotDone, Absence::Undefined,
                           Absence::NotRecorded);
}

/// Some of them are not there at all, some have no value, some are of an unfinished cut.
std::vector<Measurement> any_measurements(const Rubric& rubric) {
  std::vector<Measurement> all;
  for (const RubricItem& item : rubric.items) {
    const int fate = any_below(20);
    if (fate == 0 || find_measurement(all, item) != nullptr) continue;
    all.push_back(of(item, any_value(item)));
    if (fate < 4) all.back().absence = any_absence();
    if (fate > 16) all.back().done_fraction = any_between(0.0, 1.0);
  }
  for (const Gate& gate : rubric.gates) {
    if (any_below(4) == 0 || find_measurement(all, gate) != nullptr) continue;
    all.push_back(of(gate, any_between(gate.limit - 1.0, gate.limit + 1.0)));
  }
  return all;
}

Rubric any_shipped(const std::string& name) {
  const std::string_view device_class = *rc::gen::elementOf(simulator::device_classes);
  return rubric_for(scenarios::load_shipped_scenario(name).rubric, device_class);
}

std::int64_t sum_of(const std::vector<std::int64_t>& parts) {
  return std::accumulate(parts.begin(), parts.end(), std::int64_t{0});
}

void expect_adds_up(const database::ScoreCard& card) {
  std::int64_t lost_milli = 0;
  for (const database::LedgerLine& line : card.ledger) {
    RC_ASSERT(line.points_lost_milli >= 0);
    lost_milli += line.points_lost_milli;
  }
  RC_ASSERT(card.earned_milli + lost_milli == card.measured_milli);
  RC_ASSERT(card.measured_milli > 0);
  RC_ASSERT(card.score_milli + sum_of(card.shown_losses_milli) == 100000);
  for (const std::int64_t shown_milli : card.shown_losses_milli) RC_ASSERT(shown_milli >= 0);
}

/// The same measurement, worse by this for the item.
void worsen(Measurement& measurement, const RubricItem& item, double by) {
  double sign = item.zero > item.full ? 1.0 : -1.0;
  if (item.is_band) {
    const double middle = 0.5 * (item.full_low + item.full_high);
    sign = measurement.value >= middle ? 1.0 : -1.0;
  }
  measurement.value = rounded_to_micro(measurement.value + sign * by);
}

class ShippedRubric : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedRubric, LossesAndScoreAreAlwaysAHundred) {
  EXPECT_TRUE(rc::check([&] {
    const Rubric rubric = any_shipped(GetParam());
    for (int set = 0; set < sets_per_draw; ++set)
      expect_adds_up(score_rubric(rubric, any_measurements(rubric)));
  }));
}

TEST_P(ShippedRubric, ToMeasureWorseNeverRaisesTheScore) {
  EXPECT_TRUE(rc::check([&] {
    const Rubric rubric = any_shipped(GetParam());
    for (int set = 0; set < sets_per_draw; ++set) {
      std::vector<Measurement> all = any_measurements(rubric);
      const std::int64_t before_milli = score_rubric(rubric, all).score_milli;
      const auto picked =
          static_cast<std::size_t>(any_below(static_cast<int>(rubric.items.size())));
      const RubricItem& item = rubric.items[picked];
      const auto measurement = std::find_if(all.begin(), all.end(), [&](const Measurement& each) {
        return &each == find_measurement(all, item);
      });
      if (measurement == all.end()) continue;
      const bool is_step = item.full == item.zero && !item.is_band;
      const double range = is_step ? 1.0 : std::abs(item.zero - item.full) + item.zero_high;
      worsen(*measurement, item, any_between(0.0, range));
      const std::int64_t after_milli = score_rubric(rubric, all).score_milli;
      if (after_milli > before_milli) RC_FAIL("worse " + item.id + " earned more");
    }
  }));
}

TEST_P(ShippedRubric, FullMarksAreAHundredAndNoneIsNought) {
  const Rubric rubric = rubric_for(scenarios::load_shipped_scenario(GetParam()).rubric, "mouse");
  std::vector<Measurement> full, none;
  for (const RubricItem& item : rubric.items) {
    full.push_back(of(item, item.is_band ? item.full_low : item.full));
    none.push_back(of(item, item.is_band ? item.zero_high : item.zero));
  }
  EXPECT_EQ(score_rubric(rubric, full).score_milli, 100000);
  EXPECT_EQ(score_rubric(rubric, full).measured_milli, 100000) << "every point has a metric";
  EXPECT_EQ(score_rubric(rubric, none).score_milli, 0);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedRubric, ::testing::Values("akin", "chevron", "silver"),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace hallux::assessment

// The bounds of what samples and ticks tell hold against the same attempt of which every second
// tick was recorded, as a tape does whose lines cover two.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "assessment/assess.h"
#include "assessment/rebuild/bound.h"
#include "simulator/contact/heat.h"
#include "simulator/contact/heat_law.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::assessment {
namespace {

using simulator::Recording;

/// Lines and samples of every second tick; the sawing's planes and events stay.
Recording thinned(const Recording& whole) {
  Recording thin;
  thin.engine = whole.engine;
  thin.events = whole.events;
  for (std::size_t index = 1; index < whole.tape.size(); index += 2) {
    simulator::TapeLine line = whole.tape[index];
    line.tick = whole.tape[index - 1].tick;
    line.ticks = 2;
    thin.tape.push_back(line);
  }
  for (std::size_t index = 1; index < whole.samples.size(); index += 2)
    thin.samples.push_back(whole.samples[index]);
  return thin;
}

/// A touch is a state of a tick: one that lasts no longer parts two stretches in the air, and where
/// it is not recorded they are one.
bool is_by_touches(const Measurement& made) { return made.metric == "air_cutting_s"; }

void expect_half_the_ticks_hold(const char* operation, const char* hand, std::uint64_t seed) {
  scenarios::Scenario scenario = scenarios::load_shipped_scenario(operation);
  scenario.patient.edge_mm = 1.2;
  const simulator::Bone bone = make_patient_bones(scenario).front();
  const Recording recording = tests::run_hand(scenario, bone, hand, seed).recording;
  const auto fine = assess_fully(scenario, bone, recording, "scripted").measurements;
  const auto coarse = assess_fully(scenario, bone, thinned(recording), "scripted").measurements;
  ASSERT_EQ(coarse.size(), fine.size());
  int compared = 0;
  for (std::size_t index = 0; index < coarse.size(); ++index) {
    const Measurement& each = coarse[index];
    ASSERT_EQ(each.metric, fine[index].metric);
    if (!each.is_measured() || scenarios::is_counted(*scenarios::find_metric(each.metric)))
      continue;
    if (is_by_touches(each)) continue;
    EXPECT_NEAR(each.value, fine[index].value, each.bound)
        << each.metric << " " << each.cut << each.hinge << each.zone;
    ++compared;
  }
  EXPECT_GT(compared, 30);
}

TEST(TickBounds, HoldForANoviceWhoPlungesAndBurns) {
  expect_half_the_ticks_hold("akin", "novice", 3);
}

TEST(TickBounds, HoldForANoviceAtSilver) { expect_half_the_ticks_hold("silver", "novice", 3); }

/// The dose of a cell that is heated for so long and left alone then, in steps of `ticks`.
double dose_min(double heating_celsius_per_s, double heated_s, bool is_rinsed, int ticks) {
  const double span_s = 0.001 * ticks;
  const simulator::Cooling cooling = simulator::cooling_over(span_s, is_rinsed);
  double celsius = simulator::body_celsius, dose = 0.0;
  for (int step = 0; step * span_s < 30.0; ++step) {
    const bool is_heated = step * span_s < heated_s;
    const double before_celsius = celsius;
    celsius = simulator::warmed_celsius(celsius, is_heated ? heating_celsius_per_s : 0.0, cooling);
    dose += simulator::dose_rate(0.5 * (before_celsius + celsius)) * span_s / 60.0;
  }
  return dose;
}

// Blades pass a cell in a tenth of a second and more; the limit is 16 minutes.
TEST(HeatSteps, MakeADoseNearTheLimitKnownWithinAQuarter) {
  int near = 0;
  for (const double heated_s : {0.096, 0.192, 0.48, 1.6, 6.4}) {
    for (const bool is_rinsed : {false, true}) {
      for (double heating = 2.0; heating < 800.0; heating *= 1.05) {
        const double coarse = dose_min(heating, heated_s, is_rinsed,
                                       static_cast<int>(simulator::HeatField::group_count));
        if (coarse < 8.0 || coarse > 32.0) continue;
        const double ratio = coarse / dose_min(heating, heated_s, is_rinsed, 1);
        EXPECT_LT(std::max(ratio, 1.0 / ratio), 1.25) << heating << " " << heated_s;
        ++near;
      }
    }
  }
  EXPECT_GT(near, 20);
}

}  // namespace
}  // namespace hallux::assessment

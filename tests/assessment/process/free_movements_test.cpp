#include "assessment/process/free_movements.h"

#include <gtest/gtest.h>

#include <vector>

#include "assessment/metrics/smoothness.h"
#include "tests/assessment/process/made_recording.h"

namespace hallux::assessment {
namespace {

constexpr double exact = 1e-6;
constexpr double rate_hz = 1000.0;

/// One hump for each of `humps`, above the least speed of a movement all along.
std::vector<double> movement(std::size_t ticks, int humps) {
  std::vector<double> speeds_mm_s;
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    const double turn = 2.0 * pi * humps * static_cast<double>(tick) / static_cast<double>(ticks);
    speeds_mm_s.push_back(6.0 + 40.0 * (1.0 - std::cos(turn)));
  }
  return speeds_mm_s;
}

void add(HandleStretch& stretch, const std::vector<double>& speeds_mm_s,
         std::uint32_t status = testing::running) {
  stretch.speed_mm_s.insert(stretch.speed_mm_s.end(), speeds_mm_s.begin(), speeds_mm_s.end());
  stretch.status.insert(stretch.status.end(), speeds_mm_s.size(), status);
}

void rest(HandleStretch& stretch) { add(stretch, std::vector<double>(50, 4.999)); }

Smoothness smoothness_of(const HandleStretch& stretch) {
  return measure_smoothness(free_movements(std::span(&stretch, 1)));
}

TEST(FreeMovements, TwoTellNothingAndThreeTheirMedian) {
  HandleStretch stretch{.first_tick = 1000, .speed_mm_s = {}, .status = {}};
  for (const int humps : {1, 3}) {
    add(stretch, movement(400, humps));
    rest(stretch);
  }
  EXPECT_FALSE(smoothness_of(stretch).sparc);
  EXPECT_FALSE(smoothness_of(stretch).ldlj);
  add(stretch, movement(400, 2));
  const Smoothness smoothness = smoothness_of(stretch);
  EXPECT_NEAR(smoothness.sparc->value, spectral_arc_length(movement(400, 2), rate_hz), exact);
  EXPECT_NEAR(smoothness.ldlj->value, log_dimensionless_jerk(movement(400, 2), rate_hz), exact);
  // The roughest is shown: the second, of three humps.
  EXPECT_EQ(smoothness.sparc->first_tick, 1450);
  EXPECT_EQ(smoothness.sparc->last_tick, 1849);
  EXPECT_EQ(smoothness.ldlj->first_tick, 1450);
}

TEST(FreeMovements, WhoseSpeedNeverBendsHaveNoJerkToTellOf) {
  HandleStretch stretch;
  for (int part = 0; part < 3; ++part) {
    add(stretch, std::vector<double>(400, 20.0));
    rest(stretch);
  }
  EXPECT_FALSE(smoothness_of(stretch).ldlj);
  EXPECT_TRUE(std::isfinite(smoothness_of(stretch).sparc->value));
}

TEST(FreeMovements, LastThreeTenthsOfASecond) {
  HandleStretch stretch;
  for (const std::size_t ticks : {400U, 400U, 299U}) {
    add(stretch, movement(ticks, 1));
    rest(stretch);
  }
  EXPECT_FALSE(smoothness_of(stretch).sparc);
  add(stretch, movement(300, 1));
  EXPECT_TRUE(smoothness_of(stretch).sparc);
}

TEST(FreeMovements, EndWhereTeethTouchBoneOrAKerfHoldsTheBlade) {
  for (const std::uint32_t status : {testing::contact, testing::in_kerf}) {
    HandleStretch stretch;
    for (int part = 0; part < 3; ++part) {
      add(stretch, movement(400, 1));
      rest(stretch);
    }
    EXPECT_TRUE(smoothness_of(stretch).sparc);
    // A touch in the middle of the second leaves two halves too short to count.
    stretch.status[450 + 200] |= status;
    EXPECT_FALSE(smoothness_of(stretch).sparc) << status;
  }
}

TEST(FreeMovements, OfSeveralStretchesCountTogether) {
  std::vector<HandleStretch> stretches(3);
  for (HandleStretch& stretch : stretches) add(stretch, movement(350, 1));
  EXPECT_NEAR(measure_smoothness(free_movements(stretches)).sparc->value,
              spectral_arc_length(movement(350, 1), rate_hz), exact);
  EXPECT_FALSE(measure_smoothness({}).ldlj);
}

}  // namespace
}  // namespace hallux::assessment

#include "assessment/process/pushes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/assessment/process/made_recording.h"

namespace hallux::assessment {
namespace {

using simulator::Recording;
using testing::add_line;
using testing::add_lines;

constexpr double exact = 1e-6;

testing::MadeLine sawing(double push_newton) {
  return {.status = testing::cutting, .force_newton = {-push_newton, 0.0, 0.0}};
}

TEST(Pushes, OfASquareForceIsItsHeight) {
  Recording recording;
  add_lines(recording, sawing(5.0), 100);
  add_lines(recording, sawing(12.5), 20);
  add_lines(recording, sawing(5.0), 100);
  const Finding peak = measure_pushes(recording).peak_newton.value();
  EXPECT_NEAR(peak.value, 12.5, exact);
  EXPECT_EQ(peak.first_tick, 100);
  EXPECT_EQ(peak.last_tick, 119);
}

TEST(Pushes, OfTenMillisecondsIsHalfOfWhatWasAdded) {
  Recording recording;
  add_lines(recording, sawing(5.0), 100);
  add_lines(recording, sawing(15.0), 10);
  add_lines(recording, sawing(5.0), 100);
  EXPECT_NEAR(measure_pushes(recording).peak_newton->value, 10.0, exact);
}

TEST(Pushes, ASpikeOfOneTickCostsATwentiethOfIt) {
  Recording recording;
  add_lines(recording, sawing(6.0), 100);
  add_line(recording, sawing(86.0));
  add_lines(recording, sawing(6.0), 100);
  const Pushes pushes = measure_pushes(recording);
  EXPECT_NEAR(pushes.peak_newton->value, 6.0 + 80.0 / 20.0, exact);
  EXPECT_NEAR(pushes.p95_newton->value, 6.0, exact);
}

TEST(Pushes, TakeTheForceInAllDirections) {
  Recording recording;
  add_lines(recording, {.status = testing::cutting, .force_newton = {2.0, -3.0, 6.0}}, 20);
  EXPECT_NEAR(measure_pushes(recording).peak_newton->value, 7.0, exact);
}

TEST(Pushes, CountOnlyWhereTeethAdvance) {
  Recording recording;
  add_lines(recording, {.status = testing::contact, .force_newton = {40.0, 0.0, 0.0}}, 100);
  EXPECT_FALSE(measure_pushes(recording).peak_newton);
  EXPECT_FALSE(measure_pushes(recording).p95_newton);
  EXPECT_FALSE(measure_pushes(recording).side_newton);
  add_lines(recording, sawing(3.0), 20);
  EXPECT_NEAR(measure_pushes(recording).peak_newton->value, 3.0, exact);
}

// Of 19 ticks, a pause of any kind, and 19 ticks again no twenty follow each other.
TEST(Pushes, AGapEndsAWindow) {
  for (const std::int64_t missed : {3, 100}) {
    Recording recording;
    add_lines(recording, sawing(9.0), 19);
    testing::MadeLine later = sawing(9.0);
    later.missed = missed;
    add_line(recording, later);
    add_lines(recording, sawing(9.0), 18);
    EXPECT_FALSE(measure_pushes(recording).peak_newton) << missed;
    EXPECT_NEAR(measure_pushes(recording).p95_newton->value, 9.0, exact);
    add_line(recording, sawing(9.0));
    EXPECT_NEAR(measure_pushes(recording).peak_newton->value, 9.0, exact);
  }
  Recording recording;
  add_lines(recording, sawing(9.0), 19);
  add_line(recording, {});
  add_lines(recording, sawing(9.0), 19);
  EXPECT_FALSE(measure_pushes(recording).peak_newton);
}

// Lines that cover three ticks each: six of them are 18 ticks, seven 21.
TEST(Pushes, ALineCountsForTheTicksThatItCovers) {
  Recording recording;
  add_line(recording, {});
  for (int line = 0; line < 6; ++line) add_line(recording, sawing(8.0), 3);
  EXPECT_FALSE(measure_pushes(recording).peak_newton);
  add_line(recording, sawing(18.0), 3);
  EXPECT_NEAR(measure_pushes(recording).peak_newton->value, 8.0 + 10.0 * 3.0 / 20.0, exact);
  Recording unlike;
  add_line(unlike, {});
  add_line(unlike, sawing(10.0), 3);
  add_line(unlike, sawing(20.0), 1);
  // In order: 10, 10, 10, 20; between the third and the fourth at 2.85.
  EXPECT_NEAR(measure_pushes(unlike).p95_newton->value, 18.5, exact);
}

TEST(Pushes, ThePercentileLiesBetweenNeighboursInOrder) {
  Recording recording;
  for (int push = 100; push >= 1; --push) add_line(recording, sawing(push));
  const Finding p95 = measure_pushes(recording).p95_newton.value();
  // 0.95 of the way from the first to the hundredth: 94.05 steps.
  EXPECT_NEAR(p95.value, 95.05, exact);
  EXPECT_EQ(p95.first_tick, 0);
  EXPECT_EQ(p95.last_tick, 99);
}

TEST(Pushes, TheSideLoadIsAlongTheBladesNormal) {
  Recording recording;
  // A quarter about x takes z to -y.
  const Quat turned(std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0);
  add_line(recording,
           {.status = testing::cutting, .force_newton = {9.0, 3.0, 7.0}, .rotation = turned});
  add_line(recording,
           {.status = testing::cutting, .force_newton = {9.0, -4.0, 7.0}, .rotation = turned});
  EXPECT_NEAR(measure_pushes(recording).side_newton->value, std::sqrt(12.5), exact);
}

}  // namespace
}  // namespace hallux::assessment

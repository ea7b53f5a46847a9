#include "simulator/loop/clock_watch.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

/// Read within two microseconds.
ClockReading at(milliseconds paced, milliseconds machine) {
  return {paced, machine, paced + microseconds{2}};
}

TEST(ClockWatch, SeesNoStepWhereBothClocksGoOn) {
  ClockWatch watch;
  for (int i = 0; i < 100; ++i)
    watch.observe(at(milliseconds{500 * i}, milliseconds{9000 + 501 * i}));
  EXPECT_EQ(watch.steps(), 0);
}

TEST(ClockWatch, CountsAMachineThatSleptOnce) {
  ClockWatch watch;
  watch.observe(at(milliseconds{0}, milliseconds{0}));
  watch.observe(at(milliseconds{500}, milliseconds{60'500}));
  watch.observe(at(milliseconds{1000}, milliseconds{61'000}));
  EXPECT_EQ(watch.steps(), 1);
}

TEST(ClockWatch, CountsAPacedClockThatJumpsEitherWay) {
  ClockWatch watch;
  watch.observe(at(milliseconds{1000}, milliseconds{1000}));
  watch.observe(at(milliseconds{5000}, milliseconds{1500}));
  watch.observe(at(milliseconds{2000}, milliseconds{2000}));
  EXPECT_EQ(watch.steps(), 2);
}

TEST(ClockWatch, PassesOverAReadingInWhichTheThreadWasPutAside) {
  ClockWatch watch;
  watch.observe(at(milliseconds{0}, milliseconds{0}));
  watch.observe({milliseconds{500}, milliseconds{530}, milliseconds{530}});
  watch.observe(at(milliseconds{1000}, milliseconds{1000}));
  EXPECT_EQ(watch.steps(), 0);
}

TEST(ClockWatch, ReadsThisMachinesClocksWithoutAStep) {
  ClockWatch watch;
  for (int i = 0; i < 1000; ++i) watch.observe(read_clocks());
  EXPECT_EQ(watch.steps(), 0);
}

}  // namespace
}  // namespace hallux::simulator

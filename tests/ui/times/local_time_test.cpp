#include "ui/times/local_time.h"

#include <gtest/gtest.h>

#include "tests/support/time_zone.h"

namespace hallux::ui {
namespace {

constexpr const char* central_europe = "CET-1CEST,M3.5.0,M10.5.0/3";

TEST(LocalTimes, FollowTheZoneOfTheMachineThroughSummerAndWinter) {
  const TimeZone zone(central_europe);
  EXPECT_EQ(moment_text("2026-01-03T14:02:59.123Z"), "3 Jan 2026, 15:02");
  EXPECT_EQ(full_moment_text("2026-01-03T14:02:59.123Z"), "3 Jan 2026, 15:02 +01:00");
  EXPECT_EQ(full_moment_text("2026-07-03T14:02:59.123Z"), "3 Jul 2026, 16:02 +02:00");
  EXPECT_EQ(moment_text("2025-12-31T23:30:00Z"), "1 Jan 2026, 00:30");
  EXPECT_EQ(date_text("2025-12-31T23:30:00Z"), "1 Jan 2026");
  EXPECT_EQ(moment_text("2026-01-03T14:02"), "3 Jan 2026, 15:02") << "without seconds";
}

TEST(LocalTimes, OfOtherZonesAreThoseOfTheirClocks) {
  {
    const TimeZone nepal("NPT-5:45");
    EXPECT_EQ(full_moment_text("2026-03-03T14:02:59Z"), "3 Mar 2026, 19:47 +05:45");
  }
  const TimeZone newfoundland("NST3:30");
  EXPECT_EQ(full_moment_text("2026-03-03T02:00:00Z"), "2 Mar 2026, 22:30 -03:30");
}

TEST(LocalTimes, AreSaidAsTheyAreWhereThereIsNoMoment) {
  const TimeZone zone(central_europe);
  for (const char* text : {"soon", "", "2026-13-03T14:02:59Z", "2026-02-31T14:02:59Z",
                           "2026-03-03T25:02:59Z", "2026-03-03"}) {
    EXPECT_EQ(moment_text(text), text);
    EXPECT_EQ(full_moment_text(text), text);
    EXPECT_FALSE(local_time(text));
  }
}

TEST(LocalTimes, CountTheDaysOfTheCalendarThatPeopleSee) {
  {
    const TimeZone utc("UTC0");
    EXPECT_EQ(days_between("2026-02-28T23:59:00Z", "2026-03-01T00:01:00Z"), 1);
    EXPECT_EQ(days_between("2026-03-01T00:01:00Z", "2026-03-01T23:59:00Z"), 0);
    EXPECT_EQ(days_between("2024-02-28T12:00:00Z", "2024-03-01T12:00:00Z"), 2) << "a leap year";
  }
  const TimeZone zone(central_europe);
  EXPECT_EQ(days_between("2026-02-28T22:30:00Z", "2026-02-28T23:30:00Z"), 1) << "past midnight";
  EXPECT_EQ(days_between("2026-02-28T23:30:00Z", "2026-03-01T00:01:00Z"), 0);
  EXPECT_EQ(days_between("", "2026-03-01T12:00:00Z"), 0);
}

}  // namespace
}  // namespace hallux::ui

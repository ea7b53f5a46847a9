#include "ui/screens/parts/course_text.h"

#include <gtest/gtest.h>

#include "tests/support/time_zone.h"
#include "ui/times/local_time.h"

namespace hallux::ui {
namespace {

TEST(CourseWords, SayHowLongAgoSomethingWas) {
  const TimeZone zone("UTC0");
  const Texts texts = english_texts();
  const std::string now = "2026-03-03T10:00:00Z";
  EXPECT_EQ(ago_text(texts, "2026-03-03T09:00:00Z", now), "Today");
  EXPECT_EQ(ago_text(texts, "2026-03-02T23:00:00Z", now), "Yesterday");
  EXPECT_EQ(ago_text(texts, "2026-02-28T23:00:00Z", now), "3 days ago");
  EXPECT_EQ(ago_text(texts, "2025-12-24T23:00:00Z", now), "24 Dec 2025");
  EXPECT_EQ(ago_text(texts, "", now), "Never");
}

TEST(CourseWords, SearchKnowsNoCapitals) {
  EXPECT_TRUE(contains_text("Mara Quill", "quill"));
  EXPECT_TRUE(contains_text("mara", ""));
  EXPECT_TRUE(contains_text("", ""));
  EXPECT_FALSE(contains_text("mara", "maria"));
}

TEST(CourseWords, OperationsAreWordsOfTheirOwn) {
  EXPECT_EQ(operation_text("akin"), "Akin");
  EXPECT_EQ(operation_text("silver_trial"), "Silver trial");
  EXPECT_EQ(operation_text(""), "");
}

TEST(CourseWords, NowIsWrittenAsTheDatabaseWritesIt) {
  EXPECT_EQ(utc_now_text().size(), std::string("2026-03-03T10:00:00Z").size());
  EXPECT_EQ(days_between(utc_now_text(), utc_now_text()), 0);
}

}  // namespace
}  // namespace hallux::ui

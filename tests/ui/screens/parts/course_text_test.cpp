#include "ui/screens/parts/course_text.h"

#include <gtest/gtest.h>

namespace hallux::ui {
namespace {

TEST(CourseWords, DaysAreThoseOfTheCalendar) {
  EXPECT_EQ(days_between("2026-02-28T23:59:00Z", "2026-03-01T00:01:00Z"), 1);
  EXPECT_EQ(days_between("2026-03-01T00:01:00Z", "2026-03-01T23:59:00Z"), 0);
  EXPECT_EQ(days_between("2024-02-28T12:00:00Z", "2024-03-01T12:00:00Z"), 2) << "a leap year";
  EXPECT_EQ(days_between("", "2026-03-01T12:00:00Z"), 0);
}

TEST(CourseWords, SayHowLongAgoSomethingWas) {
  const Texts texts = english_texts();
  const std::string now = "2026-03-03T10:00:00Z";
  EXPECT_EQ(ago_text(texts, "2026-03-03T09:00:00Z", now), "Today");
  EXPECT_EQ(ago_text(texts, "2026-03-02T23:00:00Z", now), "Yesterday");
  EXPECT_EQ(ago_text(texts, "2026-02-28T23:00:00Z", now), "3 days ago");
  EXPECT_EQ(ago_text(texts, "2025-12-24T23:00:00Z", now), "24 Dec 2025");
  EXPECT_EQ(ago_text(texts, "", now), "Never");
}

TEST(CourseWords, SearchKnowsNoCapitals) {
  EXPECT_TRUE(holds_text("Mara Quill", "quill"));
  EXPECT_TRUE(holds_text("mara", ""));
  EXPECT_TRUE(holds_text("", ""));
  EXPECT_FALSE(holds_text("mara", "maria"));
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

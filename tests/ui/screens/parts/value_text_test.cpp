#include "ui/screens/parts/value_text.h"

#include <gtest/gtest.h>

namespace hallux::ui {
namespace {

TEST(Words, PointsHaveOneDecimal) {
  EXPECT_EQ(points_text(76830), "76.8");
  EXPECT_EQ(points_text(76850), "76.9");
  EXPECT_EQ(points_text(100000), "100.0");
  EXPECT_EQ(points_text(0), "0.0");
  EXPECT_EQ(points_text(-1250), "-1.3");
}

TEST(Words, AMomentIsADayAndATime) {
  EXPECT_EQ(moment_text("2026-03-03T14:02:59Z"), "3 Mar 2026, 14:02");
  EXPECT_EQ(moment_text("2026-13-03T14:02:59Z"), "2026-13-03T14:02:59Z");
  EXPECT_EQ(moment_text("soon"), "soon");
}

TEST(Words, AReasonBecomesASentence) {
  EXPECT_EQ(sentence_of("could not open it"), "Could not open it.");
  EXPECT_EQ(sentence_of("Really?"), "Really?");
  EXPECT_EQ(sentence_of(""), "");
}

TEST(Words, InitialsAreOfTheFirstAndTheLastWord) {
  EXPECT_EQ(initials_of("trainee-12"), "T1");
  EXPECT_EQ(initials_of("Administrator"), "A");
  EXPECT_EQ(initials_of("a b c"), "AC");
  EXPECT_EQ(initials_of("\u0141 \u00f3"), "\u0141\u00f3")
      << "letters beyond ASCII stay as they are written";
  EXPECT_EQ(initials_of(""), "");
  EXPECT_EQ(initials_of(" - "), "");
}

TEST(Words, NamesOfFilesAreRead) {
  EXPECT_EQ(file_name_text("first_proximal_phalanx"), "first proximal phalanx");
  EXPECT_EQ(file_name_text(""), "");
}

}  // namespace
}  // namespace hallux::ui

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

TEST(Words, AReasonBecomesASentence) {
  EXPECT_EQ(sentence_of("could not open it"), "Could not open it.");
  EXPECT_EQ(sentence_of("Really?"), "Really?");
  EXPECT_EQ(sentence_of("bad.json: line 3 has no end"), "bad.json: line 3 has no end.")
      << "a file is called as it is";
  EXPECT_EQ(sentence_of("/tmp/x: is no folder"), "/tmp/x: is no folder.");
  EXPECT_EQ(sentence_of("stopped."), "Stopped.");
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
  EXPECT_EQ(initials_of("Zed \U0001F600"), "Z") << "no word begins with a picture";
  EXPECT_EQ(initials_of("漢字 かな"), "漢か");
}

TEST(Words, NamesOfFilesAreRead) {
  EXPECT_EQ(file_name_text("first_proximal_phalanx"), "first proximal phalanx");
  EXPECT_EQ(file_name_text(""), "");
}

}  // namespace
}  // namespace hallux::ui

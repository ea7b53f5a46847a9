#include "ui/render/rest.h"

#include <gtest/gtest.h>

#include <vector>

namespace hallux::ui {
namespace {

TEST(Rest, WaitsThenTakesItsSamplesThenDrawsNothing) {
  Rest rest({.samples = 4, .waits = 2});
  std::vector<Drawing> drawn{rest.next(false, true)};
  EXPECT_FALSE(rest.is_finished());
  for (int frame = 0; frame < 8; ++frame) drawn.push_back(rest.next(true, false));
  using enum Drawing;
  EXPECT_EQ(drawn,
            (std::vector{Moving, Moving, Moving, First, Sample, Sample, Sample, Kept, Kept}));
  EXPECT_TRUE(rest.is_finished());
}

TEST(Rest, EndsInTheFrameThatChanges) {
  for (int frames = 0; frames < 9; ++frames) {
    Rest rest({.samples = 4, .waits = 2});
    for (int frame = 0; frame < frames; ++frame) rest.next(true, false);
    EXPECT_EQ(rest.next(false, false), Drawing::Moving) << frames;
    EXPECT_EQ(rest.samples(), 0);
    EXPECT_FALSE(rest.is_finished());
  }
}

TEST(Rest, AFrameThatAnswersDrawsNoSampleAndKeepsThoseThereAre) {
  Rest rest({.samples = 4, .waits = 2});
  for (int frame = 0; frame < 4; ++frame) rest.next(true, false);
  ASSERT_EQ(rest.samples(), 2);
  EXPECT_EQ(rest.next(true, true), Drawing::Kept);
  EXPECT_EQ(rest.next(true, false), Drawing::Kept) << "waits again";
  EXPECT_EQ(rest.next(true, false), Drawing::Kept);
  EXPECT_EQ(rest.next(true, false), Drawing::Sample);
  EXPECT_EQ(rest.samples(), 3);
}

TEST(Rest, WithoutWaitingTheFirstFrameThatIsTheSameBegins) {
  Rest rest({.samples = 2, .waits = 0});
  EXPECT_EQ(rest.next(false, false), Drawing::Moving);
  EXPECT_EQ(rest.next(true, false), Drawing::First);
  EXPECT_EQ(rest.next(true, false), Drawing::Sample);
  EXPECT_EQ(rest.next(true, false), Drawing::Kept);
}

}  // namespace
}  // namespace hallux::ui

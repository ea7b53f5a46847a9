#include "ui/jobs/frame_times.h"

#include <gtest/gtest.h>

namespace hallux::ui {
namespace {

TEST(FrameTimes, OfNoFramesAreNotThere) { EXPECT_FALSE(frame_times({}).has_value()); }

TEST(FrameTimes, AreTimesThatAFrameTook) {
  const auto one = frame_times({0.25});
  ASSERT_TRUE(one.has_value());
  EXPECT_EQ(one->median_ms, 0.25);
  EXPECT_EQ(one->p99_ms, 0.25);
  EXPECT_EQ(one->max_ms, 0.25);

  std::vector<double> frame_ms;
  for (int i = 200; i > 0; --i) frame_ms.push_back(i);
  const auto many = frame_times(frame_ms);
  ASSERT_TRUE(many.has_value());
  EXPECT_EQ(many->median_ms, 100.0);
  EXPECT_EQ(many->p99_ms, 198.0);
  EXPECT_EQ(many->max_ms, 200.0);
}

}  // namespace
}  // namespace hallux::ui

#include "simulator/step/hinge_requests.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

/// Wants a hinge and asks for it at once.
bool ask(HingeRequests& hinges, std::int32_t hinge, bool is_kerf_growing = false) {
  hinges.want(hinge);
  return hinges.ask(is_kerf_growing);
}

TEST(HingeRequests, AreAskedOnceForAWish) {
  HingeRequests hinges;
  EXPECT_FALSE(hinges.is_wanted());
  hinges.want(1);
  EXPECT_TRUE(hinges.is_wanted());
  EXPECT_TRUE(hinges.ask(false));
  EXPECT_EQ(hinges.asked(), 1);
  EXPECT_FALSE(hinges.is_wanted());
}

TEST(HingeRequests, DropAWishWhileTheKerfGrows) {
  HingeRequests hinges;
  EXPECT_FALSE(ask(hinges, 0, true));
  EXPECT_FALSE(hinges.is_wanted());
}

TEST(HingeRequests, DropAWishWhileTheJobIsUnderWay) {
  HingeRequests hinges;
  EXPECT_TRUE(ask(hinges, 0));
  EXPECT_FALSE(ask(hinges, 0));
  hinges.apply(false);
  EXPECT_TRUE(ask(hinges, 0)) << "a refused closing may be tried again";
}

TEST(HingeRequests, CloseEachOnce) {
  HingeRequests hinges;
  EXPECT_TRUE(ask(hinges, 0));
  EXPECT_FALSE(hinges.is_closed(0));
  hinges.apply(true);
  EXPECT_TRUE(hinges.is_closed(0));
  EXPECT_FALSE(ask(hinges, 0));
  EXPECT_TRUE(ask(hinges, 1)) << "another one is open";
}

TEST(HingeRequests, DropAHingeThatThereIsNot) {
  HingeRequests hinges;
  EXPECT_FALSE(ask(hinges, -1));
  EXPECT_TRUE(ask(hinges, 1000)) << "the job says what it is not";
  hinges.apply(false);
  EXPECT_FALSE(hinges.is_closed(1000));
}

}  // namespace
}  // namespace hallux::simulator

#include "simulator/step/hinge_requests.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

TEST(HingeRequests, AreAskedOnceForAWish) {
  HingeRequests hinge;
  EXPECT_FALSE(hinge.is_wanted());
  hinge.want();
  EXPECT_TRUE(hinge.is_wanted());
  EXPECT_TRUE(hinge.ask(false));
  EXPECT_FALSE(hinge.is_wanted());
}

TEST(HingeRequests, DropAWishWhileTheKerfGrows) {
  HingeRequests hinge;
  hinge.want();
  EXPECT_FALSE(hinge.ask(true));
  EXPECT_FALSE(hinge.is_wanted());
}

TEST(HingeRequests, DropAWishWhileTheJobIsUnderWay) {
  HingeRequests hinge;
  EXPECT_TRUE(hinge.ask(false));
  hinge.want();
  EXPECT_FALSE(hinge.ask(false));
  hinge.apply(false);
  hinge.want();
  EXPECT_TRUE(hinge.ask(false)) << "a refused closing may be tried again";
}

TEST(HingeRequests, CloseOnce) {
  HingeRequests hinge;
  EXPECT_TRUE(hinge.ask(false));
  EXPECT_FALSE(hinge.is_closed());
  hinge.apply(true);
  EXPECT_TRUE(hinge.is_closed());
  hinge.want();
  EXPECT_FALSE(hinge.ask(false));
}

}  // namespace
}  // namespace hallux::simulator

#include "ui/screens/operating/pausing.h"

#include <gtest/gtest.h>

namespace hallux::ui {
namespace {

TEST(Pausing, KeepsTheCauseThatCameFirst) {
  Pausing pausing;
  EXPECT_FALSE(pausing.go_on()) << "it runs";
  EXPECT_TRUE(pausing.pause(PausedBy::Locked));
  EXPECT_FALSE(pausing.pause(PausedBy::Person));
  EXPECT_EQ(pausing.by(), PausedBy::Locked);
  EXPECT_TRUE(pausing.go_on());
  EXPECT_TRUE(pausing.pause(PausedBy::Person));
  EXPECT_EQ(pausing.by(), PausedBy::Person);
}

TEST(Pausing, GoesOnOnlyWithRoomOnTheDisk) {
  Pausing pausing;
  pausing.pause(PausedBy::Person);
  pausing.wait_for_room();
  EXPECT_TRUE(pausing.is_paused());
  EXPECT_TRUE(pausing.is_storage_full());
  EXPECT_FALSE(pausing.go_on());
  pausing.have_room();
  EXPECT_FALSE(pausing.is_storage_full());
  EXPECT_EQ(pausing.by(), PausedBy::RoomAgain);
  EXPECT_TRUE(pausing.go_on());
  EXPECT_FALSE(pausing.is_paused());
}

}  // namespace
}  // namespace hallux::ui

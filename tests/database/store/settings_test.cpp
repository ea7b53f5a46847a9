#include "database/store/settings.h"

#include <gtest/gtest.h>

#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

class Settings : public testing::Test, protected SomeCourse {};

TEST_F(Settings, AreAsShippedUntilSomebodySetsThem) {
  EXPECT_FALSE(read_setting(database(), "idle_lock_min"));
  EXPECT_EQ(read_idle_lock_min(database()), 10);
  administrator().set_idle_lock_min(25);
  EXPECT_EQ(read_idle_lock_min(database()), 25);
  EXPECT_EQ(last_audit().action, "setting_changed");
  EXPECT_EQ(last_audit().text, "25");
}

TEST_F(Settings, OfTheIdleLockHaveBounds) {
  for (const std::int32_t minutes : {-1, 0, 4, 61}) {
    EXPECT_EQ(kind_thrown([&] { administrator().set_idle_lock_min(minutes); }),
              DatabaseErrorKind::BadInput);
  }
  // Whatever somebody with another tool wrote: the window still locks.
  store_setting(database(), "idle_lock_min", "100000");
  EXPECT_EQ(read_idle_lock_min(database()), 60);
  store_setting(database(), "idle_lock_min", "never");
  EXPECT_EQ(read_idle_lock_min(database()), 10);
}

}  // namespace

}  // namespace hallux::database

#include "simulator/record/latest.h"

#include <gtest/gtest.h>

#include <thread>

namespace hallux::simulator {
namespace {

/// Parts that belong together: a reader that saw half of two values would see them differ.
struct Pair {
  std::int64_t one = 0, other = 0;
};

TEST(Latest, GivesTheFirstValueUntilSomethingWasWritten) {
  Latest<int> latest(7);
  EXPECT_EQ(latest.read(), 7);
  EXPECT_EQ(latest.read(), 7);
}

TEST(Latest, GivesTheNewestAndKeepsItUntilTheNext) {
  Latest<int> latest;
  latest.write(1);
  latest.write(2);
  latest.write(3);
  EXPECT_EQ(latest.read(), 3);
  EXPECT_EQ(latest.read(), 3);
  latest.write(4);
  EXPECT_EQ(latest.read(), 4);
}

TEST(Latest, NeverTearsAndNeverGoesBack) {
  constexpr std::int64_t writes = 200000;
  Latest<Pair> latest;
  std::jthread writer([&] {
    for (std::int64_t i = 1; i <= writes; ++i) latest.write({i, -i});
  });
  std::int64_t last = 0;
  while (last < writes) {
    const Pair seen = latest.read();
    ASSERT_EQ(seen.one, -seen.other);
    ASSERT_GE(seen.one, last);
    last = seen.one;
  }
}

}  // namespace
}  // namespace hallux::simulator

#include "simulator/base/fixed_list.h"

#include <gtest/gtest.h>

#include <vector>

namespace hallux {
namespace {

TEST(FixedList, HoldsWhatIsPushedInItsOrder) {
  FixedList<int, 3> list;
  EXPECT_EQ(list.begin(), list.end());
  list.push(7);
  list.push(5);
  EXPECT_EQ(std::vector<int>(list.begin(), list.end()), (std::vector<int>{7, 5}));
  EXPECT_EQ(list.size(), 2U);
}

TEST(FixedList, IsFullAtItsCapacity) {
  FixedList<int, 2> list;
  list.push(1);
  EXPECT_FALSE(list.is_full());
  list.push(2);
  EXPECT_TRUE(list.is_full());
}

}  // namespace
}  // namespace hallux

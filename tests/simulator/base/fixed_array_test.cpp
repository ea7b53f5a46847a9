#include "simulator/base/fixed_array.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

namespace hallux {
namespace {

TEST(FixedArray, HoldsAsManyOfTheValueAsWasAskedFor) {
  const FixedArray<double> values(1000, 2.5);
  EXPECT_EQ(values.size(), 1000U);
  EXPECT_EQ(std::accumulate(values.begin(), values.end(), 0.0), 2500.0);
}

TEST(FixedArray, OfNothingIsEmpty) {
  const FixedArray<int> none(0);
  EXPECT_EQ(none.begin(), none.end());
}

TEST(FixedArray, TakesItsOwnCopy) {
  std::array<int, 3> source{1, 2, 3};
  const FixedArray<int> values{std::span<const int>(source)};
  source[1] = 7;
  FixedArray<int> copy = values;
  copy[0] = 9;
  EXPECT_EQ(values[0], 1);
  EXPECT_EQ(values[1], 2);
  EXPECT_EQ(copy[0], 9);
  EXPECT_EQ(copy[2], 3);
}

}  // namespace
}  // namespace hallux

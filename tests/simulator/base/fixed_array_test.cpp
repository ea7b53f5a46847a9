#include "simulator/base/fixed_array.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

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

TEST(ZeroedArray, HoldsZerosUntilItIsWrittenTo) {
  ZeroedArray<std::uint64_t> words(100000);
  EXPECT_EQ(words.size(), 100000U);
  EXPECT_EQ(std::accumulate(words.begin(), words.end(), std::uint64_t{0}), 0U);
  words[77777] = 5;
  const ZeroedArray<std::uint64_t> copy = words;
  words[77777] = 6;
  EXPECT_EQ(copy[77777], 5U);
  ZeroedArray<std::uint64_t> other(3);
  other = copy;
  EXPECT_EQ(other.size(), 100000U);
  EXPECT_EQ(other[77777], 5U);
}

TEST(ZeroedArray, TouchesNothingOfWhatOthersUsedBefore) {
  constexpr std::size_t count = 4'000'000, bytes = count * sizeof(std::uint64_t);
  // What is given back here the heap would clear and hand out again.
  for (int i = 0; i < 3; ++i) FixedArray<std::uint64_t>(count, 7);
  ZeroedArray<std::uint64_t> words(count);
  words[count / 2] = 1;
  std::vector<unsigned char> in_memory(bytes / 4096 + 1);
  ASSERT_EQ(mincore(words.begin(), bytes, in_memory.data()), 0);
  const auto pages = std::count_if(in_memory.begin(), in_memory.end(),
                                   [](unsigned char page) { return (page & 1U) != 0; });
  EXPECT_GE(pages, 1);
  EXPECT_LT(pages, 1024) << "of 7813; the system may give a large page at once";
}

}  // namespace
}  // namespace hallux

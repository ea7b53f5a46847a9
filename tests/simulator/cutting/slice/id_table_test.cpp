#include "simulator/cutting/slice/id_table.h"

#include <gtest/gtest.h>

#include <map>

#include "simulator/base/random.h"

namespace hallux::tests {
namespace {

using namespace simulator;

TEST(IdTable, NumbersKeysInTheOrderInWhichTheyComeAlsoWhenMoreComeThanExpected) {
  Random random(7);
  IdTable table(10);
  std::map<std::uint64_t, std::uint32_t> expected;
  for (int i = 0; i < 20'000; ++i) {
    const std::uint64_t key = random.bits() % 5'000;
    const auto next = static_cast<std::uint32_t>(expected.size());
    const auto [entry, is_first] = expected.try_emplace(key, next);
    bool is_new = false;
    ASSERT_EQ(table.id_of(key, is_new), entry->second);
    ASSERT_EQ(is_new, is_first);
  }
  EXPECT_GT(expected.size(), 4'000U);
}

}  // namespace
}  // namespace hallux::tests

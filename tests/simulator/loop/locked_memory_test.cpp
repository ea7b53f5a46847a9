#include "simulator/loop/locked_memory.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace hallux::simulator {
namespace {

/// What the system says that this program has locked [kB].
long locked_kb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmLck:")) return std::stol(line.substr(6));
  }
  return -1;
}

rlim_t limit() {
  rlimit now{};
  EXPECT_EQ(::getrlimit(RLIMIT_MEMLOCK, &now), 0);
  return now.rlim_cur;
}

// Where the system does not grant it, nothing may have changed: this says so either way.
TEST(LockedMemory, IsLockedWhileItLivesAndAsBeforeAfterwards) {
  const rlim_t limit_before = limit();
  ASSERT_EQ(locked_kb(), 0);
  {
    const LockedMemory memory;
    if (memory.is_granted()) {
      EXPECT_GT(locked_kb(), 1000);
      EXPECT_EQ(limit(), RLIM_INFINITY);
    } else {
      EXPECT_EQ(locked_kb(), 0);
      EXPECT_EQ(limit(), limit_before);
    }
  }
  EXPECT_EQ(locked_kb(), 0);
  EXPECT_EQ(limit(), limit_before);
}

}  // namespace
}  // namespace hallux::simulator

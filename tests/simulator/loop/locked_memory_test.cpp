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

/// A sanitizer answers in the system's place that memory was locked, and locks none.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr long least_locked_kb = 0;
#else
constexpr long least_locked_kb = 1000;
#endif

// Where the system does not grant it, nothing may have changed: this says so either way.
TEST(LockedMemory, IsLockedWhileItLivesAndAsBeforeAfterwards) {
  const rlim_t limit_before = limit();
  ASSERT_EQ(locked_kb(), 0);
  {
    const LockedMemory memory;
    if (memory.is_granted()) {
      EXPECT_GE(locked_kb(), least_locked_kb);
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

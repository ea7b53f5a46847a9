#include "simulator/loop/priority.h"

#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <thread>

namespace hallux::simulator {
namespace {

int policy_now() { return ::sched_getscheduler(0) & ~SCHED_RESET_ON_FORK; }

/// Takes from the calling thread alone what root may and nobody else: any priority, whatever it is
/// allowed.
bool give_up_niceness() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct sets[_LINUX_CAPABILITY_U32S_3]{};
  if (::syscall(SYS_capget, &header, sets) != 0) return false;
  sets[0].effective &= ~(1U << static_cast<unsigned>(CAP_SYS_NICE));
  return ::syscall(SYS_capset, &header, sets) == 0;
}

// Where the system grants nothing, nothing may have changed: these say so either way. Each on a
// thread of its own, so that nothing of it is left.
TEST(RealTimePriority, IsGivenBack) {
  std::jthread([] {
    const int before = policy_now();
    {
      const RealTimePriority priority;
      EXPECT_EQ(policy_now(), priority.is_granted() ? SCHED_FIFO : before);
    }
    EXPECT_EQ(policy_now(), before);
  }).join();
}

// As a person whose group has `rtprio`: root would be let off the rule that this is about.
TEST(RealTimePriority, IsGivenBackAlsoByWhoIsNotRoot) {
  std::jthread([] {
    const int before = policy_now();
    {
      const RealTimePriority priority;
      ASSERT_TRUE(give_up_niceness());
      EXPECT_EQ(policy_now(), priority.is_granted() ? SCHED_FIFO : before);
    }
    EXPECT_EQ(policy_now(), before);
  }).join();
}

TEST(RealTimePriority, IsNotHandedToThreadsThatItStarts) {
  std::jthread([] {
    const RealTimePriority priority;
    std::jthread([] { EXPECT_EQ(policy_now(), SCHED_OTHER); }).join();
  }).join();
}

}  // namespace
}  // namespace hallux::simulator

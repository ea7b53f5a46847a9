#include "simulator/loop/priority.h"

#include <pthread.h>
#include <sys/prctl.h>

namespace hallux::simulator {

namespace {

constexpr int priority = 20;  // above all that is not real time, below the system's own
constexpr unsigned long least_slack_ns = 1, usual_slack = 0;

}  // namespace

RealTimePriority::RealTimePriority() noexcept {
  ::prctl(PR_SET_TIMERSLACK, least_slack_ns);
  if (::pthread_getschedparam(::pthread_self(), &policy_before_, &before_) != 0) return;
  sched_param wanted{};
  wanted.sched_priority = priority;
  is_granted_ = ::sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &wanted) == 0;
}

RealTimePriority::~RealTimePriority() {
  ::prctl(PR_SET_TIMERSLACK, usual_slack);
  // Who may not nice may set this flag and never clear it (sched(7)): asked for without it, the old
  // policy is refused.
  if (is_granted_) ::sched_setscheduler(0, policy_before_ | SCHED_RESET_ON_FORK, &before_);
}

}  // namespace hallux::simulator

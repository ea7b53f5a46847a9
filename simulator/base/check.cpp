#include "simulator/base/check.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace hallux {

namespace {

// The one global of the project: abort() offers no other way to reach the device that still pushes.
std::atomic<FailureAction> failure_action{nullptr};

}  // namespace

FailureAction set_failure_action(FailureAction action) noexcept {
  return failure_action.exchange(action);
}

void fail_check(const char* condition, const char* file, int line) noexcept {
  if (const FailureAction action = failure_action.load()) action();
  std::fprintf(stderr, "hallux: broken promise: %s at %s:%d\n", condition, file, line);
  std::abort();
}

}  // namespace hallux

/// CHECK: a promise between our own functions. On in every build; a broken one stops the program.
#pragma once

namespace hallux {

/// Called first when a CHECK fails, to bring a device's force to zero. Empty by default; must not
/// throw or allocate.
using FailureAction = void (*)() noexcept;

/// Sets what a failing CHECK does before it prints and aborts; returns what was set before.
/// thread  any, before the threads that may fail are started
FailureAction set_failure_action(FailureAction action) noexcept;

/// Runs the failure action, prints `condition` with its place to stderr, aborts.
[[noreturn]] void fail_check(const char* condition, const char* file, int line) noexcept;

}  // namespace hallux

#define CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::hallux::fail_check(#condition, __FILE__, __LINE__))

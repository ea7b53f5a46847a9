/// Ctrl-C as a request that long work asks about, so that it ends between two of its steps.
#pragma once

#include <functional>
#include <thread>

namespace hallux::ui {

/// Turns SIGINT and SIGTERM into a flag while it lives. One at a time.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
};

/// Whether the user asked to stop since the watch began.
bool is_interrupted() noexcept;

/// Calls `wake` once somebody asks to stop, for who waits and does not ask. One at a time.
/// needs   a watch that outlives it
class InterruptAlarm {
 public:
  /// thread  `wake`: one of its own
  explicit InterruptAlarm(std::function<void()> wake);
  ~InterruptAlarm();
  InterruptAlarm(const InterruptAlarm&) = delete;
  InterruptAlarm& operator=(const InterruptAlarm&) = delete;

 private:
  std::jthread thread_;
};

}  // namespace hallux::ui

/// Ctrl-C as a request that long work asks about, so that it ends between two of its steps.
#pragma once

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

}  // namespace hallux::ui

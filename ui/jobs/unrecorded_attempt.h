/// An operation that nobody keeps: the loop beside the window as in a live attempt, without a
/// recorder, and without a database at all.
#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "simulator/device/haptic_device.h"
#include "ui/jobs/commanded_loop.h"
#include "ui/jobs/live_attempt.h"

namespace hallux::ui {

class UnrecordedAttempt final : public CommandedLoop {
 public:
  /// Starts the loop, with the clock running.
  UnrecordedAttempt(std::shared_ptr<const PreparedCase> prepared_case,
                    std::unique_ptr<simulator::HapticDevice> device);
  /// Stops it where it still runs.
  ~UnrecordedAttempt() override;
  UnrecordedAttempt(const UnrecordedAttempt&) = delete;
  UnrecordedAttempt& operator=(const UnrecordedAttempt&) = delete;

  void abandon() final { say({simulator::CommandKind::Abandon, 0, 0}); }
  bool is_storage_full() const noexcept override { return false; }
  /// It is never sealed.
  const LiveEnd* end() const noexcept override {
    return is_over_.load(std::memory_order_acquire) ? &end_ : nullptr;
  }

 private:
  void run() noexcept;
  void operate();
  void drop_record() noexcept;

  std::shared_ptr<const PreparedCase> prepared_case_;
  std::unique_ptr<simulator::HapticDevice> device_;
  simulator::AttemptChannels channels_;
  /// The thread's until is_over_.
  LiveEnd end_;
  std::atomic<bool> is_stopping_{false}, is_over_{false};
  /// Last: joined before any of it goes.
  std::jthread thread_;
};

}  // namespace hallux::ui

/// Plays the saw through OpenAL, on a thread of its own; silent and harmless where there is no
/// sound device.
///
///     window --newest tone--> thread: four buffers of 20 ms, refilled as they are played
///
/// A tone holds for half a second: a window that hangs hums no saw.
#pragma once

#include <atomic>
#include <chrono>
#include <thread>

#include "simulator/record/latest.h"
#include "ui/sound/saw_sound.h"

namespace hallux::ui {

class SawPlayer {
 public:
  /// Opens the device on its own thread: sound servers may let one wait.
  /// ensures where there is no device, or no thread to be had, nothing else happens
  SawPlayer();
  ~SawPlayer();
  SawPlayer(const SawPlayer&) = delete;
  SawPlayer& operator=(const SawPlayer&) = delete;

  /// The tone from now on.
  /// thread  window
  void play(const SawTone& tone) noexcept;

  enum class State { Opening, Playing, NoDevice };
  State state() const noexcept { return state_.load(std::memory_order_acquire); }
  /// Buffers given to the device so far.
  long buffers() const noexcept { return buffers_.load(std::memory_order_relaxed); }

 private:
  using Clock = std::chrono::steady_clock;
  struct Said {
    SawTone tone;
    Clock::time_point at;
  };

  void run(const std::stop_token& stop);
  SawTone tone_now() noexcept;

  simulator::Latest<Said> said_;
  std::atomic<State> state_{State::Opening};
  std::atomic<long> buffers_{0};
  /// Last: joined before any of it goes.
  std::jthread thread_;
};

}  // namespace hallux::ui

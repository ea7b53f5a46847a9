/// The port's own guard of the force: a device is given none unless somebody says one again and
/// again. Inside this corner only.
///
///     force said --younger than 5 ms--> x soft start --> device
///                '--older, or a silent device--> zero, again and again; a soft start after
#pragma once

#include <chrono>
#include <cstdint>

#include "simulator/base/vector.h"

namespace hallux::simulator {

struct SaidForce {
  Vec3 in_device_newton{0.0, 0.0, 0.0};
  /// Counts what was said; 0: nothing yet.
  std::uint64_t number = 0;
};

class DeadManSwitch {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::milliseconds patience{5};
  static constexpr std::chrono::milliseconds soft_start{500};

  /// What the device may be given now. Zero where the newest force is older than the patience, is
  /// no number, or `may_push` is false; begins softly after each zero.
  Vec3 allowed(const SaidForce& newest, Time now, bool may_push) noexcept;

  /// Nobody has said a force in time.
  bool is_released() const noexcept { return is_released_; }

 private:
  std::uint64_t number_ = 0;
  /// Of the newest force, and of the first after a release.
  Time said_{}, began_{};
  bool is_released_ = true;
};

}  // namespace hallux::simulator

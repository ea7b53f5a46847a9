/// A device that somebody looks at and feels outside of any operation: exchanged with each
/// millisecond, on a thread of its own.
///
///     port <--force of a wall-- thread --newest state, reach--> window
#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "simulator/device/station/station.h"
#include "simulator/record/latest.h"

namespace hallux::ui {

/// The box in which the grip has been, in its device's frame.
struct Reach {
  Vec3 least_mm{0.0, 0.0, 0.0}, greatest_mm{0.0, 0.0, 0.0};
  bool is_known = false;

  void add(const Vec3& grip_mm) noexcept;
  Vec3 size_mm() const noexcept { return greatest_mm - least_mm; }
};

/// What a device says now.
struct FeltState {
  simulator::PortPhase phase = simulator::PortPhase::Opening;
  /// Of loading or homing [0, 1].
  double fraction = 0.0;
  simulator::DriverState said;
  Reach reach;
  /// It has motors, and a wall is felt now.
  bool has_motors = false, is_pushing = false;
};

class FeltDevice {
 public:
  /// Opens it; force_share of what it gives is the most that is felt.
  FeltDevice(std::shared_ptr<simulator::Station> station, simulator::FoundDevice device,
             double force_share);
  /// It is let go, and given nothing any more.
  ~FeltDevice();
  FeltDevice(const FeltDevice&) = delete;
  FeltDevice& operator=(const FeltDevice&) = delete;

  const simulator::FoundDevice& device() const noexcept { return device_; }
  /// thread  window
  const FeltState& state() noexcept { return state_.read(); }
  /// A wall where the grip is when a button is pressed, for as long as it is held.
  void set_wall(bool is_wanted) noexcept {
    is_wall_wanted_.store(is_wanted, std::memory_order_relaxed);
  }
  bool is_wall_wanted() const noexcept { return is_wall_wanted_.load(std::memory_order_relaxed); }
  void forget_reach() noexcept { forgets_reach_.store(true, std::memory_order_relaxed); }
  simulator::PortFigures figures() const {
    return port_ ? port_->figures() : simulator::PortFigures{};
  }
  /// Why it is away, or not to be had; none: it is well.
  simulator::TroubleReport trouble() const;

 private:
  void run(const std::stop_token& stop) noexcept;

  std::shared_ptr<simulator::Station> station_;
  simulator::FoundDevice device_;
  double force_share_;
  /// nullptr: it could not be opened.
  std::shared_ptr<simulator::DevicePort> port_;
  std::atomic<bool> is_wall_wanted_{false}, forgets_reach_{false};
  simulator::Latest<FeltState> state_;
  /// Last: joined before the rest goes.
  std::jthread thread_;
};

}  // namespace hallux::ui

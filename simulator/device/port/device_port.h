/// A port: the thread of its own that talks to a device, so that nothing the device or its library
/// does can hold the loop. Inside this corner only.
///
///     loop --force--> | slot |  --> port's thread --> driver --> library --> device
///          <--state-- | slot |  <--               <--        <--         <--
///
/// Saying and reading are an exchange of slots: no system call, no lock, no memory. The port is a
/// dead man's switch too (dead_man_switch.h). One borrower at a time says forces and reads states.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "simulator/device/device_facts.h"
#include "simulator/device/port/port.h"
#include "simulator/record/latest.h"

namespace hallux::simulator {

class DevicePort final : public Port {
 public:
  /// Opens it on the port's own thread, which goes on until the device is gone or the port is.
  explicit DevicePort(std::unique_ptr<DeviceDriver> driver);
  /// Zero force is said to the device.
  ~DevicePort() override;
  DevicePort(const DevicePort&) = delete;
  DevicePort& operator=(const DevicePort&) = delete;

  void say(const Vec3& force_in_device_newton) noexcept override;
  const PortState& newest() noexcept override { return state_.read(); }

  /// thread  any
  PortPhase phase() const noexcept { return phase_.load(std::memory_order_acquire); }
  /// Why it ended; while it runs, that it is too slow for a force, or none.
  TroubleReport trouble() const;
  DeviceDescription description() const override;
  PortFigures figures() const;

 private:
  void run(const std::stop_token& stop) noexcept;
  TroubleReport open(const std::stop_token& stop);
  void talk(const std::stop_token& stop);
  void publish(const PortState& state) noexcept;
  void note(const PortStatistics& statistics, const DriverState& said);
  void end(const TroubleReport& report) noexcept;

  std::unique_ptr<DeviceDriver> driver_;
  /// Counts what the borrower said.
  std::uint64_t number_ = 0;
  Latest<SaidForce> said_;
  Latest<PortState> state_;
  std::atomic<PortPhase> phase_{PortPhase::Opening};
  std::atomic<bool> is_slow_{false};
  mutable std::mutex mutex_;
  /// Under the mutex, with what follows.
  DeviceDescription description_;
  TroubleReport trouble_;
  PortFigures figures_;
  /// Last: joined before the rest goes.
  std::jthread thread_;
};

}  // namespace hallux::simulator

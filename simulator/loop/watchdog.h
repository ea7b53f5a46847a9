/// What the loop makes of a device's words: rounded, or a fault with the last good pose.
///
/// | fault | when | recognised after |
/// |---|---|---|
/// | Lost | the driver says that the device is gone | at once |
/// | NotFinite | a part of the pose is no number | at once |
/// | Jumped | farther than a hand moves in a tick; believed once it stays | at once |
/// | Late | a device that numbers its packets brought no new one | 3 ticks |
/// | Frozen | the same to the last bit for longer than the device says it ever is | the device's word |
///
/// A fault stands on the tape as bits, so the step holds the tool and gives no force, and a replay does the same.
#pragma once

#include <cstdint>

#include "simulator/device/haptic_device.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

class DeviceWatchdog {
 public:
  explicit DeviceWatchdog(const DevicePulse& pulse) noexcept : pulse_(pulse) {}

  /// Judges what an exchange brought: `came` is its answer, `ticks` how many the line covers.
  /// errors  none: total, allocates nothing
  /// thread  haptic
  DeviceState judge(bool came, const RawDeviceState& raw, std::int64_t ticks) noexcept;

  /// As the device said it last and was believed; not rounded.
  const RigidTransform& last_good() const noexcept { return last_good_; }

 private:
  std::uint32_t faults_in(bool came, const RawDeviceState& raw, std::int64_t ticks) noexcept;
  bool is_late(const RawDeviceState& raw, std::int64_t ticks) noexcept;
  bool is_frozen(const RawDeviceState& raw, std::int64_t ticks) noexcept;
  bool has_jumped(const RigidTransform& pose) noexcept;

  DevicePulse pulse_;
  RigidTransform last_good_;
  RawDeviceState last_;  ///< as it was said, good or not
  std::int64_t packet_ticks_ = 0, same_ticks_ = 0;
  int jumps_ = 0;
  bool has_pose_ = false;
  bool has_last_ = false;
};

}  // namespace hallux::simulator

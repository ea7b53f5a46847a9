/// What the loop makes of a device's words: rounded, or a fault with the last good pose.
/// Inside this corner only.
///
/// | fault | when | recognised after |
/// |---|---|---|
/// | Lost | the driver says that the device is gone | at once |
/// | NotFinite | NaN or infinity in the pose, or a quaternion's length outside 0.5 to 2 | at once |
/// | Jumped | farther than a hand moves or turns in the ticks of the line | at once |
/// | Late | a device that numbers its packets brought no newer one | more than 2 of its periods |
/// | Frozen | the same to the last bit for longer than the device says it is | the device's word |
///
/// Where a device jumped to is believed once it was there for 20 ticks, moving from word to word as
/// a hand does: one that leaps about is never believed. Packets are counted anew after Lost: a
/// driver that begins again numbers from its beginning.
///
/// A fault stands on the tape as bits, so the step holds the tool and gives no force, and a replay
/// does the same.
#pragma once

#include <cstdint>
#include <optional>

#include "simulator/device/haptic_device.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

class DeviceWatchdog {
 public:
  explicit DeviceWatchdog(const DevicePulse& pulse) noexcept : pulse_(pulse) {}

  /// From now on that is how it is told that the device lives.
  void expect(const DevicePulse& pulse) noexcept { pulse_ = pulse; }
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
  bool has_jumped(const RigidTransform& pose, std::int64_t ticks) noexcept;

  DevicePulse pulse_;
  RigidTransform last_good_;
  /// As it was said, good or not.
  RawDeviceState last_;
  /// The last word of a device that jumped.
  RigidTransform jumped_to_;
  /// Since it was lost.
  std::optional<std::uint64_t> newest_packet_;
  std::int64_t packet_ticks_ = 0, same_ticks_ = 0;
  /// How long it has been where it jumped to.
  std::int64_t jumped_ticks_ = 0;
  bool has_pose_ = false;
  bool has_last_ = false;
};

}  // namespace hallux::simulator

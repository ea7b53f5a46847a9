/// A device whose hand follows a motion fixed beforehand: for tests, demonstrations and robots.
#pragma once

#include <vector>

#include "simulator/device/haptic_device.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

struct HandKey {
  std::int64_t tick = 0;
  RigidTransform world_from_handle;
  /// From this key on.
  std::uint32_t switches = 0;
};

struct HandCommand {
  std::int64_t tick = 0;
  Command command;
};

/// Poses at ticks in ascending order, straight between them; commands likewise ascending.
struct HandMotion {
  std::vector<HandKey> keys;
  std::vector<HandCommand> commands;

  std::int64_t last_tick() const noexcept;
};

class ScriptedDevice final : public HapticDevice {
 public:
  /// needs   at least one key, ticks ascending
  explicit ScriptedDevice(HandMotion motion);

  DeviceDescription description() const override { return {"scripted hand", "scripted"}; }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override;

 private:
  HandMotion motion_;
  std::size_t next_key_ = 0;
};

}  // namespace hallux::simulator

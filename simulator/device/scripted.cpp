#include "simulator/device/scripted.h"

#include <algorithm>

#include "simulator/base/check.h"

namespace hallux::simulator {

std::int64_t HandMotion::last_tick() const noexcept {
  const std::int64_t last_key = keys.empty() ? 0 : keys.back().tick;
  return commands.empty() ? last_key : std::max(last_key, commands.back().tick);
}

ScriptedDevice::ScriptedDevice(HandMotion motion) : motion_(std::move(motion)) {
  CHECK(!motion_.keys.empty());
  CHECK(std::is_sorted(motion_.keys.begin(), motion_.keys.end(),
                       [](const HandKey& a, const HandKey& b) { return a.tick < b.tick; }));
}

bool ScriptedDevice::exchange(const Vec3& /*force_in_world_newton*/, std::int64_t tick,
                              RawDeviceState& state) noexcept {
  while (next_key_ < motion_.keys.size() && motion_.keys[next_key_].tick <= tick) ++next_key_;
  if (next_key_ == 0 || next_key_ == motion_.keys.size()) {
    const HandKey& key = next_key_ == 0 ? motion_.keys.front() : motion_.keys.back();
    state = {key.world_from_handle, key.switches};
    return true;
  }
  const HandKey& from = motion_.keys[next_key_ - 1];
  const HandKey& to = motion_.keys[next_key_];
  const double share =
      static_cast<double>(tick - from.tick) / static_cast<double>(to.tick - from.tick);
  state.world_from_handle = interpolate(from.world_from_handle, to.world_from_handle, share);
  state.switches = from.switches;
  return true;
}

}  // namespace hallux::simulator

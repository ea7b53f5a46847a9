#include "simulator/loop/watchdog.h"

#include <cmath>

namespace hallux::simulator {

namespace {

/// A hand does not move farther in one tick: twenty metres per second.
constexpr double jump_limit_mm = 20.0;
/// A device that stays where it jumped to for so many ticks is believed.
constexpr int jumps_believed = 20;
/// So many ticks may pass without a new packet. With the tick until the next exchange and two of transport, the motors are
/// without force 5 ms after the first packet that did not come.
constexpr std::int64_t late_ticks = 2;

std::uint32_t bit(DeviceFault fault) noexcept { return static_cast<std::uint32_t>(fault); }

bool is_finite(const RigidTransform& pose) noexcept {
  return std::isfinite(pose.translation_mm.x) && std::isfinite(pose.translation_mm.y) &&
         std::isfinite(pose.translation_mm.z) && std::isfinite(pose.rotation.w) &&
         std::isfinite(pose.rotation.x) && std::isfinite(pose.rotation.y) &&
         std::isfinite(pose.rotation.z);
}

}  // namespace

DeviceState DeviceWatchdog::judge(bool came, const RawDeviceState& raw,
                                  std::int64_t ticks) noexcept {
  DeviceState state;
  state.faults = faults_in(came, raw, ticks);
  const bool has_jumped_only = state.faults == bit(DeviceFault::Jumped);
  if (state.faults == 0 || (has_jumped_only && jumps_ >= jumps_believed)) {
    last_good_ = raw.world_from_handle;
  }
  if (state.faults == 0 || has_jumped_only) state.switches = raw.switches;
  state.world_from_handle = quantise(last_good_);
  return state;
}

/// At most one bit: the first that explains the rest.
std::uint32_t DeviceWatchdog::faults_in(bool came, const RawDeviceState& raw,
                                        std::int64_t ticks) noexcept {
  if (!came) return bit(DeviceFault::Lost);
  if (!is_finite(raw.world_from_handle)) return bit(DeviceFault::NotFinite);
  const bool late = is_late(raw, ticks);
  const bool frozen = is_frozen(raw, ticks);
  last_ = raw;
  has_last_ = true;
  if (late) return bit(DeviceFault::Late);
  if (frozen) return bit(DeviceFault::Frozen);
  return has_jumped(raw.world_from_handle) ? bit(DeviceFault::Jumped) : 0;
}

bool DeviceWatchdog::is_late(const RawDeviceState& raw, std::int64_t ticks) noexcept {
  const bool is_old = has_last_ && raw.packet == last_.packet;
  packet_ticks_ = is_old ? packet_ticks_ + ticks : 0;
  return pulse_.numbers_packets && packet_ticks_ > late_ticks;
}

bool DeviceWatchdog::is_frozen(const RawDeviceState& raw, std::int64_t ticks) noexcept {
  const bool is_same = has_last_ && raw.world_from_handle == last_.world_from_handle;
  same_ticks_ = is_same ? same_ticks_ + ticks : 0;
  return pulse_.flicker_ticks > 0 && same_ticks_ > pulse_.flicker_ticks;
}

bool DeviceWatchdog::has_jumped(const RigidTransform& pose) noexcept {
  const Vec3 way_mm = pose.translation_mm - last_good_.translation_mm;
  const bool jumped = has_pose_ && glm::dot(way_mm, way_mm) > jump_limit_mm * jump_limit_mm;
  jumps_ = jumped ? jumps_ + 1 : 0;
  has_pose_ = true;
  return jumped;
}

}  // namespace hallux::simulator

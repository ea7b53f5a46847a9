#include "simulator/loop/watchdog.h"

#include <cmath>

#include "simulator/base/elementary.h"

namespace hallux::simulator {

namespace {

/// A hand does not move farther in one tick, nor turn: 20 m/s and 300 rad/s.
constexpr double jump_limit_mm = 20.0, jump_limit_rad = 0.3;
/// A device that stays where it jumped to for so many ticks is believed.
constexpr std::int64_t believed_ticks = 20;
/// A quaternion of another length is no rotation that was rounded or not normalised.
constexpr double least_length = 0.5, greatest_length = 2.0;
/// So many of its periods may pass without a new packet. Of one that speaks each tick: with the
/// tick until the next exchange and two of transport, the motors are without force 5 ms after the
/// first packet that did not come.
constexpr std::int64_t late_periods = 2;

/// No part that is no number gets through: its comparison is false.
bool is_rotation(const Quat& rotation) noexcept {
  const double squared = glm::dot(rotation, rotation);
  return squared >= least_length * least_length && squared <= greatest_length * greatest_length;
}

bool is_pose(const RigidTransform& pose) noexcept {
  return is_finite(pose.translation_mm) && is_rotation(pose.rotation);
}

/// Whether no hand comes from one to the other in so many ticks.
/// needs   both is_pose
bool is_far(const RigidTransform& from, const RigidTransform& to, std::int64_t ticks) noexcept {
  const auto count = static_cast<double>(ticks);
  const double limit_mm = jump_limit_mm * count;
  if (squared_length(to.translation_mm - from.translation_mm) > limit_mm * limit_mm) return true;
  const double half_turn_cosine = glm::dot(normalised(from.rotation), normalised(to.rotation));
  return std::abs(half_turn_cosine) < elementary::cos(0.5 * jump_limit_rad * count);
}

}  // namespace

DeviceState DeviceWatchdog::judge(bool came, const RawDeviceState& raw,
                                  std::int64_t ticks) noexcept {
  DeviceState state;
  state.faults = faults_in(came, raw, ticks);
  const bool has_jumped_only = state.faults == bit(DeviceFault::Jumped);
  if (state.faults == 0 || (has_jumped_only && jumped_ticks_ >= believed_ticks)) {
    last_good_ = raw.world_from_handle;
  }
  if (state.faults == 0 || has_jumped_only) state.switches = raw.switches;
  state.world_from_handle = quantise(last_good_);
  return state;
}

/// At most one bit: the first that explains the rest.
std::uint32_t DeviceWatchdog::faults_in(bool came, const RawDeviceState& raw,
                                        std::int64_t ticks) noexcept {
  if (!came) {
    newest_packet_.reset();
    return bit(DeviceFault::Lost);
  }
  if (!is_pose(raw.world_from_handle)) return bit(DeviceFault::NotFinite);
  const bool late = is_late(raw, ticks);
  const bool frozen = is_frozen(raw, ticks);
  last_ = raw;
  has_last_ = true;
  if (late) return bit(DeviceFault::Late);
  if (frozen) return bit(DeviceFault::Frozen);
  return has_jumped(raw.world_from_handle, ticks) ? bit(DeviceFault::Jumped) : 0;
}

bool DeviceWatchdog::is_late(const RawDeviceState& raw, std::int64_t ticks) noexcept {
  const bool is_new = !newest_packet_ || raw.packet > *newest_packet_;
  packet_ticks_ = is_new ? 0 : packet_ticks_ + ticks;
  if (is_new) newest_packet_ = raw.packet;
  return pulse_.numbers_packets && packet_ticks_ > late_periods * pulse_.period_ticks;
}

bool DeviceWatchdog::is_frozen(const RawDeviceState& raw, std::int64_t ticks) noexcept {
  const bool is_same = has_last_ && raw.world_from_handle == last_.world_from_handle;
  same_ticks_ = is_same ? same_ticks_ + ticks : 0;
  return pulse_.flicker_ticks > 0 && same_ticks_ > pulse_.flicker_ticks;
}

bool DeviceWatchdog::has_jumped(const RigidTransform& pose, std::int64_t ticks) noexcept {
  const bool jumped = has_pose_ && is_far(last_good_, pose, ticks);
  const bool stays = jumped_ticks_ > 0 && !is_far(jumped_to_, pose, ticks);
  if (!jumped) {
    jumped_ticks_ = 0;
  } else {
    jumped_ticks_ = stays ? jumped_ticks_ + ticks : ticks;
    jumped_to_ = pose;
  }
  has_pose_ = true;
  return jumped;
}

}  // namespace hallux::simulator

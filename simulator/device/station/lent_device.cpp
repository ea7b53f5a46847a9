#include "simulator/device/station/lent_device.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "simulator/device/falcon/falcon_packet.h"

namespace hallux::simulator {

namespace {

constexpr std::chrono::milliseconds between_looks{50};

/// Which buttons of a grip do what.
ButtonMap buttons_of(DeviceKind kind) noexcept {
  if (kind != DeviceKind::Falcon) return {.saw = 1, .irrigation = 2};
  return {.saw = static_cast<std::uint32_t>(FalconButton::Forward) |
                 static_cast<std::uint32_t>(FalconButton::Centre),
          .irrigation = static_cast<std::uint32_t>(FalconButton::Minus)};
}

/// How long it took to answer is that of the last one.
void add(PortFigures& all, const PortFigures& of_one) noexcept {
  const PortFigures before = all;
  all = of_one;
  all.exchanges += before.exchanges;
  all.packets += before.packets;
  all.bad_packets += before.bad_packets;
  all.late_packets += before.late_packets;
  all.zeros += before.zeros;
  all.greatest_force_newton = std::max(all.greatest_force_newton, before.greatest_force_newton);
  all.round_trip_max_us = std::max(all.round_trip_max_us, before.round_trip_max_us);
}

}  // namespace

LentDevice::LentDevice(std::shared_ptr<Station> station, FoundDevice found,
                       const std::shared_ptr<DevicePort>& port, const PortDeviceSetup& setup)
    : station_(std::move(station)), found_(std::move(found)), ports_{port} {
  if (port->description().device_class == "rate") {
    rate_ = std::make_unique<RateDevice>(*port, setup);
    held_ = rate_.get();
  } else {
    arm_ = std::make_unique<ArmDevice>(*port, setup);
    held_ = arm_.get();
  }
  watch_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

LentDevice::~LentDevice() = default;

void LentDevice::aim(const Aim& aim) noexcept {
  if (mouse_) return mouse_->aim(aim);
  held_->aim(aim);
}

void LentDevice::hand_over(const RigidTransform& world_from_start) {
  if (mouse_) return;
  mouse_ = std::make_unique<MouseDevice>(world_from_start);
  taken_over_by_.store(mouse_.get(), std::memory_order_release);
}

bool LentDevice::exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                          RawDeviceState& state) noexcept {
  MouseDevice* const mouse = taken_over_by_.load(std::memory_order_acquire);
  if (mouse == nullptr) return held_->exchange(force_in_world_newton, tick, state);
  const bool is_there = mouse->exchange(force_in_world_newton, tick, state);
  state.is_handed_over = true;
  return is_there;
}

TroubleReport LentDevice::trouble() const {
  return mouse_ ? TroubleReport{} : newest_port()->trouble();
}

std::shared_ptr<DevicePort> LentDevice::newest_port() const {
  const std::lock_guard lock(mutex_);
  return ports_.back();
}

std::optional<DeviceFacts> LentDevice::facts() const {
  const KindFacts& kind = facts_of(found_.kind);
  const DeviceDescription description = held_->description();
  DeviceFacts facts{std::string(kind.id),     found_.name,
                    description.device_class, std::string(kind.library),
                    description.motion_scale, {}};
  const std::lock_guard lock(mutex_);
  for (const std::shared_ptr<DevicePort>& port : ports_) add(facts.figures, port->figures());
  return facts;
}

void LentDevice::watch(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::this_thread::sleep_for(between_looks);
    const std::shared_ptr<DevicePort> newest = newest_port();
    if (newest->phase() != PortPhase::Ended) continue;
    std::shared_ptr<DevicePort> again = station_->port_of(found_.id);
    if (again && again != newest) go_on_with(std::move(again));
  }
}

void LentDevice::go_on_with(std::shared_ptr<DevicePort> port) {
  DevicePort& next = *port;
  {
    const std::lock_guard lock(mutex_);
    ports_.push_back(std::move(port));
  }
  if (arm_) arm_->go_on_with(next);
  if (rate_) rate_->go_on_with(next);
}

std::unique_ptr<LentDevice> lend(const std::shared_ptr<Station>& station, const std::string& id,
                                 const PortDeviceSetup& setup) {
  const std::vector<FoundDevice> devices = station->devices();
  const FoundDevice* found = device_with(devices, id);
  if (found == nullptr) return nullptr;
  std::shared_ptr<DevicePort> port = station->open(id);
  if (!port || port->phase() != PortPhase::Running) return nullptr;
  return std::make_unique<LentDevice>(station, *found, port, setup);
}

PortDeviceSetup setup_of(const Station& station, const FoundDevice& device, const HandChoice& own,
                         const RigidTransform& world_from_start, const Quat& world_from_view) {
  const Hold hold =
      hold_of(station.settings().of(device.id, std::string(facts_of(device.kind).id)), own);
  PortDeviceSetup setup{world_from_start};
  setup.frame = {world_from_view, hold.motion_scale};
  setup.buttons = buttons_of(device.kind);
  setup.force_share = hold.force_share;
  return setup;
}

}  // namespace hallux::simulator

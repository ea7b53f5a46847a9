#include "simulator/device/station/lent_device.h"

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

}  // namespace

LentDevice::LentDevice(Station& station, FoundDevice found, const std::shared_ptr<DevicePort>& port,
                       const PortDeviceSetup& setup)
    : station_(station), found_(std::move(found)), ports_{port} {
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

void LentDevice::lift(bool is_lifted) noexcept {
  if (arm_) arm_->lift(is_lifted);
}

void LentDevice::look(const Quat& world_from_view) noexcept {
  if (rate_) rate_->look(world_from_view);
}

std::optional<DeviceFacts> LentDevice::facts() const {
  const KindFacts& kind = facts_of(found_.kind);
  const DeviceDescription description = held_->description();
  DeviceFacts facts{std::string(kind.id),     found_.name,
                    description.device_class, std::string(kind.library),
                    description.motion_scale, {}};
  const std::lock_guard lock(mutex_);
  facts.figures = ports_.back()->figures();
  return facts;
}

void LentDevice::watch(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::this_thread::sleep_for(between_looks);
    std::shared_ptr<DevicePort> newest;
    {
      const std::lock_guard lock(mutex_);
      newest = ports_.back();
    }
    if (newest->phase() != PortPhase::Ended) continue;
    std::shared_ptr<DevicePort> again = station_.port_of(found_.id);
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

std::unique_ptr<LentDevice> lend(Station& station, const std::string& id,
                                 const PortDeviceSetup& setup) {
  const std::vector<FoundDevice> devices = station.devices();
  const FoundDevice* found = device_with(devices, id);
  if (found == nullptr) return nullptr;
  std::shared_ptr<DevicePort> port = station.open(id);
  if (!port || port->phase() != PortPhase::Running) return nullptr;
  return std::make_unique<LentDevice>(station, *found, port, setup);
}

PortDeviceSetup setup_of(const Station& station, const FoundDevice& device,
                         const RigidTransform& world_from_start, const Quat& world_from_view) {
  const DeviceSettings settings =
      station.settings().of(device.id, std::string(facts_of(device.kind).id));
  PortDeviceSetup setup{world_from_start};
  setup.frame = {world_from_view, settings.motion_scale.value_or(1.0)};
  setup.buttons = buttons_of(device.kind);
  setup.force_share = settings.force_share.value_or(1.0);
  return setup;
}

}  // namespace hallux::simulator

#include "simulator/device/port_device.h"

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// In which a turn that a window asks for is followed to 63 %.
constexpr double turn_s = 0.03;

/// The port's device with what this station allows of its force.
DeviceDescription described(const Port& port, const PortDeviceSetup& setup) {
  DeviceDescription description = port.description();
  description.motion_scale = setup.frame.motion_scale;
  description.limits = limits_at_share(description.limits, setup.force_share);
  return description;
}

/// Before a window has said anything: the view is as the device lies.
SteeredDevice::Aim resting_in(const PortDeviceSetup& setup) {
  SteeredDevice::Aim aim{setup.world_from_start};
  aim.world_from_view = setup.frame.world_from_device;
  return aim;
}

}  // namespace

const SteeredDevice::Aim& HeardAim::read(std::int64_t tick) noexcept {
  const Said& said = slot_.read();
  if (said.number != heard_) heard_tick_ = tick;
  heard_ = said.number;
  return said.aim;
}

HeardPort::Heard HeardPort::hear(std::int64_t tick) noexcept {
  Port& port = *port_.load(std::memory_order_acquire);
  const Heard heard{port, port.newest(), aim_.read(tick), ticks_to_follow(tick, tick_)};
  tick_ = tick;
  return heard;
}

ArmDevice::ArmDevice(Port& port, const PortDeviceSetup& setup)
    : port_(port, resting_in(setup)),
      setup_(setup),
      described_(described(port, setup)),
      turns_(described_.measures_rotation),
      placing_(setup.frame),
      switches_(setup.buttons),
      world_from_saw_(setup.world_from_start) {}

DeviceDescription ArmDevice::description() const { return described_; }

bool ArmDevice::exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                         RawDeviceState& state) noexcept {
  const auto& [port, said, aim, ticks] = port_.hear(tick);
  // Another port numbers its packets anew: for a tick the device was away.
  const bool is_exchanged = held_by_ != nullptr && held_by_ != &port;
  if (said.phase != PortPhase::Running || is_exchanged) {
    held_by_ = nullptr;
    switches_.release();
    return false;
  }
  if (held_by_ != &port) placing_.set_down(device_from_hand(said.said), world_from_saw_);
  held_by_ = &port;
  place(said.said, aim, ticks);
  // Nothing said is no force: the port lets go by itself, and begins softly.
  if (!placing_.is_lifted())
    port.say(glm::conjugate(setup_.frame.world_from_device) * force_in_world_newton);
  if (port_.is_silent(tick)) switches_.release();
  state = {world_from_saw_, switches_.combined(said.said.buttons, aim.switches, aim.orders),
           said.packet};
  return true;
}

RigidTransform ArmDevice::device_from_hand(const DriverState& said) const noexcept {
  return {turns_ ? said.device_from_handle.rotation : Quat(1.0, 0.0, 0.0, 0.0),
          said.device_from_handle.translation_mm};
}

void ArmDevice::place(const DriverState& said, const Aim& aim, std::int64_t ticks) noexcept {
  const RigidTransform hand = device_from_hand(said);
  if (aim.is_lifted && !placing_.is_lifted()) placing_.lift();
  if (!aim.is_lifted && placing_.is_lifted()) placing_.set_down(hand, world_from_saw_);
  const RigidTransform placed = placing_.place(hand);
  world_from_saw_.translation_mm = placed.translation_mm;
  if (turns_) {
    world_from_saw_.rotation = placed.rotation;
    return;
  }
  const double share = static_cast<double>(ticks) * step_s / turn_s;
  world_from_saw_.rotation =
      interpolate(world_from_saw_, {aim.world_from_target.rotation, world_from_saw_.translation_mm},
                  share)
          .rotation;
}

RateDevice::RateDevice(Port& port, const PortDeviceSetup& setup)
    : port_(port, resting_in(setup)),
      described_(described(port, setup)),
      control_(setup.world_from_start),
      hand_(setup.world_from_start),
      switches_(setup.buttons) {}

DeviceDescription RateDevice::description() const { return described_; }

bool RateDevice::exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                          RawDeviceState& state) noexcept {
  const auto& [port, said, aim, ticks] = port_.hear(tick);
  const bool is_there = said.phase == PortPhase::Running;
  if (!is_there || port_.is_silent(tick)) switches_.release();
  for (std::int64_t i = 0; i < ticks; ++i) {
    control_.advance(is_there ? said.said.deflection : Deflection{}, aim.world_from_view);
    hand_.follow(control_.world_from_hand(), aim.unyielding_in_world, force_in_world_newton);
  }
  state = {hand_.world_from_hand(), switches_.combined(said.said.buttons, aim.switches, aim.orders),
           said.packet};
  return is_there;
}

}  // namespace hallux::simulator

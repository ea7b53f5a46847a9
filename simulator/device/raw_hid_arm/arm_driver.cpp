#include "simulator/device/raw_hid_arm/arm_driver.h"

#include <utility>

namespace hallux::simulator {

namespace {

/// Half a second of an arm that reports each millisecond.
constexpr int held_to_calibrate = 500;
/// The board waits for us no longer than its own watchdog; a report that is lost is asked for anew.
constexpr std::chrono::milliseconds report_within{5};

}  // namespace

ArmDriver::ArmDriver(std::function<OpenedHid()> open_channel, ArmGeometry geometry)
    : open_channel_(std::move(open_channel)), geometry_(std::move(geometry)) {
  state_.is_homed = false;
}

DeviceDescription ArmDriver::description() const {
  return {.name = geometry_.name.empty() ? "Open serial arm" : geometry_.name,
          .device_class = "arm6",
          .limits = DeviceLimits{.force_newton = geometry_.force_newton,
                                 .continuous_force_newton = geometry_.continuous_force_newton,
                                 .thermal_time_s = 10.0,
                                 .stiffness_newton_per_mm = geometry_.stiffness_newton_per_mm,
                                 .damping_newton_s_per_mm = geometry_.damping_newton_s_per_mm,
                                 .transport_ticks = 1,
                                 .renders_vibration = true},
          .pulse = DevicePulse{.numbers_packets = true},
          .measures_rotation = true};
}

TroubleReport ArmDriver::open(const OpeningWatch&) {
  OpenedHid opened = open_channel_();
  if (opened.trouble) return opened.trouble;
  channel_ = std::move(opened.channel);
  return {};
}

DriverExchange ArmDriver::exchange(const Vec3& force_in_device_newton) noexcept {
  const auto answered = [&](DriverAnswer answer, DeviceTrouble trouble = DeviceTrouble::None) {
    return DriverExchange{answer, state_, trouble};
  };
  if (!channel_) return answered(DriverAnswer::Gone, DeviceTrouble::Unplugged);
  const BusAnswer written = channel_->write(output_for(force_in_device_newton));
  if (written == BusAnswer::Gone) return answered(DriverAnswer::Gone, DeviceTrouble::Unplugged);
  // One more than a report: a longer one is told by its length.
  std::array<std::uint8_t, arm_report_bytes + 1> bytes{};
  const BusRead read = channel_->read(bytes, report_within);
  if (read.answer == BusAnswer::Gone) return answered(DriverAnswer::Gone, DeviceTrouble::Unplugged);
  if (read.answer != BusAnswer::Done) return answered(DriverAnswer::Nothing);
  const std::optional<ArmReport> report = arm_report(std::span(bytes).first(read.bytes));
  if (!report) return answered(DriverAnswer::Garbled);
  take(*report);
  return answered(DriverAnswer::Said);
}

ArmOutput ArmDriver::output_for(const Vec3& force_in_device_newton) noexcept {
  if (state_.is_homed)
    return arm_currents(motor_currents(geometry_, counts_, force_in_device_newton));
  if (held_ < held_to_calibrate) return arm_currents({});
  state_.is_homed = true;
  return arm_encoders_set(geometry_.at_rest);
}

void ArmDriver::take(const ArmReport& report) noexcept {
  held_ = report.is_pressed ? held_ + 1 : 0;
  counts_ = report.counts;
  state_.device_from_handle = grip_pose(geometry_, counts_);
  state_.buttons = report.is_pressed ? 1 : 0;
}

void ArmDriver::close() noexcept {
  if (!channel_) return;
  static_cast<void>(channel_->write(arm_currents({})));
  channel_.reset();
  state_.is_homed = false;
  held_ = 0;
}

}  // namespace hallux::simulator

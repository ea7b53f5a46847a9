/// The driver of the open serial arm: reports in strict turn, calibrated by whoever holds it.
/// Inside this corner only.
///
/// Its encoders count from where they are when it is switched on. The arm is put into its stand and
/// its button held for half a second: then they are set to what the record says of that place.
#pragma once

#include <functional>
#include <memory>

#include "simulator/device/bus/hid_channel.h"
#include "simulator/device/bus/hid_descriptor.h"
#include "simulator/device/port/device_driver.h"
#include "simulator/device/raw_hid_arm/arm_packet.h"

namespace hallux::simulator {

/// Of the two boards that are known. The first is a number that many makers use: only the usage
/// tells.
inline constexpr std::uint16_t arm_vendor = 0x16C0, arm_product = 0x0486;
inline constexpr std::uint16_t older_arm_vendor = 0x1234, older_arm_product = 0x0006;
inline constexpr std::uint16_t arm_usage_page = 0xFFAB;

class ArmDriver final : public DeviceDriver {
 public:
  /// needs   fault_in(geometry) is empty
  ArmDriver(std::function<OpenedHid()> open_channel, ArmGeometry geometry);

  TroubleReport open(const OpeningWatch& watch) override;
  DeviceDescription description() const override;
  DriverExchange exchange(const Vec3& force_in_device_newton) noexcept override;
  void close() noexcept override;

 private:
  ArmOutput output_for(const Vec3& force_in_device_newton) noexcept;
  void take(const ArmReport& report) noexcept;

  std::function<OpenedHid()> open_channel_;
  ArmGeometry geometry_;
  std::unique_ptr<HidChannel> channel_;
  DriverState state_;
  ArmCounts counts_{};
  /// Reports in a row with the button held, until it is calibrated.
  int held_ = 0;
};

}  // namespace hallux::simulator

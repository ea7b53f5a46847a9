/// The driver of a Novint Falcon: loads its firmware where it has none, waits until its legs were
/// pushed in once, then gives it forces for places. Inside this corner only.
///
///     open --answers--> runs                        exchange: 16 bytes out, 16 bytes in
///       '--silent--> boot loader --bytes, each echoed--> runs
///
/// It measures no rotation: the grip's stays as it is.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "simulator/device/bus/usb_channel.h"
#include "simulator/device/falcon/falcon_packet.h"
#include "simulator/device/port/device_driver.h"

namespace hallux::simulator {

inline constexpr std::uint16_t falcon_vendor = 0x0403, falcon_product = 0xCB48;
inline constexpr std::uint8_t falcon_pipe_in = 0x81, falcon_pipe_out = 0x02;

struct FalconSettings {
  /// Empty: none was named.
  std::filesystem::path firmware = {};
  /// What a motor makes of its counts. The lower of the two figures that are known: too weak rather
  /// than too strong.
  double counts_per_newton_metre = 4800.0;
};

class FalconDriver final : public DeviceDriver {
 public:
  FalconDriver(std::function<OpenedUsb()> open_channel, FalconSettings settings);

  TroubleReport open(const OpeningWatch& watch) override;
  DeviceDescription description() const override;
  DriverExchange exchange(const Vec3& force_in_device_newton) noexcept override;
  void close() noexcept override;

 private:
  TroubleReport bring_up(const OpeningWatch& watch);
  BusAnswer start_running() noexcept;
  BusAnswer load(std::span<const std::uint8_t> image, const OpeningWatch& watch);
  BusAnswer enter_boot_loader() noexcept;
  FalconCounts motors_for(const Vec3& force_in_device_newton) const noexcept;
  bool take(const FalconReport& report) noexcept;

  std::function<OpenedUsb()> open_channel_;
  FalconSettings settings_;
  std::unique_ptr<UsbChannel> channel_;
  FalconReports reports_;
  DriverState state_;
  /// Frame of the legs.
  Vec3 grip_mm_ = falcon_middle_mm;
  CrankAngles angles_{};
};

}  // namespace hallux::simulator

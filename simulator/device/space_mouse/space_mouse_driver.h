/// The driver of a 3D mouse of the SpaceMouse family: its reports, and its light while it is used.
/// Inside this corner only.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "simulator/device/bus/hid_channel.h"
#include "simulator/device/bus/hid_descriptor.h"
#include "simulator/device/port/device_driver.h"
#include "simulator/device/space_mouse/space_mouse_report.h"

namespace hallux::simulator {

inline constexpr std::int32_t usual_axis_limit = 350;

/// A device of these numbers that says it has several axes, told by them and never by its name.
bool is_space_mouse(std::uint16_t vendor, std::uint16_t product, const HidUsage& usage) noexcept;

class SpaceMouseDriver final : public DeviceDriver {
 public:
  /// needs   axis_limit > 0
  SpaceMouseDriver(std::function<OpenedHid()> open_channel, std::string name,
                   std::int32_t axis_limit);

  TroubleReport open(const OpeningWatch& watch) override;
  DeviceDescription description() const override;
  /// Nobody is pushed.
  DriverExchange exchange(const Vec3& force_in_device_newton) noexcept override;
  void close() noexcept override;

 private:
  std::function<OpenedHid()> open_channel_;
  std::string name_;
  std::int32_t axis_limit_;
  std::unique_ptr<HidChannel> channel_;
  SpaceMouseState said_;
  DriverState state_;
};

}  // namespace hallux::simulator

/// USB devices through libusb: what is plugged in, and opening one. The library is named in the
/// source of this header only. Inside this corner only.
#pragma once

#include <memory>
#include <vector>

#include "simulator/device/bus/usb_channel.h"

struct libusb_context;

namespace hallux::simulator {

class UsbLibrary {
 public:
  /// Where the system has no USB, nothing is ever plugged in.
  UsbLibrary();
  ~UsbLibrary();
  UsbLibrary(const UsbLibrary&) = delete;
  UsbLibrary& operator=(const UsbLibrary&) = delete;

  /// Those of a vendor that are plugged in.
  /// thread  any; one at a time
  std::vector<PluggedDevice> plugged(std::uint16_t vendor) const;

 private:
  libusb_context* context_ = nullptr;
};

/// Of a device with that number, in the node that stands for it; its first interface is claimed.
/// pipe_in, pipe_out  the numbers of its two pipes
/// thread  any; the channel is then its user's
OpenedUsb open_usb(const PluggedDevice& device, std::uint8_t pipe_in, std::uint8_t pipe_out);

/// The library's own version.
std::string usb_library_version();

}  // namespace hallux::simulator

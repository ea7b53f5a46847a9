/// HID devices through hidapi's hidraw backend: what is plugged in, and opening one. The library is
/// named in the source of this header only. Inside this corner only.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "simulator/device/bus/hid_channel.h"
#include "simulator/device/bus/hid_descriptor.h"

namespace hallux::simulator {

struct PluggedHid {
  PluggedDevice device;
  HidUsage usage;
  /// Of the axes X to Rz; none where it has none.
  std::optional<std::int32_t> axis_limit;
};

class HidLibrary {
 public:
  HidLibrary();
  ~HidLibrary();
  HidLibrary(const HidLibrary&) = delete;
  HidLibrary& operator=(const HidLibrary&) = delete;

  /// thread  any; one at a time talks to the library
  std::vector<PluggedHid> plugged();
  OpenedHid open(const std::string& node);

 private:
  /// Its opening and listing share state.
  std::mutex mutex_;
};

/// The library's own version.
std::string hid_library_version();

/// Whether this process may read and write the file that stands for a device, and if not, why.
TroubleReport trouble_with_node(const std::string& node);

}  // namespace hallux::simulator

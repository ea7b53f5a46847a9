/// Devices for whoever operates: brought home, and lent where the saw begins.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "simulator/base/progress.h"
#include "simulator/device/station/lent_device.h"
#include "simulator/device/station/second_hand.h"

namespace hallux::ui {

/// Why a device cannot be had, and what mends it, in a sentence.
class DeviceRefused : public std::runtime_error {
 public:
  DeviceRefused(const simulator::TroubleReport& trouble, const simulator::FoundDevice& device);
  explicit DeviceRefused(const std::string& sentence) : std::runtime_error(sentence) {}
};

/// Where the saw is held when an operation begins, and how the person sees it there.
struct HandStart {
  RigidTransform world_from_tool;
  Quat world_from_view{1.0, 0.0, 0.0, 0.0};
};

/// What somebody operates with.
struct LentHands {
  std::unique_ptr<simulator::SteeredDevice> saw;
  /// Turns what the first holds, or the view; null: nothing.
  std::unique_ptr<simulator::SecondHand> second = nullptr;
};

/// Lends a device whose hand holds the saw in that pose, and one for the other hand.
/// errors  DeviceRefused; Cancelled
/// thread  any but the window's
using LendHands = std::function<LentHands(const HandStart& start, const Progress& progress)>;

/// The device with that id as it is now; nothing where it is not plugged in. An Inverse3 is found
/// with its trouble where its service is away, which alone could tell.
std::optional<simulator::FoundDevice> found_now(simulator::Station& station, const std::string& id);

/// Opens a device, and waits until somebody has brought its grip home.
/// errors  DeviceRefused; Cancelled
void bring_home(simulator::Station& station, const simulator::FoundDevice& device,
                const Progress& progress);

/// Lends one that was brought home, held as its person chose.
/// errors  DeviceRefused
std::unique_ptr<simulator::LentDevice> lend_hand(const std::shared_ptr<simulator::Station>& station,
                                                 const simulator::FoundDevice& device,
                                                 const simulator::HandChoice& own,
                                                 const HandStart& start);

}  // namespace hallux::ui

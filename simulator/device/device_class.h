/// The classes of devices: scores are compared within one, and a rubric may have its own knots for
/// each.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace hallux::simulator {

/// scripted  a robot's hand
/// mouse     mouse and keyboard
/// rate      steered by speed, as a SpaceMouse
/// arm       a modelled one
/// arm3      an arm that pushes, its handle turned by other means
/// arm6      one that measures rotation
inline constexpr std::array<std::string_view, 6> device_classes{"scripted", "mouse", "rate",
                                                                "arm",      "arm3",  "arm6"};

constexpr bool is_device_class(std::string_view name) noexcept {
  return std::find(device_classes.begin(), device_classes.end(), name) != device_classes.end();
}

}  // namespace hallux::simulator

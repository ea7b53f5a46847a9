/// Switches that several hold: the grip's buttons, and keys and buttons of a window. Any of them
/// turns the saw on, and any turns it off. Inside this corner only.
#pragma once

#include <cstdint>

#include "simulator/record/record.h"

namespace hallux::simulator {

/// Which buttons of a grip do what, as bits of the device's buttons.
struct ButtonMap {
  std::uint32_t saw = 1, irrigation = 2;
};

class SwitchBoard {
 public:
  explicit SwitchBoard(const ButtonMap& map) : map_(map) {}

  /// Bits of Switch for what is on now. A button of the grip turns over what it stands for when it
  /// is pressed; a window's order is how all of it is to be, once for each that is counted.
  std::uint32_t combined(std::uint32_t buttons, std::uint32_t ordered,
                         std::uint32_t orders) noexcept;
  /// All off, until a button is pressed or something is ordered.
  void release() noexcept { is_on_ = 0; }

 private:
  ButtonMap map_;
  /// As they were at the call before.
  std::uint32_t buttons_ = 0, orders_ = 0;
  /// Bits of Switch.
  std::uint32_t is_on_ = 0;
};

}  // namespace hallux::simulator

#include "simulator/device/switch_board.h"

#include "simulator/base/bits.h"

namespace hallux::simulator {

std::uint32_t SwitchBoard::combined(std::uint32_t buttons, std::uint32_t keys) noexcept {
  const std::uint32_t pressed = buttons & ~buttons_;
  if ((pressed & map_.saw) != 0) is_on_ ^= bit(Switch::SawRuns);
  if ((pressed & map_.irrigation) != 0) is_on_ ^= bit(Switch::Irrigates);
  is_on_ ^= keys ^ keys_;
  buttons_ = buttons;
  keys_ = keys;
  return is_on_;
}

}  // namespace hallux::simulator

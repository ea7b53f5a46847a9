#include "simulator/device/switch_board.h"

#include "simulator/base/bits.h"

namespace hallux::simulator {

std::uint32_t SwitchBoard::combined(std::uint32_t buttons, std::uint32_t ordered,
                                    std::uint32_t orders) noexcept {
  if (orders != orders_) is_on_ = ordered;
  orders_ = orders;
  const std::uint32_t pressed = buttons & ~buttons_;
  if ((pressed & map_.saw) != 0) is_on_ ^= bit(Switch::SawRuns);
  if ((pressed & map_.irrigation) != 0) is_on_ ^= bit(Switch::Irrigates);
  buttons_ = buttons;
  return is_on_;
}

}  // namespace hallux::simulator

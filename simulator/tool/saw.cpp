#include "simulator/tool/saw.h"

namespace hallux::simulator {

double sharp_cycles_per_minute(const Saw& saw) noexcept {
  return saw.cycles_per_minute * saw.sharpness;
}

}  // namespace hallux::simulator

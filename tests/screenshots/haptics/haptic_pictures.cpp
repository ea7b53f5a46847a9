#include "tests/screenshots/haptics/haptic_pictures.h"

namespace hallux::tests {

std::vector<Picture> haptic_pictures() {
  return {{"stability", draw_stability()}, {"laws", draw_laws()}, {"hands", draw_hands()}};
}

}  // namespace hallux::tests

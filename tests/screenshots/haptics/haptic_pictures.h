/// The pictures of docs/haptics.md, each computed with the modelled arm in virtual time; the same bytes each time.
#pragma once

#include <vector>

#include "tests/screenshots/kernel_pictures.h"

namespace hallux::tests {

/// Which walls are calm, over stiffness and delay, beside theory.
std::string draw_stability();
/// Where a hand goes that pushes against a plate, by three laws at two rates.
std::string draw_laws();

/// All of them, in the order of the text.
std::vector<Picture> haptic_pictures();

}  // namespace hallux::tests

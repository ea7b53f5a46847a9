/// The pictures of docs/haptics.md, each computed with a modelled arm or hand in virtual time; the
/// same bytes each time.
#pragma once

#include <vector>

#include "tests/screenshots/kernel_pictures.h"

namespace hallux::tests {

/// Which walls are calm, over stiffness and delay, beside theory.
std::string draw_stability();
/// Where a hand goes that pushes against a plate, by three laws at two rates.
std::string draw_laws();
/// Push, heat and depth over time of an expert's and a novice's hand at Silver.
std::string draw_hands();

/// All of them, in the order of the text.
std::vector<Picture> haptic_pictures();

}  // namespace hallux::tests

/// A hand that only obeys: it does what a hint says, a few key presses at a time, and nothing else.
#pragma once

#include "tests/ui/screens/operating/virtual_operation.h"

namespace hallux::ui {

/// Until it looks again.
inline constexpr int ticks_per_look = 300;

/// Does what the hint says, and lets that much time go by.
void obey(VirtualOperation& operation, const Hint& hint);

}  // namespace hallux::ui

/// How much of the machine a software renderer may take beside the 1 kHz loop.
#pragma once

namespace hallux::ui {

/// Says to llvmpipe how many threads to draw with, unless the environment says so (LP_NUM_THREADS).
/// Where the system lets the loop run before all else, every processor draws: the loop takes what
/// it needs, when it needs it. Elsewhere one is left to it. On two processors that makes 35
/// pictures a second in place of 25; without the system's leave, drawing with both made the loop
/// late by 3.2 ms (p99) in place of 1.3.
/// needs   called before the first context is made, by the only thread there is
/// source  tests/benchmarks/operating_live
void share_processors_with_loop();

}  // namespace hallux::ui

/// Memory that was freed: what of it the process keeps, and what goes back to the system.
#pragma once

namespace hallux::ui {

/// For a verb, which does its work and ends: trees, meshes and fields of some megabytes come and go
/// all the time. Given back at once, their pages would be cleared and mapped anew each time, which
/// takes as long as the work itself.
/// thread  any; for the whole process
void keep_freed_memory() noexcept;

/// For a window, which stays for hours: its many threads' heaps would each keep the pages of trees
/// and meshes that are gone.
/// thread  any; for the whole process
void give_freed_memory_back() noexcept;

}  // namespace hallux::ui

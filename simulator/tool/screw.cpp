#include "simulator/tool/screw.h"

namespace hallux::simulator {

namespace {

bool fits_itself(const Screw& screw) noexcept {
  return screw.shaft_diameter_mm > 0.0 && screw.shaft_diameter_mm <= screw.pilot_diameter_mm &&
         screw.pilot_diameter_mm < screw.thread_diameter_mm &&
         screw.thread_diameter_mm <= screw.glide_diameter_mm &&
         screw.thread_diameter_mm <= screw.head_diameter_mm;
}

}  // namespace

bool is_made(const Screw& screw) noexcept {
  return fits_itself(screw) && screw_thread_range_mm.holds(screw.thread_diameter_mm) &&
         screw_length_range_mm.holds(screw.length_mm) &&
         screw_pitch_range_mm.holds(screw.pitch_mm) &&
         screw_head_range_mm.holds(screw.head_diameter_mm) &&
         screw_head_height_range_mm.holds(screw.head_height_mm);
}

}  // namespace hallux::simulator

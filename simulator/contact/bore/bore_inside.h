/// One tick of a tool in its bore. Inside this corner only.
///
/// Part of bore_motion.h, and called by it alone.
#pragma once

#include "simulator/contact/bore/bore_motion.h"

namespace hallux::simulator {

/// Moves the tool along the bore's axis; through air and open bore by at most `travel_limit_mm`.
void move_in_bore(BoreToolState& tool, const BoreInput& input, const DrilledWound& bone,
                  const ContactSettings& settings, double travel_limit_mm,
                  BoreOutcome& outcome) noexcept;

}  // namespace hallux::simulator

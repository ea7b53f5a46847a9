/// What an attempt did to bone beside the cut, as people read it: each number with its unit and the
/// decimals it deserves.
///
/// All of it is by models that no surgeon has reviewed; whoever shows it says so, and that nothing
/// is scored by it.
#pragma once

#include <string>

#include "simulator/contact/heat.h"

namespace hallux::ui {

/// Whether any bone passed the temperature from which it suffers.
bool was_hot(const simulator::HeatSummary& heat) noexcept;

/// "62 °C".
std::string hottest_text(const simulator::HeatSummary& heat);
/// "3.3 s".
std::string hot_time_text(const simulator::HeatSummary& heat);
/// "6 mm³"; "0 mm³" where none died.
std::string dead_bone_text(const simulator::HeatSummary& heat);
/// "0.25 mm".
std::string bend_text(double deflection_mm);
/// "1.3 s".
std::string contact_time_text(double duration_s);

}  // namespace hallux::ui

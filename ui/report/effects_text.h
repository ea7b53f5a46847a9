/// What an attempt did to bone beside the cut, as people read it: each number with its unit and the
/// decimals it deserves.
///
/// All of it is by models that no surgeon has reviewed; whoever shows it says so, and that nothing
/// is scored by it where that is so.
#pragma once

#include <string>

#include "database/records/score.h"
#include "simulator/contact/heat.h"

namespace hallux::ui {

/// Whether any bone passed the temperature from which it suffers.
bool was_hot(const simulator::HeatSummary& heat) noexcept;

/// Whether the card's rubric asks for heat or contacts with danger zones: older ones do not.
bool are_effects_scored(const database::ScoreCard& card) noexcept;

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

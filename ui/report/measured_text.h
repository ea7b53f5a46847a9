/// Measured values with their units, the same words on paper and on the screen.
#pragma once

#include <string>
#include <string_view>

#include "database/records/score.h"

namespace hallux::ui {

/// "12.3°", "1.67 mm", "−2.4", with the true minus; a count and a share have no unit.
std::string measured_text(double value, std::string_view unit);
/// "−2.4": with the sign that people write.
std::string with_true_minus(std::string number);
/// What a line of a ledger was measured as: a claim "yes" or "no", of damping the share that
/// accuracy reached, "–" where nothing was.
std::string measured_text(const database::LedgerLine& line);

}  // namespace hallux::ui

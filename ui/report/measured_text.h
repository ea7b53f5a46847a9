/// Measured values with their units, the same words on paper and on the screen.
#pragma once

#include <string>
#include <string_view>

namespace hallux::ui {

/// "12.3°", "1.67 mm", "−2.4", with the true minus; a count and a share have no unit.
std::string measured_text(double value, std::string_view unit);
/// A number that is written already, with its unit: "1°", "0.8–2 mm".
std::string with_unit(std::string number, std::string_view unit);

}  // namespace hallux::ui

/// Words of a scenario's sheet that several of its parts need. Inside this corner only.
#pragma once

#include <ostream>
#include <string>

namespace hallux::ui {

/// What was read as a decimal reads the same again, and an angle that went through radians has no
/// tail of digits.
std::string sheet_number(double value);
/// "12.5 deg".
std::string sheet_angle(double angle_rad);
void write_origin(std::ostream& out, const std::string& origin);

}  // namespace hallux::ui

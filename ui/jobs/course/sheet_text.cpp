#include "ui/jobs/course/sheet_text.h"

#include <array>
#include <charconv>

#include "simulator/base/units.h"

namespace hallux::ui {

std::string sheet_number(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::general, 9)
                       .ptr;
  return {digits.data(), end};
}

std::string sheet_angle(double angle_rad) {
  return sheet_number(degree_from_radian(angle_rad)) + " deg";
}

void write_origin(std::ostream& out, const std::string& origin) {
  out << "      origin: " << origin << "\n";
}

}  // namespace hallux::ui

#include "ui/report/measured_text.h"

#include "assessment/number_text.h"

namespace hallux::ui {

namespace {

constexpr const char* minus = "\xE2\x88\x92";
constexpr const char* degree = "\xC2\xB0";

}  // namespace

std::string with_unit(std::string number, std::string_view unit) {
  if (number.starts_with('-')) number.replace(0, 1, minus);
  if (unit == "deg") return number + degree;
  return unit.empty() ? number : number + " " + assessment::unit_text(unit);
}

std::string measured_text(double value, std::string_view unit) {
  if (unit.empty()) return with_unit(assessment::value_text(value, unit), unit);
  return with_unit(assessment::number_text(value, unit == "mm" ? 2 : 1), unit);
}

}  // namespace hallux::ui

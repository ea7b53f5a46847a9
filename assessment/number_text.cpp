#include "assessment/number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace hallux::assessment {

double rounded_to_micro(double value) noexcept {
  const double rounded = std::round(value * 1.0e6) / 1.0e6;
  return rounded == 0.0 ? 0.0 : rounded;
}

std::string number_text(double value, int decimals) {
  if (std::isnan(value)) return "not a number";
  if (std::isinf(value)) return value > 0.0 ? "infinite" : "minus infinite";
  std::array<char, 400> characters{};
  const auto end = std::to_chars(characters.data(), characters.data() + characters.size(), value,
                                 std::chars_format::fixed, decimals);
  std::string text(characters.data(), end.ptr);
  const bool is_minus_zero =
      text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos;
  return is_minus_zero ? text.substr(1) : text;
}

std::string short_number_text(double value) {
  std::string text = number_text(value, 3);
  if (text.find('.') == std::string::npos) return text;
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string unit_text(std::string_view unit) {
  if (unit == "newton") return "N";
  if (unit == "mm_s") return "mm/s";
  return std::string(unit);
}

std::string with_unit(const std::string& number, std::string_view unit) {
  if (unit == "deg") return number + "\xC2\xB0";
  return unit.empty() ? number : number + " " + unit_text(unit);
}

std::string value_text(double value, std::string_view unit) {
  // A count is whole; of a share two places tell enough.
  if (unit.empty()) return short_number_text(std::round(value * 100.0) / 100.0);
  return with_unit(number_text(value, unit == "mm" ? 2 : 1), unit);
}

std::string points_text(std::int64_t points_milli) {
  const std::int64_t size = std::abs(points_milli);
  const double points = static_cast<double>(points_milli) / 1000.0;
  if (size % 1000 == 0) return number_text(points, 0);
  if (size < 10) return number_text(points, 3);
  return number_text(points, size < 100 ? 2 : 1);
}

std::string moment_text(std::int64_t time_us) {
  const std::int64_t time_ms = time_us / 1000;
  const std::string millis = std::to_string(1000 + time_ms % 1000).substr(1);
  const std::string seconds = std::to_string(100 + time_ms / 1000 % 60).substr(1);
  return std::to_string(time_ms / 60000) + ":" + seconds + "." + millis;
}

}  // namespace hallux::assessment

/// Numbers as people read them, the same in every locale.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hallux::assessment {

/// Rounded to a millionth of its unit, never minus zero: the form in which metrics are compared and
/// stored.
double rounded_to_micro(double value) noexcept;

/// Fixed decimals with a point: "4.20"; "not a number" and infinities are said so.
std::string number_text(double value, int decimals);
/// Without needless zeros: "1", "0.5", "2.25".
std::string short_number_text(double value);
/// A metric's unit as people write it: "mm", "N", "mm/s".
std::string unit_text(std::string_view unit);
/// A number that is written already, with its unit: "1°", "0.5 mm"; a count and a share have none.
std::string with_unit(const std::string& number, std::string_view unit);
/// A metric's value with its unit and the decimals that the unit deserves: "4.2°", "0.35 mm".
std::string value_text(double value, std::string_view unit);
/// Rubric or score points from thousandths: "16", "7.3", "0.04".
std::string points_text(std::int64_t points_milli);
/// "0:12.345", minutes and seconds of the attempt.
std::string moment_text(std::int64_t time_us);

}  // namespace hallux::assessment

/// Named conversions between the units used inside (millimetre, newton, second, radian) and those
/// at the doors.
#pragma once

#include <cstdint>

namespace hallux {

inline constexpr double pi = 3.14159265358979323846;

constexpr double radian_from_degree(double degree) noexcept { return degree * (pi / 180.0); }
constexpr double degree_from_radian(double radian) noexcept { return radian * (180.0 / pi); }

/// One tick of the step is one simulated millisecond.
inline constexpr double step_s = 0.001;
constexpr std::int64_t time_us_from_tick(std::int64_t tick) noexcept { return tick * 1000; }
constexpr double second_from_tick(std::int64_t tick) noexcept {
  return static_cast<double>(tick) * step_s;
}

/// Rounds to the nearest integer, halves away from zero; saturates at the ends of 32 bits. NaN
/// becomes 0.
constexpr std::int32_t round_to_int32(double value) noexcept {
  if (!(value == value)) return 0;
  if (value >= 2147483647.0) return 2147483647;
  if (value <= -2147483647.0) return -2147483647;
  return static_cast<std::int32_t>(value < 0.0 ? value - 0.5 : value + 0.5);
}

/// The quanta of the record: positions 1 um, unit quaternions and normals 1e-6, forces 1 mN.
constexpr std::int32_t um_from_mm(double mm) noexcept { return round_to_int32(mm * 1000.0); }
constexpr double mm_from_um(std::int32_t um) noexcept { return static_cast<double>(um) / 1000.0; }
constexpr std::int32_t micro_from_unit(double unit) noexcept {
  return round_to_int32(unit * 1.0e6);
}
constexpr double unit_from_micro(std::int32_t micro) noexcept {
  return static_cast<double>(micro) / 1.0e6;
}
constexpr std::int32_t millinewton_from_newton(double newton) noexcept {
  return round_to_int32(newton * 1000.0);
}
constexpr double newton_from_millinewton(std::int32_t millinewton) noexcept {
  return static_cast<double>(millinewton) / 1000.0;
}

}  // namespace hallux

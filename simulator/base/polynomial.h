/// Polynomials by Horner's rule. Inside this corner only.
#pragma once

#include <array>
#include <cstddef>

namespace hallux::elementary {

/// coefficients  the constant one first
template <std::size_t Count>
double polynomial(const std::array<double, Count>& coefficients, double x) noexcept {
  double value = coefficients[Count - 1];
  for (std::size_t i = Count - 1; i-- > 0;) value = value * x + coefficients[i];
  return value;
}

}  // namespace hallux::elementary

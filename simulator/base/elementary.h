/// Elementary functions from + - x / and sqrt only: the same bits on every machine, with and
/// without FMA.
///
/// glibc answers differently on processors with and without FMA, and compilers fold constants
/// differently; a replay compared bit by bit can therefore use neither. Accuracy: within 1e-15
/// relative of libm (absolute near zeros of sin and cos), tested in
/// tests/simulator/base/elementary_test.cpp.
#pragma once

namespace hallux::elementary {

/// thread  any; no state
/// domain  |x| <= 1e5 for sin and cos; beyond it, and for NaN and infinities, the result is NaN
double sin(double x) noexcept;
double cos(double x) noexcept;
/// (-pi, pi]; 0 for (0, 0).
double atan2(double y, double x) noexcept;
/// x is clamped to [-1, 1].
double asin(double x) noexcept;
/// 0 below -745, infinity above 709.78.
double exp(double x) noexcept;
/// x > 0; -infinity at 0, NaN below.
double log(double x) noexcept;

}  // namespace hallux::elementary

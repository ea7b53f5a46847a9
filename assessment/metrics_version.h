/// Version of all that turns a recording into measurements: measurements that are kept are those of
/// their version.
#pragma once

#include <cstdint>

namespace hallux::assessment {

/// Raised whenever a recording measures otherwise, be it in a place or a detail: for a new metric,
/// another formula, and for other laws of heat, kerfs or plan, since all of those measure. A test
/// with two whole performances says when (tests/assessment/metrics_version_test.cpp).
inline constexpr std::int32_t metrics_version = 7;

}  // namespace hallux::assessment

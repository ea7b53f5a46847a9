/// Version of all that turns a recording into measurements: measurements that are kept are those of
/// their version.
#pragma once

#include <cstdint>

namespace hallux::assessment {

/// Raised whenever a recording measures otherwise, be it in a place or a detail
/// (tests/assessment/metrics_version_test.cpp says when).
inline constexpr std::int32_t metrics_version = 1;

}  // namespace hallux::assessment

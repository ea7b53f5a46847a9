/// The job that works out the pieces after one kerf more.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/mesh/bone.h"
#include "tests/benchmarks/report/percentiles.h"

namespace hallux::benchmarks {

/// How far each kerf is open.
enum class KerfDepth : std::int32_t {
  /// All in one body.
  Half,
  /// Each cuts a piece off.
  Through
};

/// The job after each of eight kerfs, 4 mm apart along the shaft [ms].
std::vector<Percentiles> pieces_cost_ms(const simulator::Bone& bone, KerfDepth depth);

}  // namespace hallux::benchmarks

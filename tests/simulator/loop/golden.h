/// Compares a recorded attempt with its committed digests.
#pragma once

#include "simulator/mesh/bone.h"
#include "simulator/record/record.h"
#include "tests/simulator/loop/golden_hashes.h"

namespace hallux::tests {

/// Fails the test where the engine version or any digest differs from what is committed.
void expect_golden(const simulator::Bone& bone, const simulator::Recording& recording,
                   const GoldenHashes& golden);

}  // namespace hallux::tests

#include "tests/simulator/loop/golden.h"

#include <gtest/gtest.h>

#include "tests/simulator/loop/recorded_run.h"

namespace hallux::tests {

void expect_golden(const simulator::Bone& bone, const simulator::Recording& recording,
                   const GoldenHashes& golden) {
  EXPECT_EQ(simulator::engine_version, golden_engine_version);
  EXPECT_EQ(hex_from_digest(digest_of(encode_bone(bone))), golden.bone) << "another bone";
  EXPECT_EQ(hex_from_digest(digest_of_tape(recording)), golden.tape) << "another input";
  EXPECT_EQ(hex_from_digest(digest_outputs(recording)), golden.outputs)
      << "the same input gives another output: find out why, or raise the engine version";
}

}  // namespace hallux::tests

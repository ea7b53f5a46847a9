/// Twenty thousand random frames. RapidCheck prints its seed, and a fault names the world it
/// happened in.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <iostream>

#include "tests/simulator/cutting/frames/frame_count.h"

namespace hallux::tests {
namespace {

constexpr int worlds_of_case = 10;
constexpr std::uint64_t frames_wanted = 20'000;

TEST(KerfFrames, EveryRandomFrameIsClosedBalancedAndNoneIsRefused) {
  FrameCount count;
  while (count.frames < frames_wanted && count.faults.empty()) {
    const bool holds = rc::check("frames of random worlds", [&count] {
      // Worlds do not become simpler with a smaller seed: nothing to shrink.
      Random random(*rc::gen::noShrink(
          rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>())));
      for (int i = 0; i < worlds_of_case; ++i) count_world(random.bits(), count);
      RC_ASSERT(count.faults.empty());
    });
    ASSERT_TRUE(holds) << count.faults.front();
  }
  std::cout << sentence_of(count) << '\n';
  for (const std::string& complaint : complaints(count)) ADD_FAILURE() << complaint;
}

// Walls whose border ran there and back once held triangles that name a point twice, and their
// commit never ended.
TEST(KerfFrames, AWallWithABorderThereAndBackIsCommitted) {
  FrameCount count;
  count_world(5353960295403439220U, count);
  EXPECT_EQ(count.commits, 4U);
  for (const std::string& fault : count.faults) ADD_FAILURE() << fault;
}

// Pairs of triangles over the same three points, back to back: to split their common edge made the
// next such pair.
TEST(KerfFrames, FacesThatLieBackToBackAreCommitted) {
  FrameCount count;
  count_world(7465036831818522997U, count);
  EXPECT_EQ(count.commits, 4U);
  for (const std::string& fault : count.faults) ADD_FAILURE() << fault;
}

}  // namespace
}  // namespace hallux::tests

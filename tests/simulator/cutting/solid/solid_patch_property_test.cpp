/// Every frame's patch against the kerf and the skin it was made from (frame_properties.h).
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/simulator/cutting/frames/frame_properties.h"

namespace hallux::tests {
namespace {

/// Plays a bone, and a lattice every fourth time; each frame that reached bone must hold what is
/// claimed.
void expect_of_frames(std::uint64_t seed, bool (*holds)(const PlayedFrame&)) {
  Random random(seed);
  const auto visit = [&](const PlayedFrame& frame) { RC_ASSERT(holds(frame)); };
  if (seed % 4 == 0) {
    play_lattice(random, visit, {});
  } else {
    play_bone(random, visit, {});
  }
}

RC_GTEST_PROP(PatchProperty, WallsLieOnTheKerfsPlanes, (std::uint64_t seed)) {
  expect_of_frames(seed, has_walls_on_planes);
}

RC_GTEST_PROP(PatchProperty, NothingStandsInTheOpenKerf, (std::uint64_t seed)) {
  expect_of_frames(seed, has_empty_kerf);
}

RC_GTEST_PROP(PatchProperty, SkinKeepsThePlaceAndTheSlopeOfTheTriangleItComesFrom,
              (std::uint64_t seed)) {
  expect_of_frames(seed, keeps_skin);
}

RC_GTEST_PROP(PatchProperty, NewPointsOfTheSkinAreInterpolatedFromTheirParent,
              (std::uint64_t seed)) {
  expect_of_frames(seed, interpolates_skin);
}

}  // namespace
}  // namespace hallux::tests

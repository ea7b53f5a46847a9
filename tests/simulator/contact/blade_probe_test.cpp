#include "simulator/contact/blade_probe.h"

#include <gtest/gtest.h>

#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

constexpr double tooth_mm = 10.0 / static_cast<double>(tooth_count);

/// A block 40 x 20 x 6 with nothing cut yet.
struct UncutBlock {
  Bone bone = tests::cortical_bone(tests::solid_block({40.0, 20.0, 6.0}));
  TissueMap tissue{bone};
  KerfSet kerfs{{}, bone.world_from_bone};
  RemainingTissue standing{tissue, kerfs, {}};
};

TEST(BladeProbe, TeethSpreadEvenlyOverTheWidthOfTheBlade) {
  const auto points = tooth_points(tests::blade_down({1.0, 2.0, 3.0}), {}, 0.5, 0.1);
  EXPECT_NEAR(points.front().z, 3.0 - 5.0 + 0.5 * tooth_mm, 1e-12);
  EXPECT_NEAR(points.back().z, 3.0 + 5.0 - 0.5 * tooth_mm, 1e-12);
  for (const Vec3& point : points) {
    EXPECT_NEAR(point.y, 1.5, 1e-12);  // ahead is towards -y
    EXPECT_NEAR(point.x, 0.9, 1e-12);  // aside is the blade's z, here -x
  }
}

TEST(BladeProbe, EngagesTheTeethThatStandInBone) {
  const UncutBlock block;
  OfFragments<TeethMemory> teeth{};
  // The middles of 13 of 21 teeth lie within the block's 6 mm.
  const Engagement inside =
      engagement(tests::blade_down({0.0, 5.0, 0.0}), block.standing, 0.0, teeth);
  EXPECT_NEAR(inside.cortical_mm, 13.0 * tooth_mm, 1e-9);
  EXPECT_EQ(inside.cancellous_mm, 0.0);
  const Engagement above =
      engagement(tests::blade_down({0.0, 10.1, 0.0}), block.standing, 0.0, teeth);
  EXPECT_EQ(above.width_mm(), 0.0);
  const Engagement ahead =
      engagement(tests::blade_down({0.0, 10.1, 0.0}), block.standing, 0.2, teeth);
  EXPECT_NEAR(ahead.cortical_mm, 13.0 * tooth_mm, 1e-9);
}

TEST(BladeProbe, AToothMeetsBoneWithEachSideOfItsThickness) {
  const UncutBlock block;
  OfFragments<TeethMemory> teeth{};
  // The block ends at x = 20; the blade's middle is just beyond, one side of its 0.5 mm still over
  // bone.
  EXPECT_GT(engagement(tests::blade_down({20.2, 5.0, 0.0}), block.standing, 0.0, teeth).width_mm(),
            0.0);
  EXPECT_EQ(engagement(tests::blade_down({20.3, 5.0, 0.0}), block.standing, 0.0, teeth).width_mm(),
            0.0);
}

TEST(BladeProbe, AnEdgeMeetsBoneOnlyOnItsOwnSide) {
  const UncutBlock block;
  const RigidTransform pose = tests::blade_down({0.0, 5.0, 4.0});  // spans z from -1 to 9
  EXPECT_TRUE(edge_meets_bone(pose, block.standing, -1.0));
  EXPECT_FALSE(edge_meets_bone(pose, block.standing, 1.0));
}

TEST(BladeProbe, ABladeIsInBoneWithItsMiddleOrAnEdge) {
  const UncutBlock block;
  EXPECT_TRUE(blade_is_in_bone(tests::blade_down({0.0, 9.0, 0.0}), block.standing));
  EXPECT_TRUE(blade_is_in_bone(tests::blade_down({0.0, 9.0, 7.0}), block.standing));
  EXPECT_FALSE(blade_is_in_bone(tests::blade_down({0.0, 10.5, 0.0}), block.standing));
  EXPECT_FALSE(blade_is_in_bone(tests::blade_down({0.0, 9.0, 9.0}), block.standing));
}

}  // namespace
}  // namespace hallux::simulator

#include "simulator/contact/bore/drilled_tissue.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/simulator/contact/bore/bore_world.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

/// A block up to y = 10 with a hole of 2 mm radius down to y = 2.
class DrilledBlock : public ::testing::Test {
 protected:
  std::optional<BallSurface> near(const Vec3& centre_mm, double radius_mm, double within_mm) {
    BallMemory memory;
    return tissue_.near_ball({centre_mm, radius_mm}, within_mm, memory);
  }

  BoreWorld world_{cortical_bone(solid_block({40.0, 20.0, 30.0}))};
  std::array<Capsule, 1> holes_{Capsule{{0.0, 14.0, 0.0}, {0.0, 4.0, 0.0}, 2.0}};
  RemainingTissue bone_ = world_.standing();
  DrilledTissue tissue_{bone_, holes_};
};

TEST_F(DrilledBlock, IsAirInTheHoleAndBoneBesideIt) {
  EXPECT_EQ(tissue_.at({0.0, 5.0, 1.9}), Tissue::None);
  EXPECT_EQ(tissue_.at({0.0, 2.1, 0.0}), Tissue::None);
  EXPECT_EQ(tissue_.at({0.0, 1.9, 0.0}), Tissue::Cortical);
  EXPECT_EQ(tissue_.at({0.0, 5.0, 2.1}), Tissue::Cortical);
}

TEST_F(DrilledBlock, HasAWallAroundABallInTheHole) {
  const auto wall = near({1.5, 6.0, 0.0}, 0.1, 1.0);
  ASSERT_TRUE(wall.has_value());
  EXPECT_NEAR(wall->height_mm, 0.5, 1e-12);
  EXPECT_NEAR(wall->normal.x, -1.0, 1e-12);
  EXPECT_FALSE(near({0.5, 6.0, 0.0}, 0.1, 1.0).has_value());
}

TEST_F(DrilledBlock, LeadsABallOutOfTheBoneToTheNearerOfSkinAndWall) {
  const auto to_hole = near({2.3, 6.0, 0.0}, 0.1, 1.0);
  ASSERT_TRUE(to_hole.has_value());
  EXPECT_NEAR(to_hole->height_mm, -0.3, 1e-12);
  EXPECT_NEAR(to_hole->normal.x, -1.0, 1e-12);
  const auto to_skin = near({2.3, 9.9, 0.0}, 0.1, 1.0);
  ASSERT_TRUE(to_skin.has_value());
  EXPECT_NEAR(to_skin->height_mm, -0.1, 1e-12);
  EXPECT_NEAR(to_skin->normal.y, 1.0, 1e-12);
  EXPECT_FALSE(near({8.0, 4.0, 0.0}, 0.1, 1.0).has_value());  // no way out
}

TEST_F(DrilledBlock, HasNoSkinOverTheMouthForABallThatFits) {
  EXPECT_FALSE(near({0.0, 10.3, 0.0}, 0.1, 1.0).has_value());
  const auto wide = near({0.0, 10.3, 0.0}, 2.5, 3.0);
  ASSERT_TRUE(wide.has_value());
  EXPECT_NEAR(wide->height_mm, 0.3, 1e-12);
  EXPECT_NEAR(near({4.0, 10.3, 0.0}, 0.1, 1.0)->height_mm, 0.3, 1e-12);
}

TEST_F(DrilledBlock, HasSkinOverTheMouthForTheTipOfAToolThatIsWider) {
  BallMemory memory;
  const auto skin = tissue_.near_ball({{0.0, 10.3, 0.0}, 2.1}, 1.0, memory);
  ASSERT_TRUE(skin.has_value());
  EXPECT_NEAR(skin->height_mm, 0.3, 1e-12);
}

TEST_F(DrilledBlock, AnswersTheSameWithAMemory) {
  BallMemory memory;
  for (int i = 0; i <= 600; ++i) {
    const Vec3 centre{-3.0 + 0.01 * i, 13.0 - 0.02 * i, 0.5};
    BallMemory nothing;
    const auto kept = tissue_.near_ball({centre, 0.1}, 0.8, memory);
    const auto fresh = tissue_.near_ball({centre, 0.1}, 0.8, nothing);
    // A far answer may be left out by one of the two only where it is beyond what was asked for.
    const bool is_near = fresh && fresh->height_mm <= 0.8;
    ASSERT_EQ(kept && kept->height_mm <= 0.8, is_near) << i;
    if (is_near) {
      EXPECT_EQ(kept->height_mm, fresh->height_mm) << i;
    }
  }
}

}  // namespace
}  // namespace hallux::tests

#include "ui/sight/sight_samples.h"

#include <gtest/gtest.h>

#include "simulator/cutting/field/kerf.h"
#include "tests/support/worlds.h"

namespace hallux::ui {
namespace {

using simulator::Blade;

/// A block of 20 x 12 x 8 mm, and a blade that comes from above.
struct Block {
  simulator::CutSolid solid = simulator::uncut_solid(tests::solid_block({20.0, 12.0, 8.0}));
  simulator::Bvh tree{solid.mesh};
  Blade blade{.width_mm = 10.0, .depth_mm = 20.0};

  WholeBone whole() const { return {solid, tree, {}}; }
  static RigidTransform above(double distance_mm) {
    return {rotation_from_axes(Vec3(0.0, -1.0, 0.0), Vec3(1.0, 0.0, 0.0)),
            Vec3(0.0, 6.0 + distance_mm, 0.0)};
  }
  simulator::KerfOpening opened_to(double depth_mm) const {
    simulator::KerfField field{{.spacing_mm = 0.1, .u_count = 801, .v_count = 801}};
    simulator::FieldWindow changed;
    field.stamp(blade, {Vec2(-2.0, 0.0), Vec2(1.0, 0.0)}, {Vec2(depth_mm, 0.0), Vec2(1.0, 0.0)},
                changed);
    return opening_of({above(0.0), 0.5}, field);
  }
};

TEST(ToothPlaces, LieOnTheTeethWhileTheyAreInTheAir) {
  const Block block;
  const std::vector<SightPlace> places =
      tooth_places(block.whole(), Block::above(5.0), block.blade);
  ASSERT_EQ(places.size(), 10U);
  for (const SightPlace& place : places) {
    EXPECT_NEAR(place[0].y, 11.0, 1.0e-9);
    EXPECT_LT(std::abs(place[0].x), 5.0);
    EXPECT_NEAR(glm::distance(place[0], place[1]), 0.4 + 0.2, 1.0e-9) << "both faces of the blade";
  }
}

TEST(ToothPlaces, OfTeethInOrBeyondBoneLieWhereTheBladeGoesIn) {
  const Block block;
  for (const double above_mm : {-1.0, -7.0, -13.0, -17.0}) {
    for (const SightPlace& place :
         tooth_places(block.whole(), Block::above(above_mm), block.blade)) {
      EXPECT_NEAR(place[0].y, 6.0, 1.0e-6) << above_mm;
    }
  }
}

TEST(MouthPlaces, RunAlongWhatIsOpenOnTheBladesSide) {
  const Block block;
  EXPECT_TRUE(mouth_places(block.whole(), block.opened_to(-1.0)).empty());
  for (const double depth_mm : {0.5, 5.0, 13.0}) {
    const std::vector<SightPlace> places = mouth_places(block.whole(), block.opened_to(depth_mm));
    EXPECT_NEAR(static_cast<double>(places.size()), 20.0, 1.0)
        << "10 mm, by halves, not on the far side";
    for (const SightPlace& place : places) {
      EXPECT_NEAR(place[0].y, 6.0, 1.0e-6);
      EXPECT_NEAR(glm::distance(place[0], place[1]), 0.5 + 0.2, 1.0e-9) << "both rims";
    }
  }
}

}  // namespace
}  // namespace hallux::ui

#include "simulator/cutting/slice/kerf_arrangement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulator/cutting/frames/kerf_play.h"
#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/simulator/cutting/worlds/outlines.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

/// A bone cut across its x axis; the kerf's x and y are the bone's y and z.
struct Across {
  CutSolid solid;
  SlabSlice contact;
  KerfArrangement arrangement;

  explicit Across(IndexedMesh mesh)
      : solid(uncut_solid(std::move(mesh))),
        contact(slice_slab(solid, Bvh(solid.mesh), axis_plane(0, 0.1, 0.5), 0, Vec2(-40.0),
                           Vec2(40.0))),
        arrangement(contact) {}
};

bool any_open(const Across& across) {
  for (std::uint32_t i = 0; i < across.contact.points.size(); ++i) {
    if (across.arrangement.is_open(i)) return true;
  }
  return false;
}

TEST(KerfArrangement, ARegionOverAllOpensEveryPointWithoutACrossing) {
  Across across(solid_block(Vec3(20.0, 10.0, 8.0)));
  ASSERT_TRUE(across.arrangement.arrange(whole_plane()));
  for (std::uint32_t i = 0; i < across.contact.points.size(); ++i) {
    EXPECT_TRUE(across.arrangement.is_open(i));
  }
  EXPECT_TRUE(across.arrangement.crossings().empty());
  EXPECT_TRUE(across.arrangement.hits().empty());
  EXPECT_TRUE(across.arrangement.takes_section());
}

TEST(KerfArrangement, ARegionBesideTheBoneReachesNothing) {
  Across across(solid_block(Vec3(20.0, 10.0, 8.0)));
  ASSERT_TRUE(across.arrangement.arrange(rectangle_outline(Vec2(6.0, -3.0), Vec2(9.0, 3.0))));
  EXPECT_FALSE(any_open(across));
  EXPECT_FALSE(across.arrangement.is_reached(0));
  EXPECT_FALSE(across.arrangement.takes_section());
  ASSERT_TRUE(across.arrangement.arrange({}));
  EXPECT_FALSE(across.arrangement.is_reached(0));
}

TEST(KerfArrangement, AStraightFrontEntersAndLeavesEachPlanesContourOnce) {
  Across across(solid_block(Vec3(20.0, 10.0, 8.0)));
  ASSERT_TRUE(across.arrangement.arrange(rectangle_outline(Vec2(-9.0, -9.0), Vec2(0.3, 9.0))));
  int above = 0, below = 0;
  for (const StripCrossing& crossing : across.arrangement.crossings()) {
    const StripEdge& edge = across.contact.edges[crossing.strip_edge];
    above += edge.level > 0 ? 1 : 0;
    below += edge.level < 0 ? 1 : 0;
    EXPECT_EQ(crossing.region_edge, 1U);
    const double v_mm = crossing.region_share * 18.0 - 9.0;
    EXPECT_NEAR(std::abs(v_mm), 4.0, 1e-12);
  }
  EXPECT_EQ(above, 2);
  EXPECT_EQ(below, 2);
  EXPECT_FALSE(across.arrangement.takes_section());
}

TEST(KerfArrangement, CornersKnowWhetherBoneStandsAroundThem) {
  Across tube(hollow_tube({.segments = 12}));
  const RegionOutline region =
      outline_from({{Vec2(0.0, 0.0), Vec2(6.5, 0.0), Vec2(20.0, 1.0), Vec2(6.5, 0.5)}});
  ASSERT_TRUE(tube.arrangement.arrange(region));
  const std::span<const RegionCorner> corners = tube.arrangement.corners();
  ASSERT_EQ(corners.size(), 4U);
  const std::array<std::int32_t, 4> expected{0, 1, 0, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(corners[i].windings_above, expected[i]) << i;
    EXPECT_EQ(corners[i].windings_below, expected[i]) << i;
  }
}

TEST(KerfArrangement, AnOutlineThatWindsTwiceOrBackwardsIsRefused) {
  Across across(solid_block(Vec3(20.0, 10.0, 8.0)));
  const LoopCorners square = rectangle_loop(Vec2(-9.0), Vec2(9.0));
  EXPECT_FALSE(across.arrangement.arrange(outline_from({square, square})));
  EXPECT_FALSE(across.arrangement.arrange(outline_from({turned_back(square)})));
  EXPECT_TRUE(across.arrangement.arrange(outline_from({square})));
}

TEST(KerfArrangement, LoopsThatAreLessThanALatticeStepWideAreNone) {
  Across across(solid_block(Vec3(20.0, 10.0, 8.0)));
  const double less_mm = 1e-8;
  ASSERT_TRUE(across.arrangement.arrange(rectangle_outline(Vec2(0.0), Vec2(less_mm))));
  EXPECT_TRUE(across.arrangement.corners().empty());
  EXPECT_FALSE(across.arrangement.is_reached(0));
}

TEST(KerfArrangement, AnUprightLineMeetsASlopingSkinWithWeightsOfItsPlace) {
  IndexedMesh wedge = solid_block(Vec3(20.0, 10.0, 8.0));
  for (Vec3& point_mm : wedge.points_mm) point_mm.x += 0.01 * point_mm.y;
  const CutSolid solid = uncut_solid(wedge);
  // The slab holds part of the block's sloping end.
  const SlabSlice contact =
      slice_slab(solid, Bvh(solid.mesh), axis_plane(0, 10.0, 0.5), 0, Vec2(-40.0), Vec2(40.0));
  KerfArrangement arrangement(contact);
  ASSERT_TRUE(arrangement.arrange(rectangle_outline(Vec2(-2.0, -1.0), Vec2(3.0, 2.0))));
  ASSERT_EQ(arrangement.hits().size(), 4U);
  for (const CornerHit& hit : arrangement.hits()) {
    double sum = 0.0;
    Vec3 point_mm(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      sum += hit.weights[k];
      EXPECT_GE(hit.weights[k], 0.0);
      point_mm += hit.weights[k] *
                  contact.points[contact.triangles[hit.triangle].points[k]].point_in_bone_mm;
    }
    EXPECT_NEAR(sum, 1.0, 1e-15);
    const Vec2& corner_mm = arrangement.corners()[hit.corner].place_mm;
    EXPECT_NEAR(point_mm.y, corner_mm.x, 1e-6);
    EXPECT_NEAR(point_mm.z, corner_mm.y, 1e-6);
    EXPECT_NEAR(point_mm.x, 10.0 + 0.01 * corner_mm.x, 1e-6);
  }
}

TEST(KerfArrangement, CrossingsOnAStripEdgeAlternateFromTheStateOfItsBeginning) {
  std::size_t chains = 0;
  const auto visit = [&](const PlayedFrame& frame) {
    KerfArrangement arrangement(frame.contact);
    ASSERT_TRUE(arrangement.arrange(frame.region));
    for (std::uint32_t i = 0; i < frame.contact.edges.size(); ++i) {
      const StripEdge& edge = frame.contact.edges[i];
      bool is_open = arrangement.is_open(edge.a);
      for (const std::uint32_t crossing : arrangement.chain(i)) {
        ASSERT_EQ(arrangement.crossings()[crossing].strip_edge, i);
        ASSERT_EQ(arrangement.crossings()[crossing].entry, is_open ? -1 : 1);
        is_open = !is_open;
        ++chains;
      }
      ASSERT_EQ(is_open, arrangement.is_open(edge.b));
    }
  };
  Random random(12);
  for (int i = 0; i < 4; ++i) play_bone(random, visit, {});
  for (int i = 0; i < 4; ++i) play_lattice(random, visit, {});
  EXPECT_GT(chains, 1000U);
}

}  // namespace
}  // namespace hallux::tests

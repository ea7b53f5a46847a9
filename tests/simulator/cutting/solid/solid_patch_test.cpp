#include "simulator/cutting/solid/solid_patch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/simulator/cutting/worlds/outlines.h"
#include "tests/simulator/cutting/worlds/shown_solid.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

/// One region taken out of a solid.
struct Frame {
  CutSolid solid;
  SlabSlice contact;
  SolidPatch patch;
  bool takes_section = false;

  Frame(IndexedMesh mesh, const KerfPlane& plane, const RegionOutline& region)
      : solid(uncut_solid(std::move(mesh))),
        contact(slice_slab(solid, Bvh(solid.mesh), plane, 3, Vec2(-40.0), Vec2(40.0))) {
    PatchBuilder builder(contact);
    EXPECT_TRUE(builder.build(region, patch));
    takes_section = builder.takes_section();
    EXPECT_TRUE(is_closed_as_chain(shown()));
  }
  IndexedMesh shown() const { return shown_mesh(solid, patch); }
  double removed_mm3() const { return signed_volume_mm3(solid.mesh) - signed_volume_mm3(shown()); }
  std::vector<Triangle> faces(std::int32_t kerf, std::int32_t side) const {
    std::vector<Triangle> chosen;
    for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
      if (patch.sources[i] == FaceSource{kerf, side}) chosen.push_back(patch.triangles[i]);
    }
    return chosen;
  }
  Vec3 place(std::uint32_t point) const {
    const std::size_t count = solid.mesh.points_mm.size();
    return point < count ? solid.mesh.points_mm[point] : patch.points_in_bone_mm[point - count];
  }
  double area_mm2(const std::vector<Triangle>& triangles) const {
    double sum_mm2 = 0.0;
    for (const Triangle& corners : triangles) {
      const Vec3 a = place(corners[0]);
      const Vec3 normal = glm::cross(place(corners[1]) - a, place(corners[2]) - a);
      sum_mm2 += 0.5 * std::sqrt(glm::dot(normal, normal));
    }
    return sum_mm2;
  }
};

const Vec3 block_mm(20.0, 10.0, 8.0);

// The front lies between the nodes of any field, and on the lattice.
TEST(SolidPatch, ARectangleTakesABoxFromABlock) {
  const Frame frame(solid_block(block_mm), axis_plane(0, 1.0, 0.5),
                    rectangle_outline(Vec2(-7.0, -6.0), Vec2(1.3125, 6.0)));
  const double expected_mm3 = 6.3125 * 8.0 * 0.5;
  EXPECT_NEAR(frame.removed_mm3(), expected_mm3, 1e-12 * 1600.0);
  EXPECT_NEAR(frame.area_mm2(frame.faces(3, 1)), 6.3125 * 8.0, 1e-12);
  EXPECT_NEAR(frame.area_mm2(frame.faces(3, -1)), 6.3125 * 8.0, 1e-12);
  EXPECT_NEAR(frame.area_mm2(frame.faces(3, 0)), 8.0 * 0.5, 1e-12);
  EXPECT_FALSE(frame.takes_section);
  EXPECT_EQ(body_count(frame.shown()), 1U);
}

TEST(SolidPatch, ABladeFieldTakesTheSameBox) {
  KerfField field({.origin_mm = Vec2(-8.0), .spacing_mm = 0.25, .u_count = 65, .v_count = 65});
  FieldWindow changed;
  const PlanarPose pose{Vec2(1.3125, 0.0)};
  field.stamp({.width_mm = 12.0, .depth_mm = 8.0}, pose, pose, changed);
  const Frame frame(solid_block(block_mm), axis_plane(0, 1.0, 0.5), outline_of(field));
  EXPECT_NEAR(frame.removed_mm3(), 6.3125 * 8.0 * 0.5, 1e-12 * 1600.0);
}

TEST(SolidPatch, APlungeLeavesAPocketWithoutTouchingTheSkin) {
  const Frame frame(solid_block(block_mm), axis_plane(2, 0.0, 0.5),
                    outline_from({diamond_loop(Vec2(0.0), 2.0)}));
  EXPECT_NEAR(frame.removed_mm3(), 8.0 * 0.5, 1e-12);
  // The region reaches no skin: what is made is a void inside.
  EXPECT_TRUE(frame.patch.hidden.empty());
  EXPECT_EQ(shell_volumes_mm3(frame.shown()).size(), 2U);
  EXPECT_EQ(body_count(frame.shown()), 1U);
}

TEST(SolidPatch, ATubeLosesTheRingAndItsWallsHaveAHole) {
  const Frame frame(hollow_tube({.segments = 12}), axis_plane(0, 0.125, 0.5), whole_plane());
  const double ring_mm2 = 3.0 * (64.0 - 25.0);
  EXPECT_NEAR(frame.removed_mm3(), 0.5 * ring_mm2, 1e-10);
  for (const std::int32_t side : {-1, 1}) {
    const std::vector<Triangle> wall = frame.faces(3, side);
    EXPECT_NEAR(frame.area_mm2(wall), ring_mm2, 1e-10);
    // No point of a wall is nearer to the axis than the flat sides of the canal.
    for (const Triangle& corners : wall) {
      const Vec3 middle_mm =
          (frame.place(corners[0]) + frame.place(corners[1]) + frame.place(corners[2])) / 3.0;
      EXPECT_GE(middle_mm.y * middle_mm.y + middle_mm.z * middle_mm.z, 25.0 * 0.933);
    }
  }
  EXPECT_TRUE(frame.takes_section);
  EXPECT_EQ(body_count(frame.shown()), 2U);
}

TEST(SolidPatch, WallsOfAUStayWithinItsArms) {
  const Frame frame(u_shape(Vec3(30.0, 20.0, 8.0), 6.0), axis_plane(2, 0.125, 0.5), whole_plane());
  const double u_mm2 = 30.0 * 20.0 - 18.0 * 14.0;
  for (const std::int32_t side : {-1, 1}) {
    for (const Triangle& corners : frame.faces(3, side)) {
      const Vec3 middle_mm =
          (frame.place(corners[0]) + frame.place(corners[1]) + frame.place(corners[2])) / 3.0;
      EXPECT_FALSE(std::abs(middle_mm.x) < 9.0 && middle_mm.y > -4.0);
    }
    EXPECT_NEAR(frame.area_mm2(frame.faces(3, side)), u_mm2, 1e-10);
  }
  EXPECT_NEAR(frame.removed_mm3(), 0.5 * u_mm2, 1e-9);
}

TEST(SolidPatch, OneArmOfAUIsCutAndTheOtherStays) {
  // Across both arms; the kerf's x runs along the bone's z and its y along the bone's x.
  const Frame frame(u_shape(Vec3(30.0, 20.0, 8.0), 6.0), axis_plane(1, 5.0, 0.5),
                    rectangle_outline(Vec2(-9.0, -20.0), Vec2(9.0, 0.0)));
  EXPECT_NEAR(frame.removed_mm3(), 6.0 * 8.0 * 0.5, 1e-11);
  EXPECT_TRUE(frame.takes_section);
  EXPECT_EQ(body_count(frame.shown()), 2U);
}

TEST(SolidPatch, ANeighbouringToeIsNotTouched) {
  const IndexedMesh toes = two_blocks(Vec3(10.0, 10.0, 8.0), 2.0);
  // The second block's triangles come behind the first one's; the blade reaches the first only.
  const Frame frame(toes, axis_plane(1, 0.5, 0.5),
                    rectangle_outline(Vec2(-9.0, -20.0), Vec2(9.0, 0.0)));
  ASSERT_FALSE(frame.patch.hidden.empty());
  for (const std::uint32_t triangle : frame.patch.hidden) EXPECT_LT(triangle, 12U);
  EXPECT_GT(frame.contact.touched.back().base_triangle, 11U);
  EXPECT_NEAR(frame.removed_mm3(), 10.0 * 8.0 * 0.5, 1e-11);
}

TEST(SolidPatch, WhateverMissesLeavesThePatchEmpty) {
  const KerfPlane plane = axis_plane(0, 1.0, 0.5);
  const KerfPlane off = axis_plane(0, 11.0, 0.5);
  for (const auto& [asked, region] :
       {std::pair(off, whole_plane()),
        std::pair(plane, rectangle_outline(Vec2(20.0, -3.0), Vec2(30.0, 3.0))),
        std::pair(plane, RegionOutline{})}) {
    const Frame frame(solid_block(block_mm), asked, region);
    EXPECT_TRUE(frame.patch.hidden.empty());
    EXPECT_TRUE(frame.patch.triangles.empty());
    EXPECT_FALSE(frame.takes_section);
  }
}

TEST(SolidPatch, ARefusedRegionLeavesThePatchAsItWas) {
  const CutSolid solid = uncut_solid(solid_block(block_mm));
  const SlabSlice contact =
      slice_slab(solid, Bvh(solid.mesh), axis_plane(0, 1.0, 0.5), 0, Vec2(-40.0), Vec2(40.0));
  PatchBuilder builder(contact);
  SolidPatch patch;
  const RegionOutline half = rectangle_outline(Vec2(-9.0), Vec2(0.0, 9.0));
  ASSERT_TRUE(builder.build(half, patch));
  const SolidPatch before = patch;
  const LoopCorners square = rectangle_loop(Vec2(-9.0), Vec2(9.0));
  EXPECT_FALSE(builder.build(outline_from({square, square}), patch));
  EXPECT_TRUE(are_same(patch, before));
  EXPECT_EQ(builder.refusals(), 1U);
  ASSERT_TRUE(builder.build(half, patch));
  EXPECT_TRUE(are_same(patch, before));
}

TEST(SolidPatch, WhatWasBuiltBeforeDoesNotMatter) {
  const CutSolid solid = uncut_solid(hollow_tube({.segments = 24, .rings = 4}));
  const KerfPlane plane = plane_through(Vec3(1.0, 0.0, 0.0), Vec3(1.0, 0.3, 0.1), 0.5);
  const SlabSlice contact = slice_slab(solid, Bvh(solid.mesh), plane, 0, Vec2(-40.0), Vec2(40.0));
  const RegionOutline last = outline_from({diamond_loop(Vec2(2.0, 1.0), 7.0)});
  PatchBuilder fresh(contact), used(contact);
  SolidPatch of_fresh, of_used;
  ASSERT_TRUE(used.build(whole_plane(), of_used));
  ASSERT_TRUE(used.build(outline_from({diamond_loop(Vec2(-3.0, 0.0), 4.0)}), of_used));
  ASSERT_TRUE(used.build(last, of_used));
  ASSERT_TRUE(fresh.build(last, of_fresh));
  EXPECT_TRUE(are_same(of_fresh, of_used));
}

// Two cubes joined by a bridge of a fifth of a millimetre that the blade leaves.
TEST(SolidPatch, AThinBridgeHoldsUntilItIsGone) {
  const auto with_front_at = [](double v_mm) {
    return Frame(solid_block(block_mm), axis_plane(0, 1.0, 0.5),
                 rectangle_outline(Vec2(-9.0, -9.0), Vec2(9.0, v_mm)));
  };
  const Frame bridged = with_front_at(3.8);
  EXPECT_EQ(body_count(bridged.shown()), 1U);
  EXPECT_FALSE(bridged.takes_section);
  const Frame severed = with_front_at(4.0);
  EXPECT_EQ(body_count(severed.shown()), 2U);
  EXPECT_TRUE(severed.takes_section);
}

}  // namespace
}  // namespace hallux::tests

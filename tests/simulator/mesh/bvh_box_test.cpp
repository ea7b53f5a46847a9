#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/base/random.h"
#include "simulator/mesh/bvh.h"
#include "simulator/mesh/closest_point.h"
#include "simulator/mesh/swept_box.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::solid_block;

Vec3 any_point(Random& random, double side_mm) {
  return {random.uniform(-side_mm, side_mm), random.uniform(-side_mm, side_mm),
          random.uniform(-side_mm, side_mm)};
}

RigidTransform any_pose(Random& random, double side_mm) {
  const Quat rotation = normalised(Quat{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                        random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
  return {rotation, any_point(random, side_mm)};
}

/// By descent: alternately the nearest point of one and of the other, which for two convex bodies ends at the least.
double gap_by_descent_mm(const std::array<Vec3, 3>& corner_mm, const Vec3& half_mm) {
  Vec3 on_box(0.0);
  double distance_mm = 0.0;
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 on_triangle = closest_on_triangle(corner_mm, on_box).point_mm;
    on_box = glm::clamp(on_triangle, -half_mm, half_mm);
    const Vec3 apart = on_triangle - on_box;
    distance_mm = std::sqrt(glm::dot(apart, apart));
  }
  return distance_mm;
}

TEST(BoxGap, IsTheDistanceOfTriangleAndBox) {
  Random random(1);
  const Vec3 half_mm(2.0, 1.0, 0.25);
  int apart = 0, meeting = 0;
  for (int i = 0; i < 120; ++i) {
    std::array<Vec3, 3> corner_mm;
    const Vec3 middle = any_point(random, 3.0);
    for (Vec3& corner : corner_mm) corner = middle + any_point(random, 2.5);
    const BoxGap gap = box_gap(corner_mm, half_mm);
    const double expected_mm = gap_by_descent_mm(corner_mm, half_mm);
    // Alternating projections close in slowly on bodies that just touch.
    ASSERT_NEAR(std::sqrt(gap.squared_mm2), expected_mm, 2.0e-4) << i;
    ASSERT_LE(std::sqrt(gap.squared_mm2), expected_mm + 1.0e-12);
    const Vec3 between = gap.on_triangle_mm - gap.on_box_mm;
    ASSERT_NEAR(glm::dot(between, between), gap.squared_mm2, 1.0e-12);
    const Vec3 off =
        gap.on_triangle_mm - closest_on_triangle(corner_mm, gap.on_triangle_mm).point_mm;
    ASSERT_LT(glm::dot(off, off), 1.0e-20);
    (gap.squared_mm2 > 1.0e-18 ? apart : meeting) += 1;
  }
  EXPECT_GT(apart, 30);
  EXPECT_GT(meeting, 20);
}

TEST(BoxGap, ABoxThatPiercesTheMiddleOfATriangleMeetsIt) {
  const std::array<Vec3, 3> corner_mm{Vec3(-9.0, -9.0, 0.1), Vec3(9.0, -9.0, 0.1),
                                      Vec3(0.0, 9.0, 0.1)};
  EXPECT_EQ(box_gap(corner_mm, Vec3(1.0, 1.0, 0.2)).squared_mm2, 0.0);
  EXPECT_NEAR(std::sqrt(box_gap(corner_mm, Vec3(1.0, 1.0, 0.04)).squared_mm2), 0.06, 1.0e-15);
}

TEST(BvhBox, NearestIsThatOfAllTriangles) {
  const IndexedMesh mesh = tests::sphere(10.0, 6);
  const Bvh bvh{mesh};
  Random random{2};
  for (int i = 0; i < 200; ++i) {
    const OrientedBox box{any_pose(random, 14.0), Vec3(3.0, 2.0, 0.25)};
    double least_mm2 = 1.0e9;
    for (const Triangle& triangle : mesh.triangles) {
      std::array<Vec3, 3> corner_mm;
      for (std::size_t k = 0; k < 3; ++k) {
        corner_mm[k] = transform_point(inverse(box.bone_from_box), mesh.points_mm[triangle[k]]);
      }
      least_mm2 = std::min(least_mm2, box_gap(corner_mm, box.half_mm).squared_mm2);
    }
    const auto found = bvh.nearest_to_box(box);
    ASSERT_TRUE(found);
    ASSERT_NEAR(found->distance_mm, std::sqrt(least_mm2), 1.0e-12);
    const Vec3 apart = found->on_surface_mm - found->on_box_mm;
    ASSERT_NEAR(std::sqrt(glm::dot(apart, apart)), found->distance_mm, 1.0e-12);
    ASSERT_EQ(bvh.touches_box(box), least_mm2 < 1.0e-18);
    ASSERT_EQ(bvh.touches_box(box, found->distance_mm + 1.0e-6), true);
    if (found->distance_mm < 1.0e-3) continue;
    ASSERT_FALSE(bvh.touches_box(box, found->distance_mm - 1.0e-6));
    ASSERT_FALSE(bvh.nearest_to_box(box, found->distance_mm - 1.0e-6));
  }
}

TEST(BvhBox, ABallMeetsTheSurfaceWhereTheNearestPointIsInIt) {
  const Bvh bvh{tests::sphere(10.0, 6)};
  Random random{3};
  for (int i = 0; i < 300; ++i) {
    const Vec3 point = any_point(random, 14.0);
    const double distance_mm = bvh.nearest(point)->distance_mm;
    EXPECT_TRUE(bvh.touches_ball(point, distance_mm + 1.0e-9));
    EXPECT_FALSE(bvh.touches_ball(point, distance_mm - 1.0e-9));
  }
}

TEST(BvhBox, VisitsBringTheNearestPoint) {
  const Bvh bvh{tests::sphere(10.0, 6)};
  Random random{4};
  int all_visits = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 point = any_point(random, 14.0);
    double least_mm = 100.0;
    int visits = 0;
    bvh.visit_near(point, 100.0, [&](const NearTriangle& found) {
      const Vec3 apart = found.closest_mm - point;
      least_mm = std::min(least_mm, std::sqrt(glm::dot(apart, apart)));
      ++visits;
      return least_mm;
    });
    EXPECT_NEAR(least_mm, bvh.nearest(point)->distance_mm, 1.0e-12);
    all_visits += visits;
    visits = 0;
    bvh.visit_near(point, 100.0, [&](const NearTriangle&) {
      ++visits;
      return -1.0;
    });
    EXPECT_LE(visits, 4);
  }
  // Of 432 triangles each, in the middle of the sphere nearly all.
  EXPECT_LT(all_visits, 200 * 60);
}

TEST(SweptBox, StopsWhereItFirstComesToABlock) {
  const Bvh bvh{solid_block(Vec3(20.0, 10.0, 6.0))};
  const CarriedBox blade{Vec3(-10.0, 0.0, 0.0), Vec3(10.0, 5.0, 0.25)};
  // Straight down onto the upper face from 2 mm above: 5 mm of way, free for 2.
  const RigidTransform start{Quat(1.0, 0.0, 0.0, 0.0), Vec3(5.0, 0.0, 5.25)};
  RigidTransform end = start;
  end.translation_mm.z -= 5.0;
  const auto down = first_contact(bvh, blade, {start, end});
  ASSERT_TRUE(down);
  EXPECT_TRUE(down->is_contact);
  EXPECT_NEAR(down->free_share, 2.0 / 5.0, contact_tolerance_mm / 5.0);
  EXPECT_LE(down->free_share, 2.0 / 5.0);
  // Past the block.
  end = start;
  end.translation_mm.y += 30.0;
  EXPECT_FALSE(first_contact(bvh, blade, {start, end}));
  // Begins in contact.
  end.translation_mm = Vec3(0.0);
  EXPECT_EQ(first_contact(bvh, blade, {end, start})->free_share, 0.0);
}

TEST(SweptBox, ATurningBladeStopsWhereItsTipComesDown) {
  const Bvh bvh{solid_block(Vec3(20.0, 10.0, 6.0))};
  // A blade of no thickness whose tool stands 3 mm above the block's edge, turned down about y: its far end, 10 mm away,
  // reaches the upper face at asin(0.3).
  const CarriedBox blade{Vec3(5.0, 0.0, 0.0), Vec3(5.0, 1.0, 0.0)};
  const RigidTransform level{Quat(1.0, 0.0, 0.0, 0.0), Vec3(-9.5, 0.0, 6.0)};
  const RigidTransform turned{rotation_about(Vec3(0.0, 1.0, 0.0), 0.5), level.translation_mm};
  const auto hit = first_contact(bvh, blade, {level, turned});
  ASSERT_TRUE(hit);
  EXPECT_TRUE(hit->is_contact);
  const RigidTransform stopped = interpolate(level, turned, hit->free_share);
  const double height_mm = transform_point(stopped, Vec3(10.0, 0.0, 0.0)).z;
  EXPECT_GE(height_mm, 3.0);
  EXPECT_LE(height_mm, 3.0 + contact_tolerance_mm);
}

TEST(SweptBox, NeverJumpsOverAThinSheetNorGoesIn) {
  const Bvh sheet{solid_block(Vec3(40.0, 40.0, 0.002))};
  Random random{5};
  int stopped = 0;
  for (int i = 0; i < 200; ++i) {
    const CarriedBox box{any_point(random, 2.0), Vec3(2.0, 1.0, 0.2)};
    RigidMotion motion{any_pose(random, 4.0), any_pose(random, 4.0)};
    motion.bone_from_start.translation_mm.z = 9.0;
    motion.bone_from_end.translation_mm.z = -9.0;
    const auto hit = first_contact(sheet, box, motion);
    ASSERT_TRUE(hit);
    stopped += hit->is_contact ? 1 : 0;
    const auto gap_mm = [&](double share) {
      const RigidTransform pose = interpolate(motion.bone_from_start, motion.bone_from_end, share);
      return sheet.nearest_to_box(box.at(pose))->distance_mm;
    };
    // Free up to there, and above the sheet.
    for (int k = 0; k <= 20; ++k) ASSERT_GT(gap_mm(hit->free_share * k / 20.0), 0.0);
    ASSERT_GT(box.at(interpolate(motion.bone_from_start, motion.bone_from_end, hit->free_share))
                  .bone_from_box.translation_mm.z,
              0.0);
  }
  EXPECT_GT(stopped, 195);
}

TEST(SweptBox, TakesNothingFromTheHeap) {
  const Bvh bvh{tests::sphere(10.0, 8)};
  Random random{6};
  const std::uint64_t before = tests::allocations_of_this_thread();
  int met = 0;
  for (int i = 0; i < 100; ++i) {
    const OrientedBox box{any_pose(random, 14.0), Vec3(3.0, 2.0, 0.25)};
    met += bvh.touches_box(box) ? 1 : 0;
    met += bvh.touches_ball(box.bone_from_box.translation_mm, 1.0) ? 1 : 0;
    met += first_contact(bvh, {Vec3(0.0), box.half_mm}, {any_pose(random, 20.0), box.bone_from_box})
               ? 1
               : 0;
  }
  EXPECT_EQ(tests::allocations_of_this_thread(), before);
  EXPECT_GT(met, 20);
}

}  // namespace
}  // namespace hallux::simulator

#include "simulator/cutting/hole/hole_volume.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"
#include "tests/simulator/cutting/worlds/random_worlds.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

double cubed(double value) { return value * value * value; }
double capsule_mm3(const Capsule& capsule) {
  const double radius_mm = capsule.radius_mm;
  return pi * radius_mm * radius_mm * length_of(capsule.to_in_body_mm - capsule.from_in_body_mm) +
         4.0 / 3.0 * pi * cubed(radius_mm);
}

/// The volume is the exact one within its own bound, and the bound is a small share of it.
void expect_exactly(const BoundedVolume& volume, double exact_mm3, double share,
                    double mesh_mm3 = 0.0) {
  EXPECT_LE(std::abs(volume.volume_mm3 - exact_mm3), volume.bound_mm3 + mesh_mm3);
  EXPECT_LE(volume.bound_mm3, share * exact_mm3);
}

TEST(DrilledVolume, OfASlabIsADisc) {
  const Bvh slab(solid_block({40.0, 5.0, 30.0}));
  const std::array hole{Capsule{{3.0, 9.0, 2.0}, {3.0, -9.0, 2.0}, 0.8}};
  // Both faces are level: the border of their two triangles is no uncertainty.
  expect_exactly(drilled_volume(slab, hole), pi * 0.8 * 0.8 * 5.0, 1e-8);
}

TEST(DrilledVolume, OfASlantedSlabIsADiscAsLongAsTheSlant) {
  const Bvh slab(solid_block({40.0, 5.0, 30.0}));
  for (const double slant_rad : {0.2, 0.6, 1.0}) {
    const Vec3 way{elementary::sin(slant_rad), -elementary::cos(slant_rad), 0.0};
    const std::array hole{Capsule{-10.0 * way, 10.0 * way, 0.8}};
    expect_exactly(drilled_volume(slab, hole), pi * 0.8 * 0.8 * 5.0 / elementary::cos(slant_rad),
                   0.01);
  }
}

TEST(DrilledVolume, OfAHoleWithinTheBoneIsTheCapsule) {
  const Bvh block(solid_block({20.0, 20.0, 20.0}));
  for (const Capsule& hole : {Capsule{{1.0, 2.0, -3.0}, {4.0, -1.0, 5.0}, 1.25},
                              Capsule{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, 2.0}}) {
    expect_exactly(drilled_volume(block, {&hole, 1}), capsule_mm3(hole), 1e-8);
  }
}

TEST(DrilledVolume, OfABallHalfInTheBoneIsHalfABall) {
  const Bvh block(solid_block({20.0, 20.0, 20.0}));
  const std::array upright{Capsule{{0.0, 10.0, 0.0}, {0.0, 14.0, 0.0}, 1.0}};
  expect_exactly(drilled_volume(block, upright), 2.0 / 3.0 * pi, 0.05);
  const std::array lying{Capsule{{-3.0, 10.0, 0.0}, {3.0, 10.0, 0.0}, 1.0}};
  // Skin along the axis: a line of cells right through the disc says nothing for certain.
  expect_exactly(drilled_volume(block, lying), 0.5 * capsule_mm3(lying[0]), 0.15);
}

TEST(DrilledVolume, OfASphereThroughItsMiddleIsWhatANapkinRingLacks) {
  const double radius_mm = 8.0, hole_mm = 1.6;
  const Bvh ball(sphere(radius_mm, 60));
  const std::array hole{Capsule{{0.0, 12.0, 0.0}, {0.0, -12.0, 0.0}, hole_mm}};
  const double ring_mm3 =
      4.0 / 3.0 * pi * cubed(std::sqrt(radius_mm * radius_mm - hole_mm * hole_mm));
  // The mesh lies at most 0.27^2 / 8 R = 1.2 um deep, over two discs.
  expect_exactly(drilled_volume(ball, hole), 4.0 / 3.0 * pi * cubed(radius_mm) - ring_mm3, 0.01,
                 2.0 * pi * hole_mm * hole_mm * 0.0012);
}

TEST(DrilledVolume, OfATubeIsItsTwoWalls) {
  const Tube tube{.outer_radius_mm = 8.0, .inner_radius_mm = 5.0, .segments = 512};
  const Bvh solid(hollow_tube(tube));
  const std::array hole{Capsule{{0.0, 15.0, 0.0}, {0.0, -15.0, 0.0}, 1.0}};
  double walls_mm3 = 0.0;
  const int parts = 2000;
  for (int i = 0; i < parts; ++i) {
    const double z_mm = -1.0 + 2.0 * (i + 0.5) / parts;
    const auto half_mm = [&](double radius_mm) {
      return std::sqrt(radius_mm * radius_mm - z_mm * z_mm);
    };
    walls_mm3 += 2.0 / parts * 2.0 * half_mm(1.0) * 2.0 * (half_mm(8.0) - half_mm(5.0));
  }
  // A side of the polygon lies at most R (1 - cos(pi / 512)) = 0.15 um deep.
  expect_exactly(drilled_volume(solid, hole), walls_mm3, 0.01, 1.0e-4 + 4.0 * pi * 0.00016);
}

TEST(DrilledVolume, BesideTheBoneIsNothing) {
  const Bvh block(solid_block({20.0, 20.0, 20.0}));
  const std::array hole{Capsule{{0.0, 12.0, 0.0}, {5.0, 12.0, 0.0}, 1.0}};
  EXPECT_EQ(drilled_volume(block, hole).volume_mm3, 0.0);
  EXPECT_EQ(drilled_volume(block, {}).volume_mm3, 0.0);
}

TEST(DrilledVolume, OfTheSameHoleTwiceIsThatOfOne) {
  const Bvh slab(solid_block({40.0, 5.0, 30.0}));
  const Capsule hole{{3.0, 9.0, 2.0}, {3.0, -9.0, 2.0}, 0.8};
  const std::array twice{hole, hole};
  const BoundedVolume volume = drilled_volume(slab, twice);
  expect_exactly(volume, pi * 0.8 * 0.8 * 5.0, 0.25);
  EXPECT_NEAR(volume.volume_mm3, pi * 0.8 * 0.8 * 5.0, 1e-6);
}

TEST(DrilledVolume, OfAWireRedoneBesideItsHoleCountsTheLensOnce) {
  const Bvh slab(solid_block({40.0, 5.0, 30.0}));
  const double radius_mm = 0.8, apart_mm = 0.6;
  const std::array holes{Capsule{{3.0, 9.0, 2.0}, {3.0, -9.0, 2.0}, radius_mm},
                         Capsule{{3.6, 9.0, 2.0}, {3.6, -9.0, 2.0}, radius_mm}};
  const double half_mm = 0.5 * apart_mm;
  const double chord_mm = std::sqrt(radius_mm * radius_mm - half_mm * half_mm);
  const double angle_rad = elementary::atan2(chord_mm, half_mm);
  const double lens_mm2 = 2.0 * (radius_mm * radius_mm * angle_rad - half_mm * chord_mm);
  const double exact_mm3 = 5.0 * (2.0 * pi * radius_mm * radius_mm - lens_mm2);
  const BoundedVolume volume = drilled_volume(slab, holes);
  expect_exactly(volume, exact_mm3, 0.06);
  EXPECT_NEAR(volume.volume_mm3, exact_mm3, 0.003 * exact_mm3);
}

TEST(DrilledVolume, OfHolesThatCrossCountsTheirCommonPartOnce) {
  const Bvh block(solid_block({20.0, 20.0, 20.0}));
  const std::array holes{Capsule{{-6.0, 0.0, 0.0}, {6.0, 0.0, 0.0}, 1.0},
                         Capsule{{0.0, -6.0, 0.0}, {0.0, 6.0, 0.0}, 1.0}};
  const double exact_mm3 = 2.0 * capsule_mm3(holes[0]) - 16.0 / 3.0;
  const BoundedVolume volume = drilled_volume(block, holes);
  expect_exactly(volume, exact_mm3, 0.02);
  EXPECT_NEAR(volume.volume_mm3, exact_mm3, 0.001 * exact_mm3);
}

Vec3 random_point(Random& random) {
  return {random.uniform(-12.0, 12.0), random.uniform(-12.0, 12.0), random.uniform(-12.0, 12.0)};
}

// Points by chance in the box around each capsule, those that an earlier one holds left out.
RC_GTEST_PROP(DrilledVolumeProperty, IsThatOfPointsByChance, (std::uint64_t seed)) {
  Random random(seed);
  const Bvh bone(random_bone(random));
  std::vector<Capsule> holes;
  for (std::uint64_t i = 0; i <= seed % 3; ++i) {
    const Vec3 from = random_point(random);
    holes.push_back({from, from + random.uniform(2.0, 15.0) * random_direction(random),
                     random.uniform(0.5, 2.0)});
  }
  const BoundedVolume volume = drilled_volume(bone, holes, 16);
  double sampled_mm3 = 0.0, variance_mm6 = 0.0;
  const int count = 4000;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const auto& [a, b, radius_mm] = holes[i];
    const Vec3 low = glm::min(a, b) - Vec3(radius_mm),
               size = glm::max(a, b) + Vec3(radius_mm) - low;
    int held = 0;
    for (int k = 0; k < count; ++k) {
      const Vec3 point = low + Vec3{random.uniform(), random.uniform(), random.uniform()} * size;
      const bool is_new =
          is_in_capsule({&holes[i], 1}, point) && !is_in_capsule({holes.data(), i}, point);
      held += is_new && bone.contains(point) ? 1 : 0;
    }
    const double box_mm3 = size.x * size.y * size.z, share = static_cast<double>(held) / count;
    sampled_mm3 += box_mm3 * share;
    variance_mm6 += box_mm3 * box_mm3 * (share * (1.0 - share) + 1.0 / count) / count;
  }
  RC_ASSERT(std::abs(volume.volume_mm3 - sampled_mm3) <=
            volume.bound_mm3 + 5.0 * std::sqrt(variance_mm6));
}

// What both say of the same hole must overlap, and twice the rings say it closer.
RC_GTEST_PROP(DrilledVolumeProperty, OfTwiceTheRingsLiesWithinTheBound, (std::uint64_t seed)) {
  Random random(seed);
  const Bvh bone(random_bone(random));
  const Vec3 from = random_point(random);
  const std::array hole{Capsule{from, from + 12.0 * random_direction(random), 1.0}};
  const BoundedVolume coarse = drilled_volume(bone, hole, 8), fine = drilled_volume(bone, hole, 64);
  RC_ASSERT(std::abs(coarse.volume_mm3 - fine.volume_mm3) <= coarse.bound_mm3 + fine.bound_mm3);
  RC_ASSERT(fine.bound_mm3 <= 0.3 * coarse.bound_mm3 + 1.0e-6);
}

}  // namespace
}  // namespace hallux::tests

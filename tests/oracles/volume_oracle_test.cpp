// CGAL, in exact numbers, says what a cut must leave: the same bone less the same prism.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "simulator/base/random.h"
#include "simulator/base/units.h"
#include "simulator/cutting/solid/commit_patch.h"
#include "simulator/cutting/solid/opened_volume.h"
#include "simulator/cutting/solid/remove_slab.h"
#include "tests/benchmarks/peers/cgal_solid.h"
#include "tests/benchmarks/worlds/bone_like.h"
#include "tests/oracles/outline_prism.h"
#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/support/outline_area.h"
#include "tests/support/worlds.h"

namespace hallux::oracles {
namespace {

using namespace simulator;
using benchmarks::CgalExactSolid;

IndexedMesh bone_from(Random& random) {
  switch (random.bits() % 4) {
    case 0:
      return benchmarks::make_bone_like({600 + random.bits() % 3'000, random.bits() % 2 == 0});
    case 1:
      return tests::hollow_tube(
          {.segments = 8 + random.bits() % 40, .rings = 1 + random.bits() % 8});
    case 2:
      return tests::u_shape(Vec3(30.0, 20.0, 8.0), 6.0);
    default:
      return tests::sphere(9.0, 3 + random.bits() % 12);
  }
}

Vec3 direction_from(Random& random) {
  const Vec3 direction(random.normal(), random.normal(), random.normal());
  const double length = std::sqrt(glm::dot(direction, direction));
  return length > 0.1 ? direction / length : Vec3(0.0, 0.6, 0.8);
}

KerfPlane plane_from(Random& random) {
  const Vec3 point_mm(random.uniform(-8.0, 8.0), random.uniform(-4.0, 4.0),
                      random.uniform(-3.0, 3.0));
  return tests::plane_through(point_mm, direction_from(random), random.uniform(0.2, 1.2));
}

/// A blade of some size that goes some way in some direction, turning a little.
RegionOutline region_from(Random& random) {
  const Blade blade{
      .width_mm = random.uniform(3.0, 14.0), .depth_mm = random.uniform(5.0, 30.0), .kerf_mm = 0.5};
  const double angle_rad = random.uniform(-pi, pi), turn_rad = random.uniform(-0.4, 0.4);
  const auto pose_at = [&](double forward_mm, double share) {
    const double turned_rad = angle_rad + turn_rad * share;
    const Vec2 feed(std::cos(angle_rad), std::sin(angle_rad));
    return PlanarPose{forward_mm * feed, Vec2(std::cos(turned_rad), std::sin(turned_rad))};
  };
  const double begin_mm = random.uniform(-14.0, -4.0), end_mm = random.uniform(-4.0, 12.0);
  KerfField field{FieldGrid{}};
  FieldWindow changed;
  PlanarPose from = pose_at(begin_mm, 0.0);
  const auto steps = static_cast<int>(1 + random.bits() % 20);
  for (int i = 1; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const PlanarPose to = pose_at(begin_mm + (end_mm - begin_mm) * share, share);
    field.stamp(blade, from, to, changed);
    from = to;
  }
  return outline_of(field);
}

struct Taken {
  CutSolid left;
  double removed_mm3 = 0.0;
};

Taken take(const CutSolid& solid, const KerfPlane& plane, const RegionOutline& region) {
  const Bvh bvh(solid.mesh);
  const SlabSlice contact = slice_slab(solid, bvh, plane, 0, FieldGrid{});
  SolidPatch patch;
  EXPECT_TRUE(PatchBuilder(contact).build(region, patch));
  Taken taken{commit_patch(solid, patch), 0.0};
  taken.removed_mm3 = signed_volume_mm3(solid.mesh) - signed_volume_mm3(taken.left.mesh);
  return taken;
}

double length_mm(const RegionOutline& region) {
  double length = 0.0;
  std::uint32_t first = 0;
  for (const std::uint32_t last : region.loop_ends) {
    for (std::uint32_t i = first; i < last; ++i) {
      const Vec2 step = region.corners_mm[i + 1 < last ? i + 1 : first] - region.corners_mm[i];
      length += std::sqrt(glm::dot(step, step));
    }
    first = last;
  }
  return length;
}

/// Places are decided on a lattice of 2^-20 mm: the region's fronts may stand wrong by a step of
/// it. Sums of volume lose some 1e-12 of the whole bone.
double tolerance_mm3(const IndexedMesh& bone, const RegionOutline& region, double thickness_mm) {
  return length_mm(region) * thickness_mm * 0x1p-20 + 1e-9 * signed_volume_mm3(bone);
}

RegionOutline whole_plane() {
  constexpr double reach_mm = 39.0;
  return {{Vec2(-reach_mm, -reach_mm), Vec2(reach_mm, -reach_mm), Vec2(reach_mm, reach_mm),
           Vec2(-reach_mm, reach_mm)},
          {4}};
}

/// What CGAL says is left of the bone.
double left_by_cgal_mm3(CgalExactSolid& bone, const IndexedMesh& tool) {
  CgalExactSolid taken(tool);
  bone.subtract(taken);
  EXPECT_TRUE(bone.is_closed());
  return bone.volume_mm3();
}

RC_GTEST_PROP(VolumeOracle, AWholeSlabLeavesWhatCgalLeaves, (std::uint64_t seed)) {
  Random random(seed);
  const CutSolid bone = uncut_solid(bone_from(random));
  const KerfPlane plane = plane_from(random);
  CgalExactSolid oracle(bone.mesh);
  const double left_mm3 = left_by_cgal_mm3(oracle, benchmarks::slab_box(plane));
  const Taken taken = take(bone, plane, whole_plane());
  const double by_clip_mm3 = signed_volume_mm3(tests::cut_through(bone, plane).solid.mesh);
  const double tolerance = tolerance_mm3(bone.mesh, {}, plane.thickness_mm);
  RC_ASSERT(std::abs(signed_volume_mm3(taken.left.mesh) - left_mm3) <= tolerance);
  RC_ASSERT(std::abs(by_clip_mm3 - left_mm3) <= tolerance);
}

RC_GTEST_PROP(VolumeOracle, ARegionLeavesWhatCgalLeaves, (std::uint64_t seed)) {
  Random random(seed);
  const CutSolid bone = uncut_solid(bone_from(random));
  const KerfPlane plane = plane_from(random);
  const RegionOutline region = region_from(random);
  CgalExactSolid oracle(bone.mesh);
  const double left_mm3 = left_by_cgal_mm3(oracle, prism_of(region, plane));
  const Taken taken = take(bone, plane, region);
  const double tolerance = tolerance_mm3(bone.mesh, region, plane.thickness_mm);
  RC_ASSERT(std::abs(signed_volume_mm3(taken.left.mesh) - left_mm3) <= tolerance);
  RC_ASSERT(std::abs(opened_volume_mm3(bone, plane, region) - taken.removed_mm3) <= tolerance);
  RC_CLASSIFY(taken.removed_mm3 > 0.1, "met bone");
}

RC_GTEST_PROP(VolumeOracle, CutsOneAfterAnotherLeaveWhatCgalLeaves, (std::uint64_t seed)) {
  Random random(seed);
  CutSolid bone = uncut_solid(bone_from(random));
  CgalExactSolid oracle(bone.mesh);
  double tolerance = 0.0;
  for (int cut = 0; cut < 3; ++cut) {
    const KerfPlane plane = plane_from(random);
    const RegionOutline region = region_from(random);
    const double left_mm3 = left_by_cgal_mm3(oracle, prism_of(region, plane));
    tolerance += tolerance_mm3(bone.mesh, region, plane.thickness_mm);
    bone = take(bone, plane, region).left;
    tests::expect_closed(bone);
    RC_ASSERT(!::testing::Test::HasFailure());
    RC_ASSERT(std::abs(signed_volume_mm3(bone.mesh) - left_mm3) <= tolerance);
  }
}

TEST(VolumeOracle, ItsOwnBlockLessASlabIsWhatAHandComputes) {
  CgalExactSolid block(tests::solid_block(Vec3(20.0, 10.0, 6.0)));
  const double left_mm3 =
      left_by_cgal_mm3(block, benchmarks::slab_box(tests::axis_plane(0, 1.0, 0.5)));
  EXPECT_NEAR(left_mm3, 19.5 * 10.0 * 6.0, 1e-9);
}

TEST(VolumeOracle, ItsOwnPrismOfARegionHasTheRegionsVolume) {
  Random random(7);
  for (int i = 0; i < 10; ++i) {
    const KerfPlane plane = plane_from(random);
    const RegionOutline region = region_from(random);
    const CgalExactSolid prism(prism_of(region, plane));
    EXPECT_TRUE(prism.is_closed());
    EXPECT_NEAR(prism.volume_mm3(), tests::area_mm2(region) * plane.thickness_mm,
                1e-9 * tests::area_mm2(region));
  }
}

TEST(VolumeOracle, TheBenchmarksBonesAreSolidsOfTheWantedSize) {
  for (const bool is_hollow : {false, true}) {
    const IndexedMesh mesh = benchmarks::make_bone_like({5'000, is_hollow});
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), 5'000.0, 200.0);
    const CgalExactSolid bone(mesh);
    EXPECT_TRUE(bone.is_closed());
    EXPECT_NEAR(bone.volume_mm3(), signed_volume_mm3(mesh), 1e-9 * bone.volume_mm3());
    EXPECT_GT(bone.volume_mm3(), 1'000.0);
  }
}

}  // namespace
}  // namespace hallux::oracles

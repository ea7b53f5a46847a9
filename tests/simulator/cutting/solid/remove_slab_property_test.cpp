/// What must hold for any bone and any planes. RapidCheck prints the seed of a failing case;
/// RC_PARAMS="seed=..." repeats it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "simulator/cutting/solid/remove_slab.h"
#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/simulator/cutting/worlds/random_worlds.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

RC_GTEST_PROP(CutProperty, RepeatedCutsStayClosedAndVolumesAddUp, (std::uint64_t seed)) {
  Random random(seed);
  CutSolid solid = uncut_solid(random_bone(random));
  const auto count = static_cast<std::int32_t>(1 + random.bits() % 4);
  for (std::int32_t kerf = 0; kerf < count; ++kerf) {
    const CutOutcome cut = cut_through(solid, random_plane(random), kerf);
    expect_closed(cut.solid);
    expect_balance(solid, cut);
    RC_ASSERT(!::testing::Test::HasFailure());
    solid = cut.solid;
  }
}

RC_GTEST_PROP(CutProperty, LatticeCutsThroughCornersEdgesAndFacesStayClosed, (std::uint64_t seed)) {
  Random random(seed);
  // Quarters of a millimetre, kerfs of half a millimetre, normals along axes and their diagonals:
  // everything coincides.
  const auto steps = [&](int reach) {
    return static_cast<double>(random.bits() % static_cast<std::uint64_t>(2 * reach + 1)) - reach;
  };
  CutSolid solid = uncut_solid(random.bits() % 2 == 0 ? solid_block(Vec3(4.0, 3.0, 2.0))
                                                      : u_shape(Vec3(5.0, 4.0, 2.0), 1.0));
  for (std::int32_t kerf = 0; kerf < 4; ++kerf) {
    const Vec3 normal(steps(1), steps(1), steps(1));
    if (glm::dot(normal, normal) == 0.0) continue;
    const Vec3 point_mm = 0.25 * Vec3(steps(8), steps(6), steps(4));
    const KerfPlane plane = random.bits() % 2 == 0
                                ? axis_plane(random.bits() % 3, 0.25 * steps(8), 0.5)
                                : plane_through(point_mm, normal, 0.5);
    const CutOutcome cut = cut_through(solid, plane, kerf);
    expect_closed(cut.solid);
    expect_balance(solid, cut);
    RC_ASSERT(!::testing::Test::HasFailure());
    solid = cut.solid;
  }
}

RC_GTEST_PROP(CutProperty, ARigidMotionOfBoneAndPlaneChangesNothing, (std::uint64_t seed)) {
  Random random(seed);
  const IndexedMesh mesh = random_bone(random);
  const KerfPlane plane = random_plane(random);
  const RigidTransform motion{rotation_about(random_direction(random), random.uniform(-3.0, 3.0)),
                              10.0 * random_direction(random)};
  const CutOutcome here = cut_through(uncut_solid(mesh), plane);
  const CutOutcome there = cut_through(uncut_solid(moved(mesh, motion)),
                                       {motion * plane.bone_from_kerf, plane.thickness_mm});
  RC_ASSERT(std::abs(here.removed_mm3 - there.removed_mm3) <= 1e-9 * (1.0 + here.removed_mm3));
  const auto counted = [](const CutOutcome& cut) {
    return static_cast<double>(cut.solid.mesh.triangles.size());
  };
  RC_ASSERT(std::abs(counted(here) - counted(there)) <= 2.0 + 0.02 * counted(here));
}

RC_GTEST_PROP(CutProperty, TwiceTheSizeIsEightTimesTheVolume, (std::uint64_t seed)) {
  Random random(seed);
  const IndexedMesh mesh = random_bone(random);
  KerfPlane plane = random_plane(random);
  const CutOutcome small = cut_through(uncut_solid(mesh), plane);
  IndexedMesh doubled = mesh;
  for (Vec3& point_mm : doubled.points_mm) point_mm *= 2.0;
  plane.bone_from_kerf.translation_mm *= 2.0;
  plane.thickness_mm *= 2.0;
  const CutOutcome large = cut_through(uncut_solid(doubled), plane);
  // Doubling is exact in binary.
  RC_ASSERT(large.removed_mm3 == 8.0 * small.removed_mm3);
  RC_ASSERT(large.solid.mesh.triangles.size() == small.solid.mesh.triangles.size());
}

TEST(CutDense, AHundredThousandTrianglesAreCutAlongAndAcross) {
  CutSolid solid = uncut_solid(dense_sphere(20.0, 100'000));
  for (std::int32_t kerf = 0; kerf < 3; ++kerf) {
    const Vec3 normal = kerf == 0 ? Vec3(0.0, 0.3, 1.0) : Vec3(1.0, 0.2 * kerf - 0.3, 0.1);
    const CutOutcome cut = cut_through(solid, plane_through(Vec3(0.1), normal, 0.5), kerf);
    expect_closed(cut.solid);
    expect_balance(solid, cut);
    solid = cut.solid;
  }
  EXPECT_GE(split_pieces(solid).size(), 6U);
}

}  // namespace
}  // namespace hallux::tests

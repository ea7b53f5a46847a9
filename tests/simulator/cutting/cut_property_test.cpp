/// What must hold for any bone and any planes. RapidCheck prints the seed of a failing case; RC_PARAMS="seed=..."
/// repeats it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "simulator/base/random.h"
#include "simulator/cutting/cut.h"
#include "tests/simulator/cutting/cut_through.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

Vec3 direction_from(Random& random) {
  Vec3 direction(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
  const double length = std::sqrt(glm::dot(direction, direction));
  return length > 0.1 ? direction / length : Vec3(0.0, 0.6, 0.8);
}

/// A bone-like solid: a wavy tube, a wavy sphere, a U or a block.
IndexedMesh bone_from(Random& random) {
  IndexedMesh mesh;
  switch (random.bits() % 4) {
    case 0:
      mesh = hollow_tube({.segments = 24, .rings = 1 + random.bits() % 12});
      break;
    case 1:
      mesh = sphere(9.0, 3 + random.bits() % 10);
      break;
    case 2:
      mesh = u_shape(Vec3(30.0, 20.0, 8.0), 6.0);
      break;
    default:
      mesh = solid_block(Vec3(25.0, 12.0, 10.0));
      break;
  }
  const Vec3 slope = 0.1 * direction_from(random);
  for (Vec3& point_mm : mesh.points_mm) {
    // A shear that bends: orientation and closedness stay.
    point_mm.y += slope.x * point_mm.x + 0.002 * slope.y * point_mm.x * point_mm.x;
    point_mm.z += slope.z * point_mm.x;
  }
  return mesh;
}

KerfPlane plane_from(Random& random) {
  const Vec3 point_mm(random.uniform(-8.0, 8.0), random.uniform(-4.0, 4.0),
                      random.uniform(-3.0, 3.0));
  return plane_through(point_mm, direction_from(random), random.uniform(0.2, 1.2));
}

RC_GTEST_PROP(CutProperty, RepeatedCutsStayClosedAndVolumesAddUp, (std::uint64_t seed)) {
  Random random(seed);
  CutSolid solid = uncut_solid(bone_from(random));
  const auto count = static_cast<std::int32_t>(1 + random.bits() % 4);
  for (std::int32_t kerf = 0; kerf < count; ++kerf) {
    const CutOutcome cut = cut_through(solid, plane_from(random), kerf);
    expect_closed(cut.solid);
    expect_balance(solid, cut);
    RC_ASSERT(!::testing::Test::HasFailure());
    solid = cut.solid;
  }
}

RC_GTEST_PROP(CutProperty, LatticeCutsThroughCornersEdgesAndFacesStayClosed, (std::uint64_t seed)) {
  Random random(seed);
  // Quarters of a millimetre, kerfs of half a millimetre, normals along axes and their diagonals: everything coincides.
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
  const IndexedMesh mesh = bone_from(random);
  const KerfPlane plane = plane_from(random);
  const RigidTransform motion{rotation_about(direction_from(random), random.uniform(-3.0, 3.0)),
                              10.0 * direction_from(random)};
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
  const IndexedMesh mesh = bone_from(random);
  KerfPlane plane = plane_from(random);
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

#include "simulator/mesh/indexed_mesh.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::solid_block;

TEST(IndexedMesh, VolumeDoesNotDependOnThePlace) {
  const IndexedMesh far =
      tests::moved(solid_block(Vec3{10.0, 20.0, 30.0}), {{}, Vec3{3.0e4, -2.0e4, 1.0e4}});
  // The corners are rounded to 2^-38 mm there; six faces of at most 600 mm2 move by that.
  EXPECT_NEAR(signed_volume_mm3(far), 6000.0, 2200.0 * 0x1p-37);
}

TEST(IndexedMesh, OfNothingHasNoVolume) { EXPECT_EQ(signed_volume_mm3({}), 0.0); }

TEST(IndexedMesh, DigestSeesEveryCoordinateAndIndex) {
  const IndexedMesh block = solid_block(Vec3{1.0, 2.0, 3.0});
  IndexedMesh other = block;
  other.points_mm[3].z += 1.0e-12;
  EXPECT_NE(digest_of_mesh(other), digest_of_mesh(block));
  other = block;
  std::swap(other.triangles[2][0], other.triangles[2][1]);
  EXPECT_NE(digest_of_mesh(other), digest_of_mesh(block));
  EXPECT_EQ(digest_of_mesh(solid_block(Vec3{1.0, 2.0, 3.0})), digest_of_mesh(block));
}

TEST(IndexedMesh, AppendingAddsVolumes) {
  IndexedMesh mesh = solid_block(Vec3{2.0, 2.0, 2.0});
  append_mesh(mesh, tests::inside_out(solid_block(Vec3{1.0, 1.0, 1.0})));
  EXPECT_EQ(mesh.points_mm.size(), 16U);
  EXPECT_NEAR(signed_volume_mm3(mesh), 7.0, 1.0e-12);
}

}  // namespace
}  // namespace hallux::simulator

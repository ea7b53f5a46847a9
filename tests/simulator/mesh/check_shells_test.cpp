#include <gtest/gtest.h>

#include "simulator/mesh/read_mesh.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::inside_out;
using tests::moved;
using tests::solid_block;
using tests::sphere;

IndexedMesh together(IndexedMesh mesh, const IndexedMesh& added) {
  append_mesh(mesh, added);
  return mesh;
}

IndexedMesh shifted(const IndexedMesh& mesh, const Vec3& by_mm) {
  return moved(mesh, RigidTransform{Quat{1.0, 0.0, 0.0, 0.0}, by_mm});
}

std::string refusal(const IndexedMesh& mesh) {
  check_closed_solid(mesh, "bone");
  try {
    check_shells(mesh, "bone");
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

TEST(CheckShells, OneSurfaceTwoApartAndAMarrowCanalAreBones) {
  EXPECT_EQ(refusal(solid_block(Vec3{10.0})), "");
  EXPECT_EQ(refusal(tests::two_blocks(Vec3{10.0, 20.0, 30.0}, 2.0)), "");
  EXPECT_EQ(refusal(tests::hollow_tube({})), "");
  EXPECT_EQ(refusal(together(solid_block(Vec3{10.0}), inside_out(sphere(3.0, 4)))), "");
}

TEST(CheckShells, AnIslandInACanalIsBoneAgain) {
  const IndexedMesh hollow = together(solid_block(Vec3{20.0}), inside_out(solid_block(Vec3{16.0})));
  EXPECT_EQ(refusal(together(hollow, sphere(3.0, 4))), "");
  EXPECT_NE(refusal(together(hollow, inside_out(sphere(3.0, 4)))), "");
}

TEST(CheckShells, SurfacesThatCrossAreRefusedWithThePlace) {
  const IndexedMesh block = solid_block(Vec3{10.0});
  const std::string said = refusal(together(block, shifted(block, {6.0, 1.0, 2.0})));
  EXPECT_NE(said.find("cross (near "), std::string::npos) << said;
  // A rod all of whose corners lie outside of what it goes through.
  const IndexedMesh rod = solid_block(Vec3{40.0, 1.0, 1.0});
  EXPECT_NE(refusal(together(block, rod)).find("cross"), std::string::npos);
  const IndexedMesh bead = together(solid_block(Vec3{20.0}), inside_out(sphere(3.0, 4)));
  EXPECT_NE(refusal(together(bead, inside_out(rod))).find("cross"), std::string::npos);
}

TEST(CheckShells, ABoneInsideABoneIsRefused) {
  const std::string said = refusal(together(solid_block(Vec3{10.0}), sphere(3.0, 4)));
  EXPECT_NE(said.find("inside another that faces outward"), std::string::npos) << said;
}

TEST(CheckShells, ACanalInNoBoneIsRefused) {
  const IndexedMesh canal = shifted(inside_out(sphere(3.0, 4)), {30.0, 0.0, 0.0});
  const std::string said = refusal(together(solid_block(Vec3{10.0}), canal));
  EXPECT_NE(said.find("lies in no bone"), std::string::npos) << said;
}

TEST(CheckShells, ManyCrumbsTakeNoTime) {
  IndexedMesh mesh = sphere(40.0, 60);
  for (int i = 0; i < 200; ++i) {
    const Vec3 place{0.25 * i - 25.0, 0.1 * (i % 7), 0.2 * (i % 11)};
    if (i % 2 == 0) append_mesh(mesh, shifted(inside_out(sphere(0.05, 2)), place));
  }
  EXPECT_EQ(refusal(mesh), "");
}

}  // namespace
}  // namespace hallux::simulator

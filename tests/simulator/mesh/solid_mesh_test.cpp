#include "simulator/mesh/solid_mesh.h"

#include <gtest/gtest.h>

#include "simulator/mesh/mesh_error.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::solid_block;

TEST(SolidMesh, GivesBackWhatItWasMadeFrom) {
  const IndexedMesh tube = tests::hollow_tube({});
  const SolidMesh solid{tube, "tube"};
  const IndexedMesh back = solid.indexed();
  EXPECT_EQ(back.points_mm, tube.points_mm);
  ASSERT_EQ(back.triangles.size(), tube.triangles.size());
  EXPECT_NEAR(solid.volume_mm3(), signed_volume_mm3(tube), 1.0e-9);
  EXPECT_NEAR(signed_volume_mm3(back), signed_volume_mm3(tube), 1.0e-9);
  EXPECT_EQ(solid.half_edges().n_edges() * 2, solid.triangle_count() * 3);
}

/// Two blocks that touch in one corner, named by one index: half-edges alone would lose one of the two fans.
TEST(SolidMesh, GivesEachFanItsOwnPoint) {
  IndexedMesh mesh = solid_block(Vec3{2.0, 2.0, 2.0});
  const IndexedMesh other = tests::moved(mesh, {{}, Vec3{2.0, 2.0, 2.0}});
  append_mesh(mesh, other);
  std::uint32_t shared = 0;
  while (mesh.points_mm[shared] != Vec3{1.0, 1.0, 1.0}) ++shared;
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& index : triangle) {
      if (mesh.points_mm[index] == Vec3{1.0, 1.0, 1.0}) index = shared;
    }
  }
  const SolidMesh solid{mesh, "touching blocks"};
  EXPECT_EQ(solid.triangle_count(), 24U);
  EXPECT_NEAR(solid.volume_mm3(), 16.0, 1.0e-12);
  for (const auto vertex : solid.half_edges().vertices()) {
    EXPECT_LE(solid.half_edges().valence(vertex), 6U);
  }
}

TEST(SolidMesh, TakesTrianglesInAnyOrder) {
  IndexedMesh ball = tests::sphere(10.0, 6);
  for (std::size_t i = 0; i < ball.triangles.size(); ++i) {
    std::swap(ball.triangles[i], ball.triangles[(i * 7919U) % ball.triangles.size()]);
  }
  EXPECT_EQ(SolidMesh(ball, "shuffled").triangle_count(), ball.triangles.size());
}

TEST(SolidMesh, CannotBeMadeFromAnOpenMesh) {
  IndexedMesh open = solid_block(Vec3{2.0, 2.0, 2.0});
  open.triangles.pop_back();
  EXPECT_THROW(SolidMesh(open, "open"), MeshError);
}

}  // namespace
}  // namespace hallux::simulator

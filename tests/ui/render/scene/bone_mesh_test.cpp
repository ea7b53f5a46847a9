#include "ui/render/scene/bone_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/mesh/bvh.h"
#include "tests/support/worlds.h"
#include "tests/ui/render/operating_world.h"

namespace hallux::tests {
namespace {

using simulator::CutSolid;
using simulator::FaceSource;
using ui::BoneMesh;
using ui::BoneVertex;

Vec3 normal_of(const BoneVertex& vertex) {
  return Vec3(vertex.normal[0], vertex.normal[1], vertex.normal[2]) / 32767.0;
}

TEST(BoneLook, DepthIsTheDistanceToTheSurface) {
  const ui::BoneLook look = ui::look_of(1, sphere(9.0, 24));
  for (const double radius_mm : {2.0, 5.0, 8.0, 9.0, 11.0}) {
    const Vec3 point_mm = radius_mm * glm::normalize(Vec3(1.0, 2.0, -0.5));
    // The sphere's triangles lie up to 0.03 mm inside; trilinear over 0.75 mm errs by curvature:
    // 0.75^2 / (8 r).
    EXPECT_NEAR(ui::depth_at(look.depth, point_mm), 9.0 - radius_mm, 0.03 + 0.07 / radius_mm);
  }
}

TEST(BoneLook, LightReachesABallAndNotTheFloorOfAGroove) {
  const ui::BoneLook ball = ui::look_of(1, sphere(9.0, 24));
  const double free = ui::openness_at(ball.depth, Vec3(9.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0));
  EXPECT_GT(free, 0.95);
  const Vec3 size_mm(14.0, 14.0, 14.0);
  const ui::BoneLook groove = ui::look_of(2, u_shape(size_mm, 5.0));  // 4 mm wide, 9 mm deep
  const double shut = ui::openness_at(groove.depth, Vec3(0.0, -2.0, 0.0), Vec3(0.0, 1.0, 0.0));
  EXPECT_LT(shut, 0.75 * free);
}

TEST(BoneMesh, KeepsEveryTriangleAndSortsTheSkinFirst) {
  const simulator::IndexedMesh tube = hollow_tube({.length_mm = 30.0, .rings = 4});
  const CutSolid solid = simulator::uncut_solid(tube);
  simulator::IndexedMesh outer;  // the tube without its canal
  outer = hollow_tube({.inner_radius_mm = 0.0, .length_mm = 30.0, .rings = 4});
  const BoneMesh mesh = ui::mesh_of(1, solid, ui::look_of(1, outer));
  ASSERT_EQ(mesh.triangles.size(), solid.mesh.triangles.size());
  EXPECT_EQ(mesh.skin_count, outer.triangles.size());
  std::vector<bool> is_taken(mesh.triangles.size());
  for (std::size_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    const std::uint32_t place = mesh.place_of[i];
    EXPECT_FALSE(is_taken[place]);
    is_taken[place] = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 seen(mesh.vertices[mesh.triangles[place][k]].point_in_bone_mm);
      EXPECT_LT(glm::length(seen - solid.mesh.points_mm[solid.mesh.triangles[i][k]]), 1e-5);
    }
    const bool is_canal = mesh.vertices[mesh.triangles[place][0]].kerf == ui::canal_kerf;
    EXPECT_EQ(is_canal, place >= mesh.skin_count);
  }
}

TEST(BoneMesh, SharesNormalsOnTheSkinAndNotAcrossARim) {
  CutSolid block = simulator::uncut_solid(solid_block(Vec3(10.0, 10.0, 10.0)));
  // The two triangles that look along +z are a wall.
  for (std::size_t i = 0; i < block.mesh.triangles.size(); ++i) {
    const auto& t = block.mesh.triangles[i];
    bool is_top = true;
    for (const std::uint32_t corner : t) is_top = is_top && block.mesh.points_mm[corner].z > 4.9;
    if (is_top) block.sources[i] = FaceSource{0, -1};
  }
  const BoneMesh mesh = ui::mesh_of(1, block, ui::look_of(1, block.mesh));
  EXPECT_EQ(mesh.vertices.size(), 8U + 4U);
  for (const BoneVertex& vertex : mesh.vertices) {
    const Vec3 normal = normal_of(vertex);
    EXPECT_NEAR(glm::length(normal), 1.0, 1e-4);
    if (vertex.kerf == 0) {
      EXPECT_GT(normal.z, 0.9999);
      EXPECT_EQ(vertex.side, -1);
    }
  }
}

class SawnMesh : public testing::Test {
 protected:
  static void SetUpTestSuite() { world = new OperatingWorld(0.9); }
  static void TearDownTestSuite() { delete world; }
  static OperatingWorld* world;
};
OperatingWorld* SawnMesh::world = nullptr;

TEST_F(SawnMesh, ThePatchContinuesTheSkinWithoutASeam) {
  world->saw_to(-4.0);
  const BoneMesh& mesh = world->mesh();
  const simulator::SolidPatch& patch = world->patch();
  ui::PatchMesh made;
  ui::make_patch_mesh(mesh, patch, made);
  ASSERT_EQ(made.triangles.size(), patch.triangles.size());
  ASSERT_GT(made.skin_count, 0U);
  ASSERT_LT(made.skin_count, made.triangles.size());
  std::size_t shared = 0;
  for (std::size_t i = 0; i < made.skin_count; ++i) {
    for (const std::uint32_t corner : made.triangles[i]) {
      const BoneVertex& vertex = made.vertices[corner];
      EXPECT_LT(vertex.kerf, 0);
      // A vertex that the mesh has, too, is lit alike there.
      for (const BoneVertex& other : mesh.vertices) {
        if (other.point_in_bone_mm != vertex.point_in_bone_mm || other.kerf != vertex.kerf)
          continue;
        ++shared;
        EXPECT_EQ(other.normal, vertex.normal);
        EXPECT_EQ(other.openness, vertex.openness);
      }
    }
  }
  EXPECT_GT(shared, 10U);
}

TEST_F(SawnMesh, WallsLookAcrossTheKerf) {
  world->saw_to(-4.0);
  ui::PatchMesh made;
  ui::make_patch_mesh(world->mesh(), world->patch(), made);
  const Vec3 plane_normal =
      inverse(world->phalanx().world_from_bone).rotation *
      (world->world_from_face("proximal_face").rotation * Vec3(0.0, 0.0, 1.0));
  std::size_t walls = 0;
  for (const BoneVertex& vertex : made.vertices) {
    if (vertex.kerf < 0 || vertex.side == 0) continue;
    ++walls;
    EXPECT_NEAR(glm::dot(normal_of(vertex), plane_normal), -vertex.side, 1e-3);
  }
  EXPECT_GT(walls, 20U);
}

TEST_F(SawnMesh, ASlotIsDarkAndAnOpenWedgeIsNot) {
  OperatingWorld opened(0.9);
  opened.take_wedge_out();
  double brightest = 0.0, darkest = 1.0;
  for (const BoneVertex& vertex : opened.mesh().vertices) {
    if (vertex.kerf < 0 || vertex.side == 0) continue;
    brightest = std::max(brightest, vertex.openness / 32767.0);
    darkest = std::min(darkest, vertex.openness / 32767.0);
  }
  EXPECT_GT(brightest, 0.5);  // at the wedge's base, 3 mm from wall to wall
  EXPECT_LT(darkest, 0.15);   // at its apex
}

}  // namespace
}  // namespace hallux::tests

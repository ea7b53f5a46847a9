#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "simulator/mesh/bvh.h"
#include "simulator/mesh/read_mesh.h"

/// Reads every mesh in the folder named by HALLUX_MESHES: each becomes a solid, or is refused in
/// one sentence.
namespace hallux::simulator {
namespace {

namespace fs = std::filesystem;

fs::path mesh_folder() {
  const char* const folder = std::getenv("HALLUX_MESHES");
  return folder == nullptr ? fs::path{} : fs::path{folder};
}

TEST(RealMeshes, AreSolidsOrAreRefused) {
  ASSERT_TRUE(fs::is_directory(mesh_folder())) << "set HALLUX_MESHES to a folder of meshes";
  int solids = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator{mesh_folder()}) {
    if (entry.path().extension() != ".stl") continue;
    try {
      const IndexedMesh mesh = read_mesh(entry.path());
      EXPECT_GT(signed_volume_mm3(mesh), 0.0);
      ++solids;
    } catch (const MeshError& error) {
      const std::string sentence = error.what();
      EXPECT_NE(sentence.find("(first near "), std::string::npos) << sentence;
    }
  }
  EXPECT_GT(solids, 0);
}

TEST(RealMeshes, TheFirstMetatarsalAndTheOpenCalcaneusAreWhatTheyAre) {
  const IndexedMesh bone = read_mesh(mesh_folder() / "bp3d_metatarsal1_r.stl");
  EXPECT_EQ(bone.triangles.size(), 4886U);
  // Genus 0: V - E + F = 2, with E = 3 F / 2.
  EXPECT_EQ(bone.points_mm.size(), 2U + bone.triangles.size() / 2);
  const Bvh bvh{bone};
  for (std::size_t i = 0; i < bone.triangles.size(); i += 97) {
    const Triangle& t = bone.triangles[i];
    const Vec3 middle = (bone.points_mm[t[0]] + bone.points_mm[t[1]] + bone.points_mm[t[2]]) / 3.0;
    EXPECT_LT(bvh.nearest(middle)->distance_mm, 1.0e-12);
  }
  try {
    read_mesh(mesh_folder() / "osim_calcaneus_r_open.stl");
    FAIL() << "must be refused";
  } catch (const MeshError& error) {
    EXPECT_EQ(std::string{error.what()}.find(
                  "osim_calcaneus_r_open.stl: 3 edges belong to one triangle only"),
              0U)
        << error.what();
  }
}

}  // namespace
}  // namespace hallux::simulator

#include "simulator/mesh/write_ply.h"

#include <gtest/gtest.h>

#include <fstream>

#include "simulator/mesh/read_mesh.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for one test, removed at its end.
class WritePly : public testing::Test {
 protected:
  WritePly() { fs::create_directories(folder_); }
  ~WritePly() override { fs::remove_all(folder_); }

  fs::path folder_ =
      fs::path{testing::TempDir()} /
      ("hallux_" + std::string{testing::UnitTest::GetInstance()->current_test_info()->name()});
};

TEST_F(WritePly, ReadsBackBitForBit) {
  const IndexedMesh tube = tests::hollow_tube({});
  write_ply(tube, folder_ / "tube.ply");
  EXPECT_EQ(read_mesh(folder_ / "tube.ply"), tube);
}

TEST_F(WritePly, ReplacesAnOldFileAndLeavesNothingBeside) {
  write_ply(tests::sphere(3.0, 4), folder_ / "bone.ply");
  const IndexedMesh block = tests::solid_block(Vec3{1.0, 2.0, 3.0});
  write_ply(block, folder_ / "bone.ply");
  EXPECT_EQ(read_mesh(folder_ / "bone.ply"), block);
  EXPECT_EQ(std::distance(fs::directory_iterator{folder_}, fs::directory_iterator{}), 1);
}

TEST_F(WritePly, SaysWhyItCannotWrite) {
  try {
    write_ply(tests::solid_block(Vec3{1.0}), folder_ / "nowhere" / "bone.ply");
    FAIL() << "must throw";
  } catch (const MeshError& error) {
    EXPECT_NE(std::string{error.what()}.find("bone.ply: cannot be written in"), std::string::npos)
        << error.what();
  }
}

TEST_F(WritePly, LeavesTheTargetAloneWhenItIsAFolder) {
  fs::create_directories(folder_ / "bone.ply" / "kept");
  EXPECT_THROW(write_ply(tests::solid_block(Vec3{1.0}), folder_ / "bone.ply"), MeshError);
  EXPECT_TRUE(fs::exists(folder_ / "bone.ply" / "kept"));
  EXPECT_FALSE(fs::exists(folder_ / "bone.ply.part"));
}

}  // namespace
}  // namespace hallux::simulator

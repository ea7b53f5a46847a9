/// The kernel's properties on every mesh of a folder: ./test --meshes DIR.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>

#include "simulator/mesh/read_mesh.h"
#include "simulator/mesh/write_ply.h"
#include "tests/simulator/cutting/frames/frame_count.h"
#include "tests/simulator/cutting/frames/frame_properties.h"
#include "tests/simulator/cutting/worlds/shown_solid.h"

namespace hallux::tests {
namespace {

using namespace simulator;

constexpr std::uint64_t worlds_of_mesh = 12;

std::vector<std::filesystem::path> mesh_files() {
  const char* folder = std::getenv("HALLUX_MESHES");
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(
           folder != nullptr ? folder : "HALLUX_MESHES-is-not-set")) {
    const std::filesystem::path extension = entry.path().extension();
    if (extension == ".stl" || extension == ".obj" || extension == ".ply") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The mesh as it stands in the file, closed or not.
IndexedMesh unchecked_mesh(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const MeshFormat format = file.extension() == ".stl"   ? MeshFormat::Stl
                            : file.extension() == ".obj" ? MeshFormat::Obj
                                                         : MeshFormat::Ply;
  return parse_mesh(std::as_bytes(std::span(text)), format, file.filename().string());
}

/// Why a file is refused; nothing where it is read.
std::optional<std::string> refusal_of(const std::filesystem::path& file) {
  try {
    read_mesh(file);
  } catch (const MeshError& error) {
    return error.what();
  }
  return std::nullopt;
}

TEST(RealBoneFrames, HoldOnEveryClosedMesh) {
  std::size_t played = 0;
  for (const std::filesystem::path& file : mesh_files()) {
    if (refusal_of(file)) continue;
    const IndexedMesh mesh = read_mesh(file);
    FrameCount count;
    for (std::uint64_t seed = 1; seed <= worlds_of_mesh; ++seed) count_mesh(mesh, seed, count);
    std::cout << file.filename().string() << ": " << sentence_of(count) << '\n';
    for (const std::string& fault : count.faults) ADD_FAILURE() << file << ": " << fault;
    EXPECT_GT(10 * count.partial, count.frames) << file;
    Random random(99);
    const auto visit = [&](const PlayedFrame& frame) {
      EXPECT_TRUE(has_walls_on_planes(frame)) << file;
      EXPECT_TRUE(has_empty_kerf(frame)) << file;
      EXPECT_TRUE(keeps_skin(frame)) << file;
      EXPECT_TRUE(interpolates_skin(frame)) << file;
    };
    play_mesh(mesh, random, visit, {});
    ++played;
  }
  EXPECT_GT(played, 0U);
}

TEST(RealBoneFrames, AnOpenMeshIsRefusedByNameAndNoOther) {
  for (const std::filesystem::path& file : mesh_files()) {
    const IndexedMesh mesh = unchecked_mesh(file);
    const bool is_solid = is_strictly_closed(mesh) && signed_volume_mm3(mesh) > 0.0;
    const std::optional<std::string> refusal = refusal_of(file);
    EXPECT_EQ(refusal.has_value(), !is_solid) << file;
    if (refusal) {
      EXPECT_NE(refusal->find(file.filename().string()), std::string::npos) << *refusal;
    }
  }
}

TEST(RealBoneFrames, AClosedMeshThatLosesATriangleIsRefusedByName) {
  const std::filesystem::path mutilated =
      std::filesystem::path(testing::TempDir()) / "one_triangle_missing.ply";
  for (const std::filesystem::path& file : mesh_files()) {
    if (refusal_of(file)) continue;
    IndexedMesh mesh = read_mesh(file);
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<long>(mesh.triangles.size() / 2));
    write_ply(mesh, mutilated);
    const std::optional<std::string> refusal = refusal_of(mutilated);
    ASSERT_TRUE(refusal) << file;
    EXPECT_NE(refusal->find("one_triangle_missing.ply"), std::string::npos) << *refusal;
    EXPECT_NE(refusal->find("3 edges"), std::string::npos) << *refusal;
  }
}

}  // namespace
}  // namespace hallux::tests

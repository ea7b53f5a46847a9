#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "simulator/mesh/bvh.h"
#include "simulator/mesh/read_mesh.h"
#include "simulator/mesh/write_ply.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

/// A binary STL that is as long as it says, filled with zeros behind its header.
std::string zero_stl(std::uint32_t count) {
  std::string bytes(84 + 50 * std::size_t{count}, '\0');
  for (std::size_t i = 0; i < 4; ++i) bytes[80 + i] = static_cast<char>((count >> (8 * i)) & 0xFFU);
  return bytes;
}

TEST(LargeMesh, TenMillionTrianglesAreRefusedInOneSentence) {
  const std::string bytes = zero_stl(10'000'000);
  try {
    parse_mesh(std::as_bytes(std::span{bytes}), MeshFormat::Stl, "huge.stl");
    FAIL() << "must be refused";
  } catch (const MeshError& error) {
    EXPECT_STREQ(
        error.what(),
        "huge.stl: has 10000000 triangles or more; at most 5000000 can be used; reduce the "
        "mesh and export it again");
  }
}

TEST(LargeMesh, HalfAMillionTrianglesBecomeASolidAndATree) {
  const IndexedMesh ball = tests::dense_sphere(20.0, 500'000);
  const std::string bytes = ply_bytes(ball);
  const IndexedMesh read = parse_mesh(std::as_bytes(std::span{bytes}), MeshFormat::Ply, "ball.ply");
  EXPECT_EQ(read, ball);
  EXPECT_NO_THROW(check_closed_solid(read, "ball.ply"));
  EXPECT_NEAR(Bvh{read}.signed_distance_mm(Vec3{0.0, 0.0, 0.0}), -20.0, 0.01);
}

}  // namespace
}  // namespace hallux::simulator

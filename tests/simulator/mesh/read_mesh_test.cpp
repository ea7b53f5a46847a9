#include "simulator/mesh/read_mesh.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <bit>
#include <fstream>
#include <limits>
#include <string>

#include "simulator/mesh/write_ply.h"
#include "tests/support/worlds.h"

/// What the readers take, and above all what they refuse: each refusal must say file, place and
/// mend.
namespace hallux::simulator {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view tetrahedron_obj =
    "# four corners\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

constexpr std::string_view tetrahedron_ply_header =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
constexpr std::string_view tetrahedron_ply_numbers =
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

IndexedMesh parse(std::string_view text, MeshFormat format, const MeshLimits& limits = {}) {
  return parse_mesh(std::as_bytes(std::span{text.data(), text.size()}), format, "bone", limits);
}

std::string refusal(std::string_view text, MeshFormat format, const MeshLimits& limits = {}) {
  try {
    check_closed_solid(parse(text, format, limits), "bone");
  } catch (const MeshError& error) {
    return error.what();
  }
  return "not refused";
}

std::string refusal(const IndexedMesh& mesh) {
  try {
    check_closed_solid(mesh, "bone");
  } catch (const MeshError& error) {
    return error.what();
  }
  return "not refused";
}

std::string refusal(const fs::path& file, const MeshLimits& limits = {}) {
  try {
    read_mesh(file, limits);
  } catch (const MeshError& error) {
    return error.what();
  }
  return "not refused";
}

template <typename Value>
void append_bits(std::string& bytes, Value value) {
  const auto bits = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  bytes.append(bits.data(), bits.size());
}

std::string stl_bytes(const IndexedMesh& mesh, std::string header = "made by a test") {
  header.resize(80, '\0');
  append_bits(header, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append_bits(header, 0.0F);
    for (const std::uint32_t index : triangle) {
      for (glm::length_t axis = 0; axis < 3; ++axis) {
        append_bits(header, static_cast<float>(mesh.points_mm[index][axis]));
      }
    }
    header.append(2, '\0');
  }
  return header;
}

std::string stl_text(const IndexedMesh& mesh) {
  std::string text = "solid bone\r\n";
  for (const Triangle& triangle : mesh.triangles) {
    text += " facet normal nan 0 0\r\n  outer loop\r\n";
    for (const std::uint32_t index : triangle) {
      const Vec3& point = mesh.points_mm[index];
      text += "   vertex " + std::to_string(point.x) + " " + std::to_string(point.y) + " +" +
              std::to_string(point.z + 100.0) + "\r\n";
    }
    text += "  endloop\r\n endfacet\r\n";
  }
  return text + "endsolid bone\r\n";
}

std::string ply_text(std::string_view format) {
  return "ply\nformat " + std::string{format} + " 1.0\n" + std::string{tetrahedron_ply_header};
}

const IndexedMesh block = tests::solid_block(Vec3{2.0, 4.0, 6.0});

TEST(ReadStl, BinaryAndTextGiveTheSameBlock) {
  for (const std::string& bytes : {stl_bytes(block), stl_text(block)}) {
    const IndexedMesh mesh = parse(bytes, MeshFormat::Stl);
    check_closed_solid(mesh, "block");
    EXPECT_EQ(mesh.points_mm.size(), 8U);
    EXPECT_EQ(mesh.triangles.size(), 12U);
    EXPECT_NEAR(signed_volume_mm3(mesh), 48.0, 1.0e-9);
  }
}

TEST(ReadStl, ABinaryHeaderMayBeginWithSolid) {
  EXPECT_EQ(parse(stl_bytes(block, "solid bone"), MeshFormat::Stl).triangles.size(), 12U);
}

TEST(ReadStl, ZeroAndMinusZeroAreOnePoint) {
  IndexedMesh mesh = tests::moved(block, {{}, Vec3{1.0, 2.0, 3.0}});
  std::string bytes = stl_bytes(mesh);
  mesh.points_mm[0] = Vec3{-0.0, -0.0, -0.0};
  const std::string signed_bytes = stl_bytes(mesh);
  // Every second facet from one, the others from the other.
  for (std::size_t i = 84; i + 50 <= bytes.size(); i += 100) {
    bytes.replace(i, 50, signed_bytes, i, 50);
  }
  EXPECT_EQ(parse(bytes, MeshFormat::Stl).points_mm.size(), 8U);
}

TEST(ReadStl, LeavesOutTrianglesThatLoseACorner) {
  IndexedMesh mesh = block;
  mesh.triangles.push_back({0, 1, 1});
  const IndexedMesh read = parse(stl_bytes(mesh), MeshFormat::Stl);
  EXPECT_EQ(read.triangles.size(), 12U);
  check_closed_solid(read, "block");
}

TEST(ReadStl, RefusesACountBeyondTheFileBeforeTakingMemory) {
  std::string bytes = stl_bytes(block);
  bytes.replace(80, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_EQ(
      refusal(bytes, MeshFormat::Stl),
      "bone: says 4294967295 triangles (byte 80), which take 214748364834 bytes, but has 684; "
      "it is cut short or damaged, export it again");
}

TEST(ReadStl, RefusesEveryShorterFile) {
  const std::string bytes = stl_bytes(block, "solid");
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    EXPECT_NE(refusal(std::string_view{bytes}.substr(0, size), MeshFormat::Stl), "not refused")
        << size;
  }
  const std::string text = stl_text(block);
  for (std::size_t size = 0; size + 20 < text.size(); size += 11) {
    EXPECT_NE(refusal(std::string_view{text}.substr(0, size), MeshFormat::Stl), "not refused")
        << size;
  }
}

TEST(ReadStl, RefusesTextThatIsNotStl) {
  EXPECT_EQ(
      refusal("These are my notes about the patient of Tuesday morning.\n", MeshFormat::Stl),
      "bone: is text but not STL (line 1 does not begin with 'solid'); export the mesh as STL");
  EXPECT_EQ(refusal("solid ground is what we need\nunder our feet\n", MeshFormat::Stl),
            "bone: line 2: 'under' stands where a facet should; export the file again");
}

TEST(ReadStl, RefusesNanWithItsPlace) {
  IndexedMesh mesh = block;
  mesh.points_mm[mesh.triangles[3][1]].y = std::numeric_limits<double>::quiet_NaN();
  const std::string text = refusal(stl_bytes(mesh), MeshFormat::Stl);
  EXPECT_NE(text.find("has a coordinate that is not a finite number; repair"), std::string::npos)
      << text;
  EXPECT_EQ(refusal("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n", MeshFormat::Stl),
            "bone: line 4: 'inf' is not a finite number; repair the mesh and export it again");
}

TEST(ReadStl, RefusesZeroTriangles) {
  EXPECT_NE(refusal(stl_bytes({}), MeshFormat::Stl).find("has no triangles"), std::string::npos);
  EXPECT_NE(refusal("solid\nendsolid\n", MeshFormat::Stl).find("has no triangles"),
            std::string::npos);
}

TEST(ReadStl, RefusesMoreTrianglesThanTheLimit) {
  for (const std::string& bytes : {stl_bytes(block), stl_text(block)}) {
    const std::string text = refusal(bytes, MeshFormat::Stl, {.triangles = 10});
    EXPECT_NE(text.find("triangles or more; at most 10 can be used; reduce the mesh"),
              std::string::npos)
        << text;
  }
}

TEST(ReadObj, ReadsATetrahedron) {
  const IndexedMesh mesh = parse(tetrahedron_obj, MeshFormat::Obj);
  check_closed_solid(mesh, "tetrahedron");
  EXPECT_NEAR(signed_volume_mm3(mesh), 1.0 / 6.0, 1.0e-15);
}

TEST(ReadObj, ReadsNegativeIndicesTexturesPolygonsAndJoinedLines) {
  constexpr std::string_view text =
      "mtllib a.mtl\no bone\nv -1 -1 -1 0.5 0.5 0.5\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
      "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nvn 0 0 1\nvt 0 0\n\n"
      "f -5/1/1 -6/1/1 -7/1/1 -8/1/1 # floor\nf 5//1 6//1 7//1 \\\n8//1\n"
      "f 1/1 2/1 6/1 5/1\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nl 1 2\n";
  const IndexedMesh mesh = parse(text, MeshFormat::Obj);
  check_closed_solid(mesh, "cube");
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_NEAR(signed_volume_mm3(mesh), 8.0, 1.0e-12);
}

TEST(ReadObj, LeavesOutPointsThatNoTriangleUses) {
  const IndexedMesh mesh = parse("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n", MeshFormat::Obj);
  EXPECT_EQ(mesh.points_mm.size(), 3U);
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 2}));
}

TEST(ReadObj, RefusesIndicesThatNameNoPoint) {
  EXPECT_EQ(refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", MeshFormat::Obj),
            "bone: line 4: a face names point 0, but there are 3 so far, counted from 1; export "
            "the file again");
  EXPECT_EQ(refusal("v 0 0 0\nf -1 -2 -3\n", MeshFormat::Obj),
            "bone: line 2: a face names point -2, but there are 1 so far, counted from 1; export "
            "the file again");
  EXPECT_EQ(refusal("v 0 0 0\nf 1 2 3\n", MeshFormat::Obj),
            "bone: triangle 1 names point 2, but there are 1; the file is cut short or damaged, "
            "export it again");
  for (const std::string_view index :
       {"4294967297", "99999999999999999999", "-9223372036854775808", "1e3", "1.5", "/1"}) {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 " + std::string{index} + "\n";
    EXPECT_NE(refusal(text, MeshFormat::Obj).find("line 4: "), std::string::npos) << index;
  }
}

TEST(ReadObj, RefusesBrokenLinesWithTheirNumber) {
  EXPECT_EQ(refusal("v 0 0\n", MeshFormat::Obj),
            "bone: line 1: a number is missing; the file is cut short or damaged, export it again");
  EXPECT_EQ(refusal("\nv 0 0 nan\n", MeshFormat::Obj),
            "bone: line 2: 'nan' is not a finite number; repair the mesh and export it again");
  EXPECT_EQ(refusal("v 0 0 1e999\n", MeshFormat::Obj),
            "bone: line 1: '1e999' is not a number; export the file again");
  EXPECT_EQ(refusal("v 0 0 0\nf 1 1\n", MeshFormat::Obj),
            "bone: line 2: a face has fewer than 3 corners; export the file again");
  EXPECT_NE(refusal("hello\nworld\n", MeshFormat::Obj).find("has no triangles"), std::string::npos);
}

TEST(ReadObj, RefusesAFaceThatNamesACornerTwice) {
  EXPECT_EQ(refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 2\n", MeshFormat::Obj),
            "bone: triangle 1 has the same corner twice (near 0.0 0.0 0.0 mm); "
            "remove degenerate faces in a mesh editor");
}

TEST(ReadObj, RefusesMoreThanTheLimits) {
  EXPECT_NE(
      refusal(tetrahedron_obj, MeshFormat::Obj, {.triangles = 3}).find("at most 3 can be used"),
      std::string::npos);
  EXPECT_NE(
      refusal(tetrahedron_obj, MeshFormat::Obj, {.points = 3}).find("4 points or more; at most 3"),
      std::string::npos);
}

TEST(ReadPly, ReadsTextAndBothByteOrders) {
  const std::string text = ply_text("ascii") + std::string{tetrahedron_ply_numbers};
  const IndexedMesh expected = parse(text, MeshFormat::Ply);
  check_closed_solid(expected, "tetrahedron");

  std::string little = ply_text("binary_little_endian");
  std::string big = ply_text("binary_big_endian");
  const auto append_both = [&](auto value) {
    std::string bytes;
    append_bits(bytes, value);
    little += bytes;
    big.append(bytes.rbegin(), bytes.rend());
  };
  for (const Vec3& point : expected.points_mm) {
    for (glm::length_t axis = 0; axis < 3; ++axis) append_both(static_cast<float>(point[axis]));
  }
  for (const Triangle& triangle : expected.triangles) {
    append_both(std::uint8_t{3});
    for (const std::uint32_t index : triangle) append_both(static_cast<std::int32_t>(index));
  }
  EXPECT_EQ(parse(little, MeshFormat::Ply), expected);
  EXPECT_EQ(parse(big, MeshFormat::Ply), expected);
}

TEST(ReadPly, WalksOverWhatItDoesNotNeed) {
  const std::string text =
      "ply\r\nformat ascii 1.0\r\ncomment by hand\r\nobj_info none\r\n"
      "element material 1\r\nproperty list uchar uchar letters\r\nproperty uchar red\r\n"
      "element vertex 4\r\nproperty uchar red\r\nproperty double z\r\nproperty double x\r\n"
      "property list int short extra\r\nproperty double y\r\n"
      "element face 2\r\nproperty list uchar float uv\r\nproperty list uchar uint vertex_index\r\n"
      "end_header\r\n2 7 8 255\r\n1 0 0 0 0\r\n1 0 1 1 5 0\r\n1 0 0 0 1\r\n1 1 0 2 5 5 0\r\n"
      "1 0.5 3 0 2 1\r\n0 4 0 1 3 2\r\n";
  const IndexedMesh mesh = parse(text, MeshFormat::Ply);
  EXPECT_EQ(mesh.triangles.size(), 3U);
  EXPECT_EQ(mesh.points_mm[1], (Vec3{1.0, 0.0, 0.0}));
  EXPECT_EQ(mesh.points_mm[3], (Vec3{0.0, 0.0, 1.0}));
}

TEST(ReadPly, RefusesCountsBeyondTheFileBeforeTakingMemory) {
  for (const std::string_view count : {"4000000000", "18446744073709551615", "-1", "99999"}) {
    for (const std::string_view element : {"vertex", "face", "other"}) {
      std::string text = "ply\nformat binary_little_endian 1.0\nelement " + std::string{element} +
                         " " + std::string{count} + "\nproperty float x\nend_header\n1234";
      EXPECT_NE(refusal(text, MeshFormat::Ply), "not refused");
    }
  }
  EXPECT_EQ(
      refusal("ply\nformat ascii 1.0\nelement vertex 50\nproperty float x\nend_header\n1 2 3\n",
              MeshFormat::Ply),
      "bone: declares 50 of element 'vertex', but only 6 bytes follow; it is cut short or "
      "damaged, export it again");
}

TEST(ReadPly, RefusesElementsThatTakeNoBytes) {
  EXPECT_NE(refusal("ply\nformat ascii 1.0\nelement other 9000000000000000000\nend_header\n",
                    MeshFormat::Ply)
                .find("without properties"),
            std::string::npos);
}

TEST(ReadPly, RefusesListsThatLie) {
  const std::string header = ply_text("binary_little_endian");
  std::string bytes = header + std::string(48, '\0');
  bytes += '\xC8';  // 200 corners, and 12 bytes left
  bytes += std::string(51, '\0');
  EXPECT_NE(refusal(bytes, MeshFormat::Ply).find("ends in the middle of its numbers"),
            std::string::npos);
  const std::string skipped =
      "ply\nformat binary_little_endian 1.0\nelement other 1\nproperty list uint double x\n"
      "end_header\n\xFF\xFF\xFF\xFF";
  EXPECT_NE(refusal(skipped, MeshFormat::Ply).find("ends in the middle"), std::string::npos);
  const std::string negative =
      "ply\nformat ascii 1.0\nelement other 1\nproperty list char int x\nend_header\n-5 1 2\n";
  EXPECT_NE(refusal(negative, MeshFormat::Ply).find("negative length"), std::string::npos);
}

TEST(ReadPly, RefusesIndicesOutOfRange) {
  const std::string start =
      ply_text("ascii") + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 ";
  for (const std::string_view index : {"4", "-1", "4294967296", "2.5", "nan"}) {
    EXPECT_NE(refusal(start + std::string{index} + "\n3 0 3 2\n", MeshFormat::Ply), "not refused");
  }
  EXPECT_EQ(refusal(start + "4\n3 0 3 2\n", MeshFormat::Ply),
            "bone: face 3 names point 4, but there are 4 counted from 0; the file is damaged, "
            "export it again");
}

TEST(ReadPly, RefusesBrokenHeaders) {
  for (const std::string_view text :
       {"",
        "p",
        "ply",
        "ply\n",
        "plywood\n",
        "ply\nformat ascii 1.0\n",
        "ply\nend_header\n",
        "ply\nformat ascii 2.0\nend_header\n",
        "ply\nformat morse 1.0\nend_header\n",
        "ply\nformat ascii 1.0\nproperty float x\nend_header\n",
        "ply\nformat ascii 1.0\nelement vertex\nend_header\n",
        "ply\nformat ascii 1.0\nelement vertex x\nend_header\n",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty colour x\nend_header\n1\n",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float\nend_header\n1\n",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\nend_header\n1\n",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
        "ply\nformat ascii 1.0\nelement face 1\nproperty float x\nend_header\n1\n",
        "ply\nformat ascii 1.0\nelement vertex 0\nelement vertex 0\nend_header\n",
        "ply\nformat ascii 1.0\nwhatever\nend_header\n",
        "ply\nformat ascii 1.0\nend_header\n"}) {
    EXPECT_NE(refusal(text, MeshFormat::Ply), "not refused") << text;
  }
}

TEST(ReadPly, RefusesEveryShorterFile) {
  for (const std::string& bytes :
       {ply_bytes(block), ply_text("ascii") + std::string{tetrahedron_ply_numbers}}) {
    for (std::size_t size = 0; size + 2 < bytes.size(); ++size) {
      ASSERT_NE(refusal(std::string_view{bytes}.substr(0, size), MeshFormat::Ply), "not refused")
          << size;
    }
  }
}

TEST(ReadPly, RefusesNanWithItsPlace) {
  IndexedMesh mesh = block;
  mesh.points_mm[4].z = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(ply_bytes(mesh), MeshFormat::Ply),
            "bone: point 5 has a coordinate that is not a finite number; repair the mesh and "
            "export it again");
}

TEST(CheckClosedSolid, CountsOpenEdgesAndPlacesTheFirst) {
  IndexedMesh mesh = block;
  mesh.triangles.pop_back();
  const std::string text = refusal(mesh);
  EXPECT_EQ(text.find("bone: 3 edges belong to one triangle only (first near "), 0U) << text;
  EXPECT_NE(text.find(" mm); the bone must be closed"), std::string::npos) << text;
}

TEST(CheckClosedSolid, RefusesCrowdedEdges) {
  IndexedMesh mesh = block;
  mesh.triangles.push_back(mesh.triangles[0]);
  EXPECT_EQ(refusal(mesh).find("bone: 3 edges belong to three triangles or more (first near "), 0U);
}

TEST(CheckClosedSolid, RefusesTrianglesTurnedOver) {
  IndexedMesh mesh = block;
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  EXPECT_EQ(refusal(mesh).find("bone: 3 edges are walked in the same direction by both triangles"),
            0U)
      << refusal(mesh);
}

TEST(CheckClosedSolid, RefusesASolidInsideOut) {
  EXPECT_NE(refusal(tests::inside_out(block)).find("is inside out"), std::string::npos);
}

TEST(CheckClosedSolid, RefusesASheetWithoutVolume) {
  const IndexedMesh sheet{{Vec3{0.0}, Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}},
                          {{0, 1, 2}, {0, 2, 1}}};
  EXPECT_NE(refusal(sheet).find("encloses no volume"), std::string::npos) << refusal(sheet);
}

TEST(CheckClosedSolid, RefusesCoordinatesThatAreNoBone) {
  IndexedMesh mesh = block;
  mesh.points_mm[2].x = 1.0e7;
  EXPECT_NE(refusal(mesh).find("point 3 is more than a kilometre away"), std::string::npos);
  mesh.points_mm[2].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(mesh).find("point 3 has a coordinate that is not a finite"), std::string::npos);
}

TEST(CheckClosedSolid, RefusesIndicesBeyondThePoints) {
  IndexedMesh mesh = block;
  mesh.triangles[1][1] = 8;
  EXPECT_NE(refusal(mesh).find("triangle 2 names point 8"), std::string::npos);
  EXPECT_NE(refusal(IndexedMesh{}).find("has no triangles"), std::string::npos);
}

TEST(CheckClosedSolid, AcceptsAVoid) { EXPECT_EQ(refusal(tests::hollow_tube({})), "not refused"); }

/// Files, in a folder of their own for one test.
class ReadMesh : public testing::Test {
 protected:
  ReadMesh() { fs::create_directories(folder_); }
  ~ReadMesh() override { fs::remove_all(folder_); }
  fs::path written(const std::string& name, std::string_view bytes) const {
    std::ofstream{folder_ / name, std::ios::binary} << bytes;
    return folder_ / name;
  }

  fs::path folder_ =
      fs::path{testing::TempDir()} /
      ("hallux_" + std::string{testing::UnitTest::GetInstance()->current_test_info()->name()});
};

TEST_F(ReadMesh, GoesByTheEndingInEitherCase) {
  EXPECT_EQ(read_mesh(written("block.STL", stl_bytes(block))).triangles.size(), 12U);
  EXPECT_EQ(read_mesh(written("t.obj", tetrahedron_obj)).triangles.size(), 4U);
  EXPECT_EQ(read_mesh(written("block.ply", ply_bytes(block))), block);
}

TEST_F(ReadMesh, RefusesWhatIsNoMeshFile) {
  EXPECT_EQ(refusal(folder_ / "no.stl"), "no.stl: there is no such file; check the path");
  EXPECT_EQ(refusal(folder_),
            folder_.filename().string() + ": is a folder; name a .stl, .obj or .ply file in it");
  EXPECT_EQ(refusal(written("none.stl", "")), "none.stl: is empty; export the mesh again");
  EXPECT_EQ(refusal(written("bone.x", "xof")),
            "bone.x: is of an unknown kind; meshes are read from .stl, .obj and .ply");
  EXPECT_EQ(refusal(written("notes.stl", "dear diary")),
            "notes.stl: is text but not STL (line 1 does not begin with 'solid'); export the mesh "
            "as STL");
}

TEST_F(ReadMesh, RefusesAPipeInsteadOfWaitingForIt) {
  ASSERT_EQ(mkfifo((folder_ / "pipe.stl").c_str(), 0600), 0);
  EXPECT_EQ(refusal(folder_ / "pipe.stl"),
            "pipe.stl: is not an ordinary file; copy the mesh into one");
}

TEST_F(ReadMesh, RefusesMoreBytesThanTheLimit) {
  EXPECT_EQ(refusal(written("t.obj", tetrahedron_obj), {.bytes = 50}),
            "t.obj: has 79 bytes; at most 50 are read; reduce the mesh and export it again");
}

TEST_F(ReadMesh, RefusesAnOpenMesh) {
  IndexedMesh mesh = block;
  mesh.triangles.erase(mesh.triangles.begin());
  EXPECT_EQ(refusal(written("open.stl", stl_bytes(mesh)))
                .find("open.stl: 3 edges belong to one triangle only"),
            0U);
}

}  // namespace
}  // namespace hallux::simulator

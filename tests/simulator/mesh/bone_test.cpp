#include "simulator/mesh/bones.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/mesh/mesh_error.h"
#include "simulator/mesh/read_mesh.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

Bone small_bone() {
  Bone bone;
  bone.name = "first_metatarsal";
  bone.generator = "test 1";
  bone.credit = "nobody";
  bone.outer = tests::solid_block(Vec3{60.0, 20.0, 20.0});
  bone.canal = tests::inside_out(tests::solid_block(Vec3{40.0, 8.0, 8.0}));
  bone.cortex = CortexLaw{2.0, 0.6, 60.0};
  bone.landmarks = {{"head_centre", Vec3{60.0, 0.0, 0.0}}, {"sulcus", Vec3{52.0, 1.0, -8.0}}};
  bone.world_from_bone = {normalised(Quat{1.0, 0.1, 0.0, 0.0}), Vec3{1.0, 2.0, 3.0}};
  return bone;
}

TEST(Bone, ComesBackFromItsBytes) {
  const Bone bone = small_bone();
  EXPECT_EQ(decode_bone(encode_bone(bone)), bone);
  Bone plain;
  plain.outer = tests::solid_block(Vec3{1.0});
  EXPECT_EQ(decode_bone(encode_bone(plain)), plain);
}

TEST(Bone, HasTheSameBytesEveryTime) {
  EXPECT_EQ(encode_bone(small_bone()), encode_bone(small_bone()));
}

TEST(Bone, IsRefusedWhereverItsBytesEnd) {
  const std::vector<std::byte> bytes = encode_bone(small_bone());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_THROW(decode_bone(std::span{bytes}.first(size)), MeshError) << size;
  }
  std::vector<std::byte> longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_THROW(decode_bone(longer), MeshError);
}

TEST(Bone, AnyByteChangedGivesAnotherBoneOrNone) {
  const Bone bone = small_bone();
  const std::vector<std::byte> bytes = encode_bone(bone);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::vector<std::byte> changed = bytes;
    changed[i] ^= std::byte{0x80};
    try {
      // Encoded again, because a zero that became a minus zero compares equal.
      ASSERT_EQ(encode_bone(decode_bone(changed)), changed) << i;
    } catch (const MeshError&) {
      continue;
    }
  }
}

TEST(Patient, OfOneBoneHasTheBytesOfThatBone) {
  EXPECT_EQ(encode_patient(small_bone()), encode_bone(small_bone()));
  EXPECT_EQ(decode_patient(encode_bone(small_bone())), std::vector{small_bone()});
}

TEST(Patient, OfSeveralBonesComesBackFromItsBytesInTheirOrder) {
  Bone other = small_bone();
  other.name = "first_proximal_phalanx";
  other.world_from_bone.translation_mm.x = 70.0;
  const std::vector<Bone> bones{small_bone(), other};
  EXPECT_EQ(decode_patient(encode_patient(bones)), bones);
  const std::vector<Bone> turned{other, small_bone()};
  EXPECT_NE(encode_patient(turned), encode_patient(bones));
}

TEST(Patient, OfSeveralBonesIsRefusedWhereverItsBytesEndOrAreAltered) {
  const std::vector<Bone> bones{small_bone(), small_bone()};
  const std::vector<std::byte> bytes = encode_patient(bones);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_THROW(decode_patient(std::span{bytes}.first(size)), MeshError) << size;
  }
  std::vector<std::byte> longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_THROW(decode_patient(longer), MeshError);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::vector<std::byte> changed = bytes;
    changed[i] ^= std::byte{0x80};
    try {
      ASSERT_EQ(encode_patient(decode_patient(changed)), changed) << i;
    } catch (const MeshError&) {
      continue;
    }
  }
}

TEST(Bone, RefusesNumbersThatAreNone) {
  Bone bone = small_bone();
  bone.outer.points_mm[2].y = NAN;
  EXPECT_THROW(decode_bone(encode_bone(bone)), MeshError);
  bone = small_bone();
  bone.canal.triangles[1][2] = 8;
  EXPECT_THROW(decode_bone(encode_bone(bone)), MeshError);
}

TEST(Bone, SolidIsTheOuterSurfaceLessTheCanal) {
  const IndexedMesh solid = solid_of(small_bone());
  check_closed_solid(solid, "bone");
  EXPECT_NEAR(signed_volume_mm3(solid), 60.0 * 400.0 - 40.0 * 64.0, 1.0e-9);
}

TEST(Bone, KnowsItsLandmarksByName) {
  EXPECT_EQ(find_landmark(small_bone(), "sulcus"), (Vec3{52.0, 1.0, -8.0}));
  EXPECT_FALSE(find_landmark(small_bone(), "Sulcus"));
}

TEST(Bone, CortexIsThickestAtTheMiddleAndNeverBelowItsFloor) {
  const CortexLaw law;
  EXPECT_DOUBLE_EQ(cortex_thickness_mm(law, 0.5 * law.length_mm), law.mid_mm);
  const double quarter = 2.2 * (0.35 + 0.65 * std::exp(-std::pow(0.25 / 0.22, 2.0)));
  EXPECT_NEAR(cortex_thickness_mm(law, 0.25 * law.length_mm), quarter, 1.0e-14);
  EXPECT_DOUBLE_EQ(cortex_thickness_mm({.floor_mm = 1.0}, -100.0), 1.0);
  EXPECT_DOUBLE_EQ(cortex_thickness_mm({.floor_mm = 1.0}, 1.0e6), 1.0);
}

}  // namespace
}  // namespace hallux::simulator

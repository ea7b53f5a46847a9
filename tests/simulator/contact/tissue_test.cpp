#include "simulator/contact/tissue.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/foot/first_metatarsal.h"
#include "simulator/base/random.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

/// A tube of outer radius 8 and canal radius 5, with 1 mm of cortex all along.
Bone tube_with_cortex() {
  Bone bone = tests::cortical_bone(tests::hollow_tube({.inner_radius_mm = 0.0}));
  bone.canal =
      tests::hollow_tube({.outer_radius_mm = 5.0, .inner_radius_mm = 0.0, .length_mm = 52.0});
  bone.canal = tests::inside_out(bone.canal);
  bone.cortex = CortexLaw{.mid_mm = 1.0, .floor_mm = 1.0};
  return bone;
}

/// Walks about at random and compares each answer with that of a tissue map asked for the first
/// time; returns how often each tissue was met.
std::array<int, 4> walk_and_compare(const TissueMap& map, const Vec3& start_mm, const Vec3& room_mm,
                                    std::uint64_t seed, int steps) {
  Random random{seed};
  TissueMemory memory;
  Vec3 point_mm = start_mm;
  std::array<int, 4> met{};
  int differences = 0;
  for (int i = 0; i < steps; ++i) {
    // Mostly creeping, as teeth do; now and then a jump.
    const double stride_mm = random.uniform() < 0.05 ? 5.0 : random.uniform(0.0, 0.2);
    for (int axis = 0; axis < 3; ++axis) {
      point_mm[axis] += random.uniform(-stride_mm, stride_mm);
      point_mm[axis] = std::clamp(point_mm[axis], start_mm[axis] - room_mm[axis],
                                  start_mm[axis] + room_mm[axis]);
    }
    const Tissue remembered = map.at(point_mm, memory);
    if (remembered != map.at(point_mm)) ++differences;
    ++met[static_cast<std::size_t>(remembered)];
  }
  EXPECT_EQ(differences, 0) << "seed " << seed;
  return met;
}

TEST(Tissue, LiesInLayersFromTheSurfaceToTheCanal) {
  const TissueMap map{tube_with_cortex()};
  EXPECT_EQ(map.at({0.0, 8.1, 0.0}), Tissue::None);
  EXPECT_EQ(map.at({0.0, 7.9, 0.0}), Tissue::Cortical);
  EXPECT_EQ(map.at({0.0, 7.1, 0.0}), Tissue::Cortical);
  EXPECT_EQ(map.at({0.0, 6.9, 0.0}), Tissue::Cancellous);
  EXPECT_EQ(map.at({0.0, 5.1, 0.0}), Tissue::Cancellous);
  EXPECT_EQ(map.at({0.0, 4.9, 0.0}), Tissue::Marrow);
  EXPECT_EQ(map.at({27.0, 0.0, 0.0}), Tissue::Cancellous);
  EXPECT_EQ(map.at({29.5, 0.0, 0.0}), Tissue::Cortical);
}

TEST(Tissue, OnlyCancellousAndCorticalBoneResistTheTeeth) {
  EXPECT_FALSE(is_bone(Tissue::None));
  EXPECT_FALSE(is_bone(Tissue::Marrow));
  EXPECT_TRUE(is_bone(Tissue::Cancellous));
  EXPECT_TRUE(is_bone(Tissue::Cortical));
}

TEST(Tissue, WithoutALawAllBoneIsCortical) {
  const TissueMap map{tests::cortical_bone(tests::solid_block({40.0, 40.0, 40.0}))};
  EXPECT_EQ(map.at({0.0, 0.0, 0.0}), Tissue::Cortical);
}

TEST(Tissue, TheCortexFollowsTheLawAlongTheBone) {
  Bone bone = tests::cortical_bone(tests::solid_block({200.0, 20.0, 20.0}));
  bone.cortex = CortexLaw{.mid_mm = 2.2, .floor_mm = 0.7, .length_mm = 60.0};
  const TissueMap map{bone};
  // In the middle (x = 30) the cortex is 2.2 mm thick, at the base facet (x = 0) 0.35 of that.
  EXPECT_EQ(map.at({30.0, 10.0 - 2.1, 0.0}), Tissue::Cortical);
  EXPECT_EQ(map.at({30.0, 10.0 - 2.3, 0.0}), Tissue::Cancellous);
  EXPECT_EQ(map.at({0.0, 10.0 - 0.7, 0.0}), Tissue::Cortical);
  EXPECT_EQ(map.at({0.0, 10.0 - 0.9, 0.0}), Tissue::Cancellous);
}

TEST(Tissue, MemoryAnswersLikeAFreshSearchAlongWalksThroughATube) {
  const TissueMap map{tube_with_cortex()};
  std::array<int, 4> met{};
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto walk = walk_and_compare(map, {22.0, 5.0, 0.0}, {9.0, 5.0, 7.0}, seed, 1000);
    for (std::size_t i = 0; i < met.size(); ++i) met[i] += walk[i];
  }
  for (const int count : met) EXPECT_GT(count, 100);
}

TEST(Tissue, MemoryAnswersLikeAFreshSearchInAGeneratedMetatarsal) {
  const Bone bone =
      scenarios::make_first_metatarsal(scenarios::first_metatarsal_table(), {.edge_mm = 1.5});
  const TissueMap map{bone};
  std::array<int, 4> met{};
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto walk = walk_and_compare(map, {32.0, 0.0, 0.0}, {12.0, 9.0, 9.0}, seed, 1000);
    for (std::size_t i = 0; i < met.size(); ++i) met[i] += walk[i];
  }
  for (const int count : met) EXPECT_GT(count, 50);
}

TEST(Tissue, StandsNoMoreInAnOpenKerfNorInAPieceTakenOut) {
  const Bone bone = tests::cortical_bone(tests::solid_block({40.0, 20.0, 20.0}));
  const TissueMap map{bone};
  KerfSet kerfs({}, bone.world_from_bone);
  const RigidTransform bone_from_tool = tests::blade_down({0.0, -4.0, 0.0});
  ASSERT_EQ(kerfs.freeze(quantise(bone_from_tool)), 0);
  ToolSample sample;
  sample.world_from_tool = quantise(bone.world_from_bone * bone_from_tool);
  sample.kerf = 0;
  sample.status = static_cast<std::uint32_t>(ToolStatus::SawOn);
  kerfs.apply(sample);
  const Bvh piece{tests::moved(tests::solid_block({10.0, 20.0, 20.0}), {{}, {15.0, 0.0, 0.0}})};
  const std::array<const Bvh*, 1> removed{&piece};
  const RemainingTissue standing{map, kerfs, removed};
  EXPECT_EQ(standing.at({0.0, 0.0, 0.0}), Tissue::None);       // within the blade and the slab
  EXPECT_EQ(standing.at({0.0, -5.0, 0.0}), Tissue::Cortical);  // below the teeth
  EXPECT_EQ(standing.at({0.3, 0.0, 0.0}), Tissue::Cortical);   // beside the slab
  EXPECT_EQ(standing.at({0.2, 0.0, 0.0}), Tissue::None);       // still within its half thickness
  EXPECT_EQ(standing.at({12.0, 0.0, 0.0}), Tissue::None);      // in the piece
  EXPECT_EQ(standing.at({8.0, 0.0, 0.0}), Tissue::Cortical);   // before it
  EXPECT_EQ(standing.at({0.0, 11.0, 0.0}), Tissue::None);      // outside the bone
}

}  // namespace
}  // namespace hallux::simulator

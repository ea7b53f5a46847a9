#include "simulator/cutting/remaining/remaining_bone.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "simulator/base/random.h"
#include "simulator/cutting/field/region_outline.h"
#include "simulator/cutting/solid/commit_patch.h"
#include "simulator/record/record.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

constexpr double half_mm = 0.25;
/// Of the region's outline against the field's own rim, and of a kerf's plane in the record's
/// quantum.
constexpr double outline_mm = 3.0e-4;

/// A point where a front ends at another surface is looked for 1 um behind the front: askew, some
/// of them off.
constexpr double border_mm = 5.0e-3;
/// Such points are looked for along four lines from the nearest point of a segment of the rim,
/// which is at most a node's spacing long: half of that is far more than what can lie nearer
/// between the lines.
constexpr double askew_mm = 0.5 * 0.05;

FieldGrid small_grid() { return {Vec2(-20.0, -20.0), 0.05, 801, 801}; }

/// Kerfs in the bone's frame; world and bone are one.
struct Sawn {
  explicit Sawn(IndexedMesh bone)
      : solid(uncut_solid(std::move(bone))),
        original(solid.mesh),
        kerfs(Blade{.width_mm = 10.0, .depth_mm = 20.0, .kerf_mm = 2.0 * half_mm}, RigidTransform{},
              small_grid()) {}

  /// Freezes a kerf at a pose and feeds the blade along its x by `feed_mm`.
  void saw(const RigidTransform& bone_from_tool, double feed_mm) {
    const QuantisedPose start = quantise(bone_from_tool);
    const std::int32_t kerf = kerfs.freeze(start);
    ASSERT_GE(kerf, 0);
    const RigidTransform frozen = transform_from(start);
    for (const double fed_mm : {0.0, feed_mm}) {
      ToolSample sample;
      sample.kerf = kerf;
      sample.status = static_cast<std::uint32_t>(ToolStatus::SawOn);
      sample.world_from_tool =
          quantise(frozen * RigidTransform{Quat(1.0, 0.0, 0.0, 0.0), Vec3(fed_mm, 0.0, 0.0)});
      kerfs.apply(sample);
    }
    commit(kerf);
  }

  void commit(std::int32_t kerf) {
    const Bvh tree(solid.mesh);
    const KerfCut cut = cut_kerf(solid, tree, kerfs.plane(kerf), kerf, kerfs.field(kerf).grid(),
                                 outline_of(kerfs.field(kerf)));
    ASSERT_EQ(cut.nudges, 0U);
    solid = cut.solid;
  }

  RemainingBone standing() const { return {original, kerfs, taken_out}; }

  CutSolid solid;  ///< with the kerfs committed
  Bvh original;
  KerfSet kerfs;
  std::vector<const Bvh*> taken_out;
};

/// A block of 30 x 16 x 12 mm, sawn down from its upper face (y = 8) at x = 0 to y = 2: blade along
/// -y, its teeth along z over +-5 mm of the block's +-6.
Sawn slotted_block() {
  Sawn sawn(solid_block(Vec3(30.0, 16.0, 12.0)));
  const Quat down = rotation_from_axes(Vec3(0.0, -1.0, 0.0), Vec3(0.0, 0.0, 1.0));
  sawn.saw({down, Vec3(0.0, 9.0, 0.0)}, 7.0);
  return sawn;
}

/// Negative inside; `bone` has a surface.
double signed_distance_mm(const RemainingBone& bone, const Vec3& point_mm) {
  const double distance_mm = bone.nearest(point_mm)->distance_mm;
  return bone.contains(point_mm) ? -distance_mm : distance_mm;
}

TEST(RemainingBone, KnowsWallsFrontsAndCornersOfARectangularKerf) {
  const Sawn sawn = slotted_block();
  const RemainingBone bone = sawn.standing();
  // In the slot: nearer to one wall.
  auto found = bone.nearest(Vec3(0.1, 5.0, 1.0));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->side, BoneSide::Wall);
  EXPECT_NEAR(found->distance_mm, half_mm - 0.1, 1e-6);
  EXPECT_NEAR(found->normal.x, -1.0, 1e-6);
  EXPECT_FALSE(bone.contains(Vec3(0.1, 5.0, 1.0)));
  // Near the floor that the teeth left, and in the bone below it.
  found = bone.nearest(Vec3(0.0, 2.1, 0.5));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->side, BoneSide::Front);
  EXPECT_NEAR(found->distance_mm, 0.1, outline_mm);
  EXPECT_NEAR(found->normal.y, 1.0, 1e-6);
  EXPECT_NEAR(signed_distance_mm(bone, Vec3(0.0, 1.0, 0.5)), -1.0, outline_mm);
  // In the bone beside the slot, and off the slot's lower edge.
  EXPECT_NEAR(signed_distance_mm(bone, Vec3(0.85, 5.0, 0.0)), -(0.85 - half_mm), 1e-6);
  EXPECT_NEAR(signed_distance_mm(bone, Vec3(half_mm + 0.3, 2.0 - 0.4, 0.0)), -0.5, outline_mm);
  // Beside the blade's edge: its front at z = 5 lies 0.4 mm away, the wall of the block 0.6.
  EXPECT_NEAR(signed_distance_mm(bone, Vec3(0.0, 5.0, 5.4)), -0.4, outline_mm);
  // Over the mouth: the skin straight below is gone, its edge stands.
  found = bone.nearest(Vec3(0.0, 8.2, 0.0));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->distance_mm, std::hypot(half_mm, 0.2), 1e-6);
  // Far from the kerf everything is as it was.
  found = bone.nearest(Vec3(8.0, 9.5, 0.0));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->side, BoneSide::Skin);
  EXPECT_NEAR(found->distance_mm, 1.5, 1e-12);
  EXPECT_FALSE(bone.nearest(Vec3(8.0, 9.5, 0.0), 1.0));
}

/// The way of one point along a direction until it touches; nothing where it never does.
std::optional<double> free_way_mm(const RemainingBone& bone, const Vec3& from_mm,
                                  const Vec3& way_mm) {
  const std::array<Vec3, 1> point{Vec3(0.0)};
  const Quat level(1.0, 0.0, 0.0, 0.0);
  const Advance advance = bone.first_contact(point, {{level, from_mm}, {level, from_mm + way_mm}});
  if (!advance.is_contact) return std::nullopt;
  return advance.free_share * std::sqrt(glm::dot(way_mm, way_mm));
}

TEST(RemainingBone, APointGoesThroughOpenKerfs) {
  const Sawn sawn = slotted_block();
  const RemainingBone bone = sawn.standing();
  const Vec3 down(0.0, -50.0, 0.0);
  // Down the slot to its floor, and beside it to the skin.
  EXPECT_NEAR(free_way_mm(bone, Vec3(0.1, 12.0, 1.0), down).value(), 10.0, 1e-3);
  EXPECT_NEAR(free_way_mm(bone, Vec3(0.3, 12.0, 1.0), down).value(), 4.0,
              2.0 * contact_tolerance_mm);
  // From within the slot to a wall, from within bone to the slot.
  EXPECT_NEAR(free_way_mm(bone, Vec3(0.0, 5.0, 0.0), Vec3(50.0, 0.0, 0.0)).value(), half_mm,
              2.0 * contact_tolerance_mm);
  EXPECT_NEAR(free_way_mm(bone, Vec3(5.0, 5.0, 0.0), Vec3(-50.0, 0.0, 0.0)).value(), 5.0 - half_mm,
              2.0 * contact_tolerance_mm);
  EXPECT_FALSE(free_way_mm(bone, Vec3(0.1, 12.0, 1.0), -down));
  EXPECT_FALSE(free_way_mm(bone, Vec3(0.1, 12.0, 1.0), Vec3(0.0, -9.0, 0.0)));
}

TEST(RemainingBone, MovingPointsStopAtTheFloorOfTheirSlot) {
  const Sawn sawn = slotted_block();
  const RemainingBone bone = sawn.standing();
  const std::array<Vec3, 3> teeth{Vec3(0.0, -4.0, 0.0), Vec3(0.0, 0.0, 0.0), Vec3(0.0, 4.0, 0.0)};
  const Quat down = rotation_from_axes(Vec3(0.0, -1.0, 0.0), Vec3(0.0, 0.0, 1.0));
  // From 4 mm above the skin to 4 mm below the floor.
  const RigidMotion motion{{down, Vec3(0.0, 12.0, 0.0)}, {down, Vec3(0.0, -2.0, 0.0)}};
  const Advance in_slot = bone.first_contact(teeth, motion);
  EXPECT_TRUE(in_slot.is_contact);
  EXPECT_NEAR(in_slot.free_share, 10.0 / 14.0, 1e-4);
  const RigidMotion beside{{down, Vec3(1.0, 12.0, 0.0)}, {down, Vec3(1.0, -2.0, 0.0)}};
  const Advance on_skin = bone.first_contact(teeth, beside);
  EXPECT_TRUE(on_skin.is_contact);
  EXPECT_NEAR(on_skin.free_share, 4.0 / 14.0, contact_tolerance_mm);
  EXPECT_LE(on_skin.free_share, 4.0 / 14.0);
}

TEST(RemainingBone, MovingPointsNeverJumpOverAThinSheet) {
  const Sawn sawn(solid_block(Vec3(40.0, 40.0, 0.002)));
  const RemainingBone bone = sawn.standing();
  Random random(5);
  const auto any = [&](double side_mm) {
    return Vec3(random.uniform(-side_mm, side_mm), random.uniform(-side_mm, side_mm),
                random.uniform(-side_mm, side_mm));
  };
  const auto any_turn = [&] {
    return normalised(Quat(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                           random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)));
  };
  for (int i = 0; i < 100; ++i) {
    const std::array<Vec3, 3> points{any(2.0), any(2.0), any(2.0)};
    RigidMotion motion{{any_turn(), any(4.0)}, {any_turn(), any(4.0)}};
    motion.bone_from_start.translation_mm.z = 9.0;
    motion.bone_from_end.translation_mm.z = -9.0;
    const Advance advance = bone.first_contact(points, motion);
    ASSERT_TRUE(advance.is_stopped);
    for (int k = 0; k <= 20; ++k) {
      const RigidTransform pose =
          interpolate(motion.bone_from_start, motion.bone_from_end, advance.free_share * k / 20.0);
      for (const Vec3& point : points) ASSERT_GT(transform_point(pose, point).z, 0.001);
    }
  }
}

/// Distances against those to the committed mesh, at points all around the kerfs.
void expect_agreement(const Sawn& sawn, std::uint64_t seed, double tolerance_mm) {
  const RemainingBone bone = sawn.standing();
  const Bvh committed(sawn.solid.mesh);
  Random random(seed);
  std::array<int, 3> sides{};
  for (int i = 0; i < 1500; ++i) {
    Vec3 point(random.uniform(-10.0, 10.0), random.uniform(-9.0, 10.0), random.uniform(-8.0, 8.0));
    if (i % 2 == 0) {
      // Near a kerf's plane, where fronts and walls are.
      const KerfPlane& plane = sawn.kerfs.plane(i / 2 % sawn.kerfs.count());
      point = transform_point(
          plane.bone_from_kerf,
          Vec3(random.uniform(-3.0, 9.0), random.uniform(-7.0, 7.0), random.uniform(-0.6, 0.6)));
    }
    const auto found = bone.nearest(point);
    ASSERT_TRUE(found);
    const double expected_mm = committed.nearest(point)->distance_mm;
    const double error_mm = found->distance_mm - expected_mm;
    ++sides[static_cast<std::size_t>(found->side)];
    // The point that is answered lies on the mesh.
    ASSERT_LT(committed.nearest(found->point_in_bone_mm)->distance_mm, border_mm);
    ASSERT_GT(error_mm, -border_mm) << i;
    ASSERT_LT(error_mm, tolerance_mm)
        << point.x << " " << point.y << " " << point.z << ", " << static_cast<int>(found->side);
    // Within a node of the rim the bilinear field and its outline may take sides differently.
    const bool is_clear = expected_mm > 0.05;
    ASSERT_EQ(is_clear && bone.contains(point), is_clear && committed.contains(point));
  }
  for (const int count : sides) EXPECT_GT(count, 50);
}

TEST(RemainingBone, AgreesWithTheCommittedBlock) {
  expect_agreement(slotted_block(), 1, outline_mm);
}

TEST(RemainingBone, AgreesWithACommittedSphereSawnAskew) {
  Sawn sawn(sphere(7.5, 10));
  const Quat askew = rotation_from_axes(Vec3(0.2, -0.9, 0.3), Vec3(0.1, 0.3, 1.0));
  sawn.saw({askew, Vec3(0.4, 7.0, -1.0)}, 6.3);
  expect_agreement(sawn, 2, askew_mm);
}

TEST(RemainingBone, AgreesWithTwoKerfsThatMeet) {
  Sawn sawn(solid_block(Vec3(30.0, 16.0, 12.0)));
  const Quat first = rotation_from_axes(Vec3(0.2, -1.0, 0.0), Vec3(0.0, 0.0, 1.0));
  const Quat second = rotation_from_axes(Vec3(-0.25, -1.0, 0.05), Vec3(0.0, 0.0, 1.0));
  sawn.saw({first, Vec3(-1.5, 9.0, 0.0)}, 8.0);
  sawn.saw({second, Vec3(1.5, 9.0, 0.3)}, 8.0);
  expect_agreement(sawn, 3, askew_mm);
}

TEST(RemainingBone, ABodyTakenOutIsGoneWithItsSkin) {
  // A wedge's worth sawn free by two parallel kerfs that go all the way through a narrow block.
  Sawn sawn(solid_block(Vec3(30.0, 8.0, 8.0)));
  const Quat down = rotation_from_axes(Vec3(0.0, -1.0, 0.0), Vec3(0.0, 0.0, 1.0));
  sawn.saw({down, Vec3(-2.0, 5.0, 0.0)}, 10.0);
  sawn.saw({down, Vec3(2.0, 5.0, 0.0)}, 10.0);
  const std::vector<CutSolid> pieces = split_pieces(sawn.solid);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_TRUE(sawn.standing().contains(Vec3(0.0)));
  const Bvh slice(pieces[2].mesh);
  ASSERT_TRUE(slice.contains(Vec3(0.0)));
  sawn.taken_out = {&slice};
  const RemainingBone bone = sawn.standing();
  EXPECT_FALSE(bone.contains(Vec3(0.0)));
  // The slice's own walls and skin are gone: the far walls of both kerfs are nearest.
  auto found = bone.nearest(Vec3(0.5, 1.0, 0.0));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->side, BoneSide::Wall);
  EXPECT_NEAR(found->distance_mm, 2.0 + half_mm - 0.5, 1e-6);
  EXPECT_FALSE(free_way_mm(bone, Vec3(0.5, 20.0, 0.0), Vec3(0.0, -60.0, 0.0)));
}

TEST(RemainingBone, TakesNothingFromTheHeap) {
  const Sawn sawn = slotted_block();
  const RemainingBone bone = sawn.standing();
  const std::array<Vec3, 2> teeth{Vec3(0.0, -4.0, 0.0), Vec3(0.0, 4.0, 0.0)};
  Random random(4);
  double sum = 0.0;
  const std::uint64_t before = allocations_of_this_thread();
  for (int i = 0; i < 300; ++i) {
    const Vec3 point(random.uniform(-3.0, 3.0), random.uniform(-9.0, 10.0),
                     random.uniform(-8.0, 8.0));
    sum += bone.nearest(point, 2.0).has_value() ? 1.0 : 0.0;
    sum += bone.first_contact(teeth, {{Quat(1.0, 0.0, 0.0, 0.0), point}, {}}).free_share;
  }
  EXPECT_EQ(allocations_of_this_thread(), before);
  EXPECT_NE(sum, 0.0);
}

}  // namespace
}  // namespace hallux::tests

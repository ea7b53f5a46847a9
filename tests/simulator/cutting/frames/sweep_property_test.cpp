/// What must hold between two cuts: of the same bone moved, scaled or mirrored, of the same stamps
/// in another order, of one sweep in few steps and in many.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/cutting/solid/opened_volume.h"
#include "tests/simulator/cutting/frames/kerf_play.h"
#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/simulator/cutting/worlds/outlines.h"
#include "tests/simulator/cutting/worlds/shown_solid.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

constexpr double reach_mm = 40.0;

struct Built {
  CutSolid solid;
  SolidPatch patch;
  double removed_mm3 = 0.0;
};

Built build_on(IndexedMesh mesh, const KerfPlane& plane, const RegionOutline& region,
               double scale = 1.0) {
  Built built{uncut_solid(std::move(mesh)), {}, 0.0};
  const SlabSlice contact = slice_slab(built.solid, Bvh(built.solid.mesh), plane, 0,
                                       Vec2(-scale * reach_mm), Vec2(scale * reach_mm));
  PatchBuilder builder(contact);
  RC_ASSERT(builder.build(region, built.patch));
  const IndexedMesh shown = shown_mesh(built.solid, built.patch);
  RC_ASSERT(is_closed_as_chain(shown));
  built.removed_mm3 = signed_volume_mm3(built.solid.mesh) - signed_volume_mm3(shown);
  return built;
}

RegionOutline random_region(Random& random) {
  StrokedRegion stroked(random, 12.0, 3);
  RegionOutline region;
  for (int i = 0; i < 3; ++i) region = stroked.next();
  return region;
}

RC_GTEST_PROP(SweepProperty, ARigidMotionOfBoneAndPlaneChangesNothing, (std::uint64_t seed)) {
  Random random(seed);
  const IndexedMesh mesh = random_bone(random);
  const KerfPlane plane = random_plane(random);
  const RegionOutline region = random_region(random);
  const RigidTransform motion{rotation_about(random_direction(random), random.uniform(-3.0, 3.0)),
                              10.0 * random_direction(random)};
  const Built here = build_on(mesh, plane, region);
  const Built there =
      build_on(moved(mesh, motion), {motion * plane.bone_from_kerf, plane.thickness_mm}, region);
  RC_ASSERT(std::abs(here.removed_mm3 - there.removed_mm3) <=
            2.0 * balance_limit_mm3(here.solid, here.patch));
  const auto count = static_cast<double>(here.patch.triangles.size());
  const auto count_there = static_cast<double>(there.patch.triangles.size());
  RC_ASSERT(std::abs(count - count_there) <= 2.0 + 0.02 * count);
}

// The lattice reaches over 80 mm here and over 160 mm there: its step doubles too, and doubling is
// exact.
RC_GTEST_PROP(SweepProperty, TwiceTheSizeIsTheSamePatchAndEightTimesTheVolume,
              (std::uint64_t seed)) {
  Random random(seed);
  const IndexedMesh mesh = random_bone(random);
  KerfPlane plane = random_plane(random);
  RegionOutline region = random_region(random);
  const Built small = build_on(mesh, plane, region);
  IndexedMesh doubled = mesh;
  for (Vec3& point_mm : doubled.points_mm) point_mm *= 2.0;
  for (Vec2& corner_mm : region.corners_mm) corner_mm *= 2.0;
  plane.bone_from_kerf.translation_mm *= 2.0;
  plane.thickness_mm *= 2.0;
  const Built large = build_on(doubled, plane, region, 2.0);
  RC_ASSERT(large.patch.triangles == small.patch.triangles);
  RC_ASSERT(large.patch.hidden == small.patch.hidden);
  for (std::size_t i = 0; i < small.patch.points_in_bone_mm.size(); ++i) {
    RC_ASSERT(large.patch.points_in_bone_mm[i] == 2.0 * small.patch.points_in_bone_mm[i]);
  }
  RC_ASSERT(large.removed_mm3 == 8.0 * small.removed_mm3);
}

RC_GTEST_PROP(SweepProperty, AMirroredBoneLosesTheSameVolumeAndStaysOutward, (std::uint64_t seed)) {
  Random random(seed);
  const IndexedMesh mesh = random_bone(random);
  const KerfPlane plane = random_plane(random);
  const RegionOutline region = random_region(random);
  IndexedMesh mirrored = inside_out(mesh);
  for (Vec3& point_mm : mirrored.points_mm) point_mm.x = -point_mm.x;
  const auto mirror = [](const Vec3& v) { return Vec3(-v.x, v.y, v.z); };
  const KerfAxes axes = axes_of(plane);
  const KerfPlane facing{{rotation_from_axes(mirror(axes.x), mirror(axes.y)),
                          mirror(plane.bone_from_kerf.translation_mm)},
                         plane.thickness_mm};
  const Built here = build_on(mesh, plane, region);
  const Built there = build_on(mirrored, facing, region);
  RC_ASSERT(std::abs(here.removed_mm3 - there.removed_mm3) <=
            2.0 * balance_limit_mm3(here.solid, here.patch));
  RC_ASSERT(signed_volume_mm3(shown_mesh(there.solid, there.patch)) > 0.0);
}

const FieldGrid grid{.origin_mm = Vec2(-20.0), .spacing_mm = 0.2, .u_count = 201, .v_count = 201};
const Blade blade{.width_mm = 9.0, .depth_mm = 14.0};

PlanarPose random_pose(Random& random) {
  const double turn = random.uniform(-0.5, 0.5), length = std::sqrt(1.0 + turn * turn);
  return {Vec2(random.uniform(-10.0, 12.0), random.uniform(-6.0, 6.0)),
          Vec2(1.0 / length, turn / length)};
}

RC_GTEST_PROP(SweepProperty, StampsInAnyOrderAndTwiceGiveTheSamePatchToTheLastBit,
              (std::uint64_t seed)) {
  Random random(seed);
  const IndexedMesh mesh = random_bone(random);
  const KerfPlane plane = random_plane(random);
  std::vector<std::pair<PlanarPose, PlanarPose>> stamps(8);
  for (auto& [from, to] : stamps) {
    from = random_pose(random);
    to = random_pose(random);
  }
  KerfField forward(grid), shuffled(grid);
  FieldWindow changed;
  for (const auto& [from, to] : stamps) forward.stamp(blade, from, to, changed);
  for (std::size_t i = stamps.size(); i-- > 0;) {
    shuffled.stamp(blade, stamps[i].first, stamps[i].second, changed);
    const auto& again = stamps[random.bits() % stamps.size()];
    shuffled.stamp(blade, again.first, again.second, changed);
  }
  RC_ASSERT(are_same(build_on(mesh, plane, outline_of(forward)).patch,
                     build_on(mesh, plane, outline_of(shuffled)).patch));
}

RC_GTEST_PROP(SweepProperty, AStraightMotionInPartsTakesTheSameVolume, (std::uint64_t seed)) {
  Random random(seed);
  const IndexedMesh mesh = random_bone(random);
  const KerfPlane plane = random_plane(random);
  const PlanarPose from = random_pose(random);
  const Vec2 way_mm(random.uniform(2.0, 9.0), random.uniform(-4.0, 4.0));
  KerfField whole(grid), parts(grid);
  FieldWindow changed;
  const int count = 100;
  const auto at = [&](int i) {
    return PlanarPose{from.tip_mm + (static_cast<double>(i) / count) * way_mm, from.direction};
  };
  whole.stamp(blade, at(0), at(count), changed);
  for (int i = 0; i < count; ++i) parts.stamp(blade, at(i), at(i + 1), changed);
  const double once_mm3 = build_on(mesh, plane, outline_of(whole)).removed_mm3;
  const double often_mm3 = build_on(mesh, plane, outline_of(parts)).removed_mm3;
  RC_ASSERT(std::abs(once_mm3 - often_mm3) <= 1e-4 * std::max(once_mm3, 1.0));
}

/// The patches of a blade that feeds straight through a tube in so many steps.
std::size_t most_triangles(int step_count) {
  const CutSolid tube = uncut_solid(hollow_tube({.segments = 64, .rings = 8}));
  const KerfPlane plane = plane_through(Vec3(1.0, 0.0, 0.0), Vec3(1.0, 0.2, 0.1), 0.5);
  const SlabSlice contact = slice_slab(tube, Bvh(tube.mesh), plane, 0, grid);
  PatchBuilder builder(contact);
  KerfField field(grid);
  OutlineTracker tracker(grid);
  SolidPatch patch;
  FieldWindow changed;
  std::size_t most = 0;
  const auto at = [&](int step) {
    const double share = static_cast<double>(step) / step_count;
    return PlanarPose{Vec2(-10.0 + 18.0 * share, 2.0 * std::sin(9.0 * share))};
  };
  for (int step = 0; step < step_count; ++step) {
    field.stamp(blade, at(step), at(step + 1), changed);
    tracker.update(field);
    EXPECT_TRUE(builder.build(tracker.outline(), patch));
    most = std::max(most, patch.triangles.size());
  }
  return most;
}

TEST(Sweep, TrianglesFollowTheOutlineAndNotTheNumberOfSteps) {
  const auto few = static_cast<double>(most_triangles(100));
  const auto many = static_cast<double>(most_triangles(1600));
  EXPECT_NEAR(many, few, 0.1 * few);
}

// Across a straight tube bone ends everywhere at once: the section is gone in the frame in which
// the bodies part.
TEST(Sweep, TheSectionIsGoneInTheFrameInWhichTheBodiesPart) {
  for (const IndexedMesh& bone : {hollow_tube({.segments = 24, .rings = 3}),
                                  solid_block(Vec3(20.0, 12.0, 10.0)), hollow_tube({})}) {
    const CutSolid solid = uncut_solid(bone);
    const SlabSlice contact =
        slice_slab(solid, Bvh(solid.mesh), axis_plane(0, 0.6, 0.4), 0, Vec2(-40.0), Vec2(40.0));
    PatchBuilder builder(contact);
    SolidPatch patch;
    int parted = 0;
    for (double front_mm = -9.0; front_mm < 9.0; front_mm += 0.1) {
      ASSERT_TRUE(builder.build(rectangle_outline(Vec2(-20.0), Vec2(front_mm, 20.0)), patch));
      const std::size_t bodies = body_count(shown_mesh(solid, patch));
      ASSERT_EQ(bodies, builder.takes_section() ? 2U : 1U) << "front at " << front_mm;
      if (bodies == 2) ++parted;
    }
    EXPECT_GT(parted, 5);
    EXPECT_LT(parted, 60);
  }
}

}  // namespace
}  // namespace hallux::tests

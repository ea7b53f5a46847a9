// What the pictures show is what the kernel made, and the nearer covers the farther.
#include "tests/screenshots/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/screenshots/painter_order.h"
#include "tests/screenshots/sawn_bones.h"

namespace hallux::tests {
namespace {

using namespace simulator;

/// The phalanx sawn past its canal, so that every kind of face is there.
struct SawnPhalanx {
  PlannedBone bone = akin_phalanx(1.2);
  KerfPlane plane = planned_kerf(bone, 0, 2.0);
  SawnFrame frame;

  SawnPhalanx() {
    KerfField field(wide_grid());
    saw(field, bone.scenario.saw.blade,
        {{Vec2(-30.0, 4.0), Vec2(1.0, 0.0)}, {Vec2(-6.0, 4.0), Vec2(1.0, 0.0)}});
    frame = frame_of(bone.solid, plane, field);
  }
};

PageTriangle triangle(const std::array<Vec2, 3>& places_px, const std::array<double, 3>& depths,
                      std::uint32_t paint) {
  return {places_px, depths, paint};
}

TEST(Scene, ShowsWhatStandsAndThePatchByKind) {
  const SawnPhalanx sawn;
  const Scene scene = shown_scene(sawn.bone.solid, sawn.frame);
  const SolidPatch& patch = sawn.frame.patch;
  EXPECT_EQ(scene.faces().size(),
            sawn.bone.solid.mesh.triangles.size() - patch.hidden.size() + patch.triangles.size());
  const auto walls = [&](int side) {
    return static_cast<std::size_t>(
        std::count(patch.sources.begin(), patch.sources.end(), FaceSource{0, side}));
  };
  EXPECT_EQ(scene.count(Paint::UpperWall), walls(1));
  EXPECT_EQ(scene.count(Paint::LowerWall), walls(-1));
  EXPECT_EQ(scene.count(Paint::Front), walls(0));
  for (const Paint paint : {Paint::Skin, Paint::Strip, Paint::OuterPart, Paint::UpperWall,
                            Paint::LowerWall, Paint::Front}) {
    EXPECT_GT(scene.count(paint), 0U);
  }
}

TEST(Scene, StripLiesBetweenThePlanesAndOuterPartsReachBeyond) {
  const SawnPhalanx sawn;
  const Scene scene = shown_scene(sawn.bone.solid, sawn.frame);
  const RigidTransform kerf_from_bone = inverse(sawn.plane.bone_from_kerf);
  for (const SceneFace& face : scene.faces()) {
    double highest_mm = 0.0;
    for (const Vec3& point : face.points_mm) {
      highest_mm = std::max(highest_mm, std::abs(transform_point(kerf_from_bone, point).z));
    }
    if (face.paint == Paint::Strip) {
      EXPECT_LE(highest_mm, 1.0 + 1.0e-9);
    }
    if (face.paint == Paint::OuterPart) {
      EXPECT_GT(highest_mm, 1.0 + 1.0e-9);
    }
  }
}

TEST(PainterOrder, PaintsALongTriangleBehindAShortOneThatCoversItThoughItsMiddleIsNearer) {
  // The long one rises to the right; where they overlap, at its left end, it is the farther.
  const std::vector<PageTriangle> triangles{
      triangle({Vec2(8.0, 0.0), Vec2(16.0, 0.0), Vec2(12.0, 8.0)}, {2.0, 2.0, 2.0}, 0),
      triangle({Vec2(0.0, 2.0), Vec2(100.0, 2.0), Vec2(0.0, 6.0)}, {0.0, 90.0, 0.0}, 1)};
  // At x = 12 the long one's depth is 10.8: there it is nearer, and comes last.
  EXPECT_EQ(painter_order(triangles, {0, 1}), (std::vector<std::uint32_t>{0, 1}));
  std::vector<PageTriangle> flat = triangles;
  flat[1].depths = {-9.0, 90.0, -9.0};  // 2.9 at x = 12, and still nearer
  EXPECT_EQ(painter_order(flat, {0, 1}), (std::vector<std::uint32_t>{0, 1}));
  flat[1].depths = {-20.0, 90.0, -20.0};  // -6.8 at x = 12, though 17 in the middle
  EXPECT_EQ(painter_order(flat, {0, 1}), (std::vector<std::uint32_t>{1, 0}));
}

TEST(PainterOrder, LeavesOutWhatNothingShows) {
  const std::vector<PageTriangle> triangles{
      triangle({Vec2(4.0, 4.0), Vec2(8.0, 4.0), Vec2(4.0, 8.0)}, {0.0, 0.0, 0.0}, 0),
      triangle({Vec2(0.0, 0.0), Vec2(40.0, 0.0), Vec2(0.0, 40.0)}, {1.0, 1.0, 1.0}, 0),
      triangle({Vec2(30.0, 30.0), Vec2(50.0, 30.0), Vec2(30.0, 50.0)}, {0.0, 0.0, 0.0}, 0)};
  EXPECT_EQ(seen_triangles(triangles), (std::vector<std::uint32_t>{1, 2}));
}

}  // namespace
}  // namespace hallux::tests

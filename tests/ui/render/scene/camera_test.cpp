#include "ui/render/scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulator/base/random.h"
#include "simulator/base/units.h"
#include "ui/render/stereo.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr double aspect = 16.0 / 9.0;

Camera some_camera() {
  Camera camera;
  camera.target_mm = Vec3(200.0, 15.0, -27.0);
  camera.magnification = 7.0;
  camera.target_depth_mm = 6.0;
  return standard_view(camera, StandardView::Operator);
}

/// A point of the screen plane, `x` and `y` from its middle in the world's millimetres, `z` towards
/// the viewer.
Vec3 at_screen(const Camera& camera, const Vec3& from_middle_mm) {
  return camera.target_mm +
         camera.world_from_view * (Vec3(0.0, 0.0, camera.target_depth_mm) + from_middle_mm);
}

TEST(Stereo, APointInTheScreenPlaneLandsOnTheSamePlaceInBothEyes) {
  const Camera camera = some_camera();
  const EyeView left = view_of(camera, {}, Eye::Left, aspect);
  const EyeView right = view_of(camera, {}, Eye::Right, aspect);
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Vec3 point_mm =
        at_screen(camera, Vec3(random.uniform(-30.0, 30.0), random.uniform(-18.0, 18.0), 0.0));
    const Vec3 seen_left = place_in_picture(left, point_mm);
    const Vec3 seen_right = place_in_picture(right, point_mm);
    EXPECT_NEAR(seen_left.x, seen_right.x, 1e-12);
    EXPECT_NEAR(seen_left.y, seen_right.y, 1e-12);
  }
}

TEST(Stereo, WhatLiesBehindTheScreenIsUncrossedAndWhatLiesBeforeItCrossed) {
  const Camera camera = some_camera();
  const EyeView left = view_of(camera, {}, Eye::Left, aspect);
  const EyeView right = view_of(camera, {}, Eye::Right, aspect);
  const auto parallax = [&](double towards_viewer_mm) {
    const Vec3 point_mm = at_screen(camera, Vec3(2.0, 1.0, towards_viewer_mm));
    return place_in_picture(right, point_mm).x - place_in_picture(left, point_mm).x;
  };
  EXPECT_GT(parallax(-10.0), 0.0);
  EXPECT_LT(parallax(10.0), 0.0);
  // No vertical parallax anywhere: the axes are parallel, not toed in.
  const Vec3 corner_mm = at_screen(camera, Vec3(25.0, 14.0, -20.0));
  EXPECT_NEAR(place_in_picture(left, corner_mm).y, place_in_picture(right, corner_mm).y, 1e-12);
}

TEST(Stereo, ParallaxStaysWithinItsLimit) {
  const Viewer viewer;
  Camera camera = some_camera();
  for (const double magnification : {2.0, 7.0, 20.0}) {
    camera.magnification = magnification;
    const EyeView left = view_of(camera, viewer, Eye::Left, aspect);
    const EyeView right = view_of(camera, viewer, Eye::Right, aspect);
    // As deep as the screen is wide: deeper than any bone of a scene.
    const double deep_mm = viewer.screen_width_mm / magnification;
    const Vec3 point_mm = at_screen(camera, Vec3(0.0, 0.0, -deep_mm));
    const double parallax =
        place_in_picture(right, point_mm).x - place_in_picture(left, point_mm).x;
    EXPECT_LE(parallax, viewer.parallax_limit + 1e-12);
    EXPECT_GT(parallax, 0.5 * viewer.parallax_limit);
  }
}

TEST(Stereo, AnaglyphsKeepWhiteWhite) {
  const AnaglyphMatrices matrices = anaglyph_matrices();
  for (int shown = 0; shown < 3; ++shown) {
    float sum = 0.0F;
    for (int seen = 0; seen < 3; ++seen) {
      sum += matrices.shown_from_left[seen][shown] + matrices.shown_from_right[seen][shown];
    }
    EXPECT_NEAR(sum, 1.0F, 0.005F);
  }
}

TEST(Camera, AMillimetreInTheScreenPlaneIsAsLargeAsTheMagnificationSays) {
  const Viewer viewer;
  const Camera camera = some_camera();
  const EyeView view = view_of(camera, viewer, Eye::Middle, aspect);
  const double a = place_in_picture(view, at_screen(camera, Vec3(0.0))).x;
  const double b = place_in_picture(view, at_screen(camera, Vec3(1.0, 0.0, 0.0))).x;
  EXPECT_NEAR((b - a) * viewer.screen_width_mm, camera.magnification, 1e-9);
}

TEST(Camera, PlacesAndPointsAreEachOthersInverse) {
  const EyeView view = view_of(some_camera(), {}, Eye::Left, aspect);
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Vec3 point_mm(random.uniform(185.0, 215.0), random.uniform(0.0, 30.0),
                        random.uniform(-40.0, -12.0));
    EXPECT_LT(glm::length(point_at(view, place_in_picture(view, point_mm)) - point_mm), 1e-7);
  }
}

TEST(Camera, OrbitKeepsTheTargetInPlaceAndDistance) {
  const Camera camera = some_camera();
  const Vec3 before = place_in_picture(view_of(camera, {}, Eye::Middle, aspect), camera.target_mm);
  const Camera turned = orbited(camera, 0.7, -0.3);
  const Vec3 after = place_in_picture(view_of(turned, {}, Eye::Middle, aspect), turned.target_mm);
  EXPECT_LT(glm::length(after - before), 1e-9);
  EXPECT_GT(std::abs(glm::dot(turned.world_from_view * Vec3(1.0, 0.0, 0.0),
                              camera.world_from_view * Vec3(0.0, 0.0, 1.0))),
            0.3);
}

TEST(Camera, OrbitToTheRightMovesWhatIsNearToTheRight) {
  Camera camera = some_camera();
  const Vec3 near_mm = camera.target_mm + camera.world_from_view * Vec3(0.0, 0.0, 5.0);
  const Camera turned = orbited(camera, 0.1, 0.0);
  EXPECT_GT(place_in_picture(view_of(turned, {}, Eye::Middle, aspect), near_mm).x,
            place_in_picture(view_of(camera, {}, Eye::Middle, aspect), near_mm).x);
}

TEST(Camera, PanMovesThePictureByItsShares) {
  const Camera camera = some_camera();
  const Vec3 point_mm = at_screen(camera, Vec3(3.0, 2.0, 0.0));
  const Vec3 before = place_in_picture(view_of(camera, {}, Eye::Middle, aspect), point_mm);
  const Camera moved = panned(camera, {}, Vec2(0.10, 0.05));
  const Vec3 after = place_in_picture(view_of(moved, {}, Eye::Middle, aspect), point_mm);
  EXPECT_NEAR(after.x - before.x, 0.10, 1e-9);
  EXPECT_NEAR(after.y - before.y, -0.05 * aspect, 1e-9);  // shares of the width, upwards
}

TEST(Camera, ZoomIsHeldWithinItsBounds) {
  EXPECT_EQ(zoomed(some_camera(), 1e9).magnification, 60.0);
  EXPECT_EQ(zoomed(some_camera(), 1e-9).magnification, 1.0);
}

TEST(Camera, AFittedBallIsWhollyInThePicture) {
  Camera camera = some_camera();
  for (const double picture : {0.5, 1.0, aspect}) {
    const Camera fit = fitted(camera, {}, 22.0, picture);
    const EyeView view = view_of(fit, {}, Eye::Middle, picture);
    for (const Vec3& away : {Vec3(22, 0, 0), Vec3(-22, 0, 0), Vec3(0, 22, 0), Vec3(0, -22, 0)}) {
      const Vec3 place = place_in_picture(view, fit.target_mm + fit.world_from_view * away);
      EXPECT_GE(place.x, 0.0);
      EXPECT_LE(place.x, 1.0);
      EXPECT_GE(place.y, 0.0);
      EXPECT_LE(place.y, 1.0);
    }
  }
}

TEST(Camera, StandardViewsLookFromTheirSides) {
  const auto towards_viewer = [](StandardView view) {
    return standard_view(Camera{}, view).world_from_view * Vec3(0.0, 0.0, 1.0);
  };
  EXPECT_GT(towards_viewer(StandardView::Dorsal).y, 0.999);
  EXPECT_LT(towards_viewer(StandardView::Plantar).y, -0.999);
  EXPECT_LT(towards_viewer(StandardView::Medial).z, -0.999);
  EXPECT_GT(towards_viewer(StandardView::Lateral).z, 0.999);
  EXPECT_GT(towards_viewer(StandardView::Distal).x, 0.999);
  EXPECT_LT(towards_viewer(StandardView::Proximal).x, -0.999);
  const Vec3 operator_from = towards_viewer(StandardView::Operator);
  EXPECT_GT(operator_from.x, 0.2);
  EXPECT_GT(operator_from.y, 0.2);
  EXPECT_LT(operator_from.z, -0.2);
  // Upright: the world's dorsal is up in all but the views along it.
  for (const StandardView view :
       {StandardView::Operator, StandardView::Medial, StandardView::Distal}) {
    const Quat world_from_view = standard_view(Camera{}, view).world_from_view;
    EXPECT_NEAR((world_from_view * Vec3(1.0, 0.0, 0.0)).y, 0.0, 1e-12);
    EXPECT_GT((world_from_view * Vec3(0.0, 1.0, 0.0)).y, 0.5);
  }
}

RigidTransform some_blade() {
  return {rotation_about(glm::normalize(Vec3(0.3, -0.8, 0.5)), 1.1), Vec3(12.0, -4.0, 7.0)};
}

/// Between the way from the eye to the teeth and the blade's plane.
double off_plane_deg(const Camera& camera, const RigidTransform& world_from_blade) {
  const EyeView view = view_of(camera, Viewer{}, Eye::Middle, aspect);
  const Vec3 sight = glm::normalize(world_from_blade.translation_mm - view.eye_in_world_mm);
  const Vec3 normal = world_from_blade.rotation * Vec3(0.0, 0.0, 1.0);
  return degree_from_radian(std::asin(std::abs(glm::dot(sight, normal))));
}

TEST(Camera, LooksAlongABladeExactlyInItsPlaneWhereverTheBladeIs) {
  RigidTransform blade = some_blade();
  for (int i = 0; i < 20; ++i) {
    for (std::size_t sight = 0; sight < blade_sight_count; ++sight) {
      const Camera camera = along_blade(Camera{}, blade, static_cast<BladeSight>(sight));
      EXPECT_LT(off_plane_deg(camera, blade), 1.0e-6);
      const Vec3 middle =
          place_in_picture(view_of(camera, Viewer{}, Eye::Middle, aspect), blade.translation_mm);
      EXPECT_NEAR(middle.x, 0.5, 1.0e-9);
      EXPECT_NEAR(middle.y, 0.5, 1.0e-9);
    }
    blade = blade * RigidTransform{rotation_about(Vec3(0.0, 1.0, 0.0), 0.7), Vec3(3.0, 0.0, 1.0)};
  }
}

TEST(Camera, SeesABladeAlongTheWayThatHidesLeastAndTurnsLeast) {
  const RigidTransform blade = some_blade();
  Camera now = along_blade(Camera{}, blade, BladeSight::AcrossFromMinus);
  now = orbited(now, 0.2, 0.1);
  const auto from_in_blade = [&](const std::array<double, blade_sight_count>& hidden) {
    const Camera seen = seen_along_blade(now, blade, hidden);
    return transform_direction(inverse(blade), seen.world_from_view * Vec3(0.0, 0.0, 1.0));
  };
  EXPECT_NEAR(from_in_blade({}).y, -1.0, 1.0e-9) << "the smallest turn";
  EXPECT_GT(from_in_blade({0.0, 1.0, 0.0}).y, -0.001) << "another where that one is hidden";
  EXPECT_NEAR(from_in_blade({0.0, 1.0, 0.9}).y, 1.0, 1.0e-9);
  EXPECT_NEAR(from_in_blade({1.0, 0.8, 0.1}).x, -1.0, 1.0e-9);
}

TEST(Camera, GoesRoundTheWaysAlongABladeOfWhoLooksAlongItAlready) {
  const RigidTransform blade = some_blade();
  Camera camera = seen_along_blade(Camera{}, blade);
  std::vector<Vec3> seen;
  for (int i = 0; i < 4; ++i) {
    seen.push_back(camera.world_from_view * Vec3(0.0, 0.0, 1.0));
    EXPECT_LT(off_plane_deg(camera, blade), 1.0e-6);
    camera = seen_along_blade(camera, blade);
  }
  EXPECT_GT(glm::distance(seen[0], seen[1]), 0.5);
  EXPECT_GT(glm::distance(seen[1], seen[2]), 0.5);
  EXPECT_LT(glm::distance(seen[0], seen[3]), 1.0e-9);
}

}  // namespace
}  // namespace hallux::tests

#include "ui/render/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/random.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr double wide = 16.0 / 9.0;

Vec3 place(const Camera& camera, Eye eye, const Vec3& point_mm) {
  return place_in_picture(view_of(camera, {}, eye, wide), point_mm);
}

TEST(Camera, WhatLiesInTheScreenPlaneLandsOnTheSamePixelInBothEyes) {
  Camera camera;
  camera.target_depth_mm =
      0.0;  // the target, and the plane across the view through it, is the screen
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 point_mm(random.uniform(-25.0, 25.0), random.uniform(-12.0, 12.0), 0.0);
    const Vec3 left = place(camera, Eye::Left, point_mm),
               right = place(camera, Eye::Right, point_mm);
    EXPECT_NEAR(left.x, right.x, 1e-9);
    EXPECT_NEAR(left.y, right.y, 1e-9);
  }
}

TEST(Camera, WhatLiesBehindTheScreenIsSeenFurtherRightByTheRightEye) {
  Camera camera;
  camera.target_depth_mm = 0.0;
  const Vec3 behind(0.0, 0.0, -20.0), before(0.0, 0.0, 20.0);
  EXPECT_GT(place(camera, Eye::Right, behind).x, place(camera, Eye::Left, behind).x);
  EXPECT_LT(place(camera, Eye::Right, before).x, place(camera, Eye::Left, before).x);
}

TEST(Camera, APlaceAndItsPointBelongTogether) {
  const Camera camera = standard_view({}, StandardView::Operator);
  const EyeView view = view_of(camera, {}, Eye::Left, wide);
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Vec3 point_mm(random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0),
                        random.uniform(-20.0, 20.0));
    const Vec3 back_mm = point_at(view, place_in_picture(view, point_mm));
    EXPECT_NEAR(glm::distance(point_mm, back_mm), 0.0, 1e-6);
  }
}

TEST(Camera, ABallThatIsFittedIsSeenWholly) {
  Camera camera;
  camera.target_mm = Vec3(3.0, -4.0, 5.0);
  const Camera fit = fitted(camera, {}, 30.0, wide);
  const EyeView view = view_of(fit, {}, Eye::Middle, wide);
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const double height = random.uniform(-1.0, 1.0), angle_rad = random.uniform(0.0, 6.28);
    const double ring = std::sqrt(1.0 - height * height);
    const Vec3 out(ring * std::cos(angle_rad), ring * std::sin(angle_rad), height);
    const Vec3 seen = place_in_picture(view, fit.target_mm + 30.0 * out);
    EXPECT_TRUE(seen.x >= 0.0 && seen.x <= 1.0 && seen.y >= 0.0 && seen.y <= 1.0);
  }
}

TEST(Camera, ZoomStaysWithinItsLimits) {
  EXPECT_DOUBLE_EQ(zoomed({}, 1000.0).magnification, 60.0);
  EXPECT_DOUBLE_EQ(zoomed({}, 0.0001).magnification, 1.0);
}

TEST(Camera, AFullTurnComesBack) {
  Camera camera;
  for (int i = 0; i < 8; ++i) camera = orbited(camera, 3.14159265358979323846 / 4.0, 0.0);
  EXPECT_NEAR(std::abs(glm::dot(camera.world_from_view, Camera{}.world_from_view)), 1.0, 1e-9);
}

}  // namespace
}  // namespace hallux::tests

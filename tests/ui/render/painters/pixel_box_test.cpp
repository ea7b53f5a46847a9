#include "ui/render/painters/pixel_box.h"

#include <gtest/gtest.h>

#include "simulator/base/random.h"
#include "ui/render/stereo.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr PixelSize size{640, 360};

EyeView view_of_origin() {
  Camera camera;
  camera.magnification = 7.0;
  return view_of(camera, {}, Eye::Middle, 16.0 / 9.0);
}

TEST(PixelBox, HoldsWhateverTheBoxCanCover) {
  const EyeView view = view_of_origin();
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const auto around_mm = [&](double half_mm) {
      return Vec3(random.uniform(-half_mm, half_mm), random.uniform(-half_mm, half_mm),
                  random.uniform(-half_mm, half_mm));
    };
    const RigidTransform world_from_frame{
        rotation_about(glm::normalize(around_mm(1.0)), random.uniform(-3.0, 3.0)), around_mm(20.0)};
    Box box;
    box.add(around_mm(12.0));
    box.add(around_mm(12.0));
    const PixelBox pixels = pixels_of(box, world_from_frame, view, size);
    for (int k = 0; k < 20; ++k) {
      const Vec3 share(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0),
                       random.uniform(0.0, 1.0));
      const Vec3 place = place_in_picture(
          view, transform_point(world_from_frame, glm::mix(box.low_mm, box.high_mm, share)));
      const double x = place.x * size.width, y = (1.0 - place.y) * size.height;
      if (x < 0.0 || y < 0.0 || x > size.width || y > size.height) continue;
      EXPECT_TRUE(x >= pixels.left && x <= pixels.right && y >= pixels.bottom && y <= pixels.top);
    }
  }
}

TEST(PixelBox, OfNothingIsEmptyAndOfABoxAroundTheEyeIsAll) {
  const EyeView view = view_of_origin();
  EXPECT_TRUE(pixels_of({}, {}, view, size).is_empty());
  Box box;
  box.add(view.eye_in_world_mm - Vec3(30.0));
  box.add(view.eye_in_world_mm + Vec3(30.0));
  EXPECT_EQ(pixels_of(box, {}, view, size), all_of(size));
}

TEST(PixelBox, BesideThePictureNothingIsCovered) {
  Box box;
  box.add(Vec3(400.0, 0.0, 0.0));
  box.add(Vec3(405.0, 5.0, 5.0));
  EXPECT_TRUE(pixels_of(box, {}, view_of_origin(), size).is_empty());
}

TEST(PixelBox, AnEmptyOneAddsNothing) {
  const PixelBox some{10, 20, 30, 40};
  EXPECT_EQ(around(some, {}), some);
  EXPECT_EQ(around({}, some), some);
  EXPECT_EQ(around(some, {25, 5, 50, 30}), (PixelBox{10, 5, 50, 40}));
  EXPECT_EQ(common(some, {25, 5, 50, 30}), (PixelBox{25, 20, 30, 30}));
  const PixelBox none = common(some, {31, 5, 50, 30});
  EXPECT_TRUE(none.is_empty());
  EXPECT_EQ(pixel_count(none), 0U);
  EXPECT_EQ(pixel_count(some), 400U);
}

}  // namespace
}  // namespace hallux::tests

// The light on bone, measured on pictures: what the saw's shadow and hollows leave of it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/ui/render/graphics.h"
#include "tests/ui/render/operating_world.h"
#include "ui/render/renderer.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr PixelSize size{640, 360};

/// As light, which shown values are the roots of.
double luminance_of(const Colour& colour) {
  const auto light = [](int value) { return value * value / (255.0 * 255.0); };
  return 0.2126 * light(colour.red) + 0.7152 * light(colour.green) + 0.0722 * light(colour.blue);
}

bool is_same(const Colour& one, const Colour& other) {
  return one.red == other.red && one.green == other.green && one.blue == other.blue;
}

class LightOnBone : public Graphics {
 protected:
  LightOnBone() {
    world_.saw_to(-4.0);
    scene_ = world_.scene();
    scene_.bones.pop_back();  // the phalanx alone
    scene_.planes.clear();
    scene_.lines.clear();
  }

  /// Between the light and the bone, its blade square to the light, which goes with the viewer.
  void hold_saw_into_light(const Camera& camera) {
    const Vec3 key = camera.world_from_view * glm::normalize(Vec3(-0.55, 0.75, 0.60));
    const Vec3 feed = camera.world_from_view * Vec3(1.0, 0.0, 0.0);
    const Vec3 across = glm::normalize(glm::cross(key, feed));
    scene_.saw->world_from_tool = {rotation_from_axes(glm::cross(across, key), across),
                                   camera.target_mm + 15.0 * key};
  }
  Pixels draw(const Scene& scene, const Camera& camera) {
    const RenderTarget target(size);
    renderer_.draw(scene, camera, target.target());
    return target.read();
  }
  Scene without_bones() const {
    Scene scene = scene_;
    scene.bones.clear();
    return scene;
  }
  Scene without_saw() const {
    Scene scene = scene_;
    scene.saw.reset();
    return scene;
  }

  OperatingWorld world_{0.9};
  Scene scene_;
  Renderer renderer_{RenderQuality{}};
};

struct Shadow {
  std::size_t count = 0;
  double least_share = std::numeric_limits<double>::infinity();
  int least_warmth = 255;
};

/// The pixels of bone that are darker beside the saw than without it.
Shadow shadow_in(const Pixels& with, const Pixels& without, const Pixels& saw_alone,
                 const Pixels& ground) {
  Shadow shadow;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Colour shaded = pixel_at(with, x, y), lit = pixel_at(without, x, y);
      const bool is_saw = !is_same(pixel_at(saw_alone, x, y), pixel_at(ground, x, y));
      const bool is_bone = !is_same(lit, pixel_at(ground, x, y));
      if (is_saw || !is_bone || luminance_of(shaded) > 0.95 * luminance_of(lit)) continue;
      ++shadow.count;
      shadow.least_share = std::min(shadow.least_share, luminance_of(shaded) / luminance_of(lit));
      shadow.least_warmth =
          std::min({shadow.least_warmth, shaded.red - shaded.green, shaded.green - shaded.blue});
    }
  }
  return shadow;
}

TEST_F(LightOnBone, KeepsMoreThanHalfInTheSawsShadowAndStaysWarm) {
  for (const Ground ground : {Ground::Dark, Ground::Light}) {
    for (const StandardView view :
         {StandardView::Operator, StandardView::Dorsal, StandardView::Medial}) {
      scene_.ground = ground;
      const Camera camera = standard_view(world_.camera(), view);
      hold_saw_into_light(camera);
      Scene nothing;
      nothing.ground = ground;
      const Shadow shadow = shadow_in(draw(scene_, camera), draw(without_saw(), camera),
                                      draw(without_bones(), camera), draw(nothing, camera));
      EXPECT_GT(shadow.count, 500U) << "a shadow is seen";
      EXPECT_GE(shadow.least_share, 0.55);
      EXPECT_LE(shadow.least_share, 0.70) << "and tells that something is before the bone";
      EXPECT_GE(shadow.least_warmth, 0);
    }
  }
}

TEST_F(LightOnBone, IsBrownWhereItDoesNotReach) {
  world_.take_wedge_out();
  scene_ = world_.scene();
  scene_.bones.pop_back();
  const Pixels picture = draw(scene_, world_.camera());
  Pixels ground = draw(Scene{}, world_.camera());
  Facts dark;
  std::size_t cold = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Colour colour = pixel_at(picture, x, y);
      if (is_same(colour, pixel_at(ground, x, y)) || luminance_of(colour) > 0.08) continue;
      ++dark.count;
      dark.red += colour.red;
      dark.green += colour.green;
      dark.blue += colour.blue;
      cold += colour.red <= colour.blue ? 1U : 0U;
    }
  }
  ASSERT_GT(dark.count, 50U);
  const auto count = static_cast<double>(dark.count);
  EXPECT_GT(dark.red / count, 1.25 * dark.green / count);
  EXPECT_GT(dark.green / count, 1.1 * dark.blue / count);
  EXPECT_EQ(cold, 0U);
}

}  // namespace
}  // namespace hallux::tests

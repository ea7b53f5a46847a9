#include "ui/render/painters/tool_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "simulator/base/random.h"
#include "tests/ui/render/drilled_bone.h"
#include "tests/ui/render/graphics.h"
#include "ui/render/renderer.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr PixelSize size{640, 360};
constexpr double aspect = 640.0 / 360.0;

class ToolPixels : public Graphics {
 protected:
  Pixels draw(const Scene& scene) {
    const RenderTarget target(size);
    renderer_.draw(scene, view_, target.target());
    return target.read();
  }
  /// Where the scene's picture is another one than `bare`: how much of it is, and of that how much
  /// lies beside the pixels that are said.
  struct Changed {
    std::size_t all = 0, beside = 0;
  };
  Changed changed(const Scene& scene, const Pixels& bare) {
    const Pixels picture = draw(scene);
    const auto boxes = tool_pixels(scene, view_, size).boxes();
    Changed changed;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const Colour a = pixel_at(bare, x, y), b = pixel_at(picture, x, y);
        if (a.red == b.red && a.green == b.green && a.blue == b.blue) continue;
        ++changed.all;
        const int row = size.height - 1 - y;
        const bool is_said = std::ranges::any_of(boxes, [&](const PixelBox& box) {
          return x >= box.left && x < box.right && row >= box.bottom && row < box.top;
        });
        changed.beside += is_said ? 0U : 1U;
      }
    }
    return changed;
  }

  Camera camera_;
  EyeView view_ = view_of(camera_, Viewer{}, Eye::Middle, aspect);
  Renderer renderer_{RenderQuality{}};
};

TEST_F(ToolPixels, HoldAllThatIsSeenOfAToolHoweverItIsHeld) {
  const Pixels bare = draw(Scene{});
  Random random(5);
  std::size_t seen = 0;
  for (int i = 0; i < 60; ++i) {
    const auto some = [&](double half) {
      return Vec3(random.uniform(-half, half), random.uniform(-half, half),
                  random.uniform(-half, half));
    };
    const RigidTransform pose{rotation_about(glm::normalize(some(1.0)), random.uniform(-3.0, 3.0)),
                              some(12.0)};
    // A handle that reaches beside the eye is left out.
    if (axis_x(pose).z > -0.2) continue;
    Scene scene;
    if (i % 4 == 0) scene.driver = DriverInScene{pose, simulator::WireDriver{}, true, 0.3 * i};
    if (i % 4 == 1) scene.driver = DriverInScene{pose, simulator::Drill{}, true, 0.3 * i};
    if (i % 4 == 2) scene.driver = DriverInScene{pose, simulator::Screwdriver{}};
    if (i % 4 == 3) scene.forceps = ForcepsInScene{pose, 0.5 * i};
    const Changed found = changed(scene, bare);
    seen += found.all;
    EXPECT_EQ(found.beside, 0U) << i;
  }
  EXPECT_GT(seen, 10000U);
}

TEST_F(ToolPixels, HoldWhatIsLeftInBone) {
  OperatingWorld world(0.9);
  world.saw_to(-4.0);
  Scene scene = world.scene();
  scene.saw.reset();
  const DrillLine line = drill_line(world, Vec3(15.0, 0.0, 0.0), Vec3(0.55, -0.75, 0.25));
  view_ = view_of(world.camera(), Viewer{}, Eye::Middle, aspect);
  const Pixels bare = draw(scene);
  for (const bool is_planned : {false, true}) {
    scene.implants = {{line.world_from_tool(8.0), simulator::Screwdriver{}, is_planned}};
    scene.holes = {hole_at(world, line, 1.35)};
    const Changed found = changed(scene, bare);
    EXPECT_GT(found.all, 200U);
    EXPECT_EQ(found.beside, 0U) << is_planned;
  }
}

TEST_F(ToolPixels, AreNoneWithoutTools) {
  EXPECT_TRUE(tool_pixels(Scene{}, view_, size).boxes().empty());
}

}  // namespace
}  // namespace hallux::tests

// Outlines, measured on pictures without a window: bone stands out from what lies behind it, and
// the bone beside it stands back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/ui/render/graphics.h"
#include "tests/ui/render/operating_world.h"
#include "ui/render/renderer.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr PixelSize size{640, 360};
/// Of a bone beside the one that is cut, as the operating view draws it.
constexpr double neighbour_presence = 0.45;

double shown_of(const Colour& colour) {
  return (0.2126 * colour.red + 0.7152 * colour.green + 0.0722 * colour.blue) / 255.0;
}

/// The channel that tells them best apart, 0 to 1.
double step_between(const Colour& one, const Colour& other) {
  return std::max({std::abs(one.red - other.red), std::abs(one.green - other.green),
                   std::abs(one.blue - other.blue)}) /
         255.0;
}

class Silhouettes : public Graphics {
 protected:
  Silhouettes() {
    scene_ = world_.scene();
    scene_.saw.reset();
    scene_.planes.clear();
    scene_.lines.clear();
    scene_.bones.front().presence = 1.0;
    scene_.bones.back().presence = neighbour_presence;
  }
  Pixels draw(const Scene& scene) {
    const RenderTarget target(size);
    renderer_.draw(scene, world_.camera(), target.target());
    return target.read();
  }
  Pixels draw_bones(std::vector<BoneInScene> bones) {
    Scene scene = scene_;
    scene.bones = std::move(bones);
    return draw(scene);
  }
  /// Steps in colour from the ground to three pixels into the bone, along its left and right.
  std::vector<double> steps_of(const BoneInScene& bone) {
    const Pixels ground = draw_bones({}), picture = draw_bones({bone});
    const auto step_at = [&](int x, int y) {
      return step_between(pixel_at(picture, x, y), pixel_at(ground, x, y));
    };
    std::vector<double> steps;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 3; x < size.width - 3; ++x) {
        for (const int in : {1, -1}) {
          const bool is_edge = step_at(x, y) == 0.0 && step_at(x + in, y) > 0.0;
          if (is_edge && step_at(x + 3 * in, y) > 0.0) steps.push_back(step_at(x + 3 * in, y));
        }
      }
    }
    return steps;
  }

  OperatingWorld world_{0.9};
  Scene scene_;
  Renderer renderer_{RenderQuality{}};
};

double low_of(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size()))];
}

TEST_F(Silhouettes, OfBoneStandOutFromTheGroundAllAround) {
  for (const Ground ground : {Ground::Dark, Ground::Light}) {
    scene_.ground = ground;
    const std::vector<double> steps = steps_of(scene_.bones.front());
    ASSERT_GT(steps.size(), 100U);
    EXPECT_GT(low_of(steps, 0.05), 0.10);
    EXPECT_GT(low_of(steps, 0.5), 0.30);
  }
}

TEST_F(Silhouettes, OfTheBoneBesideItStandAtFortyFivePercent) {
  for (const Ground ground : {Ground::Dark, Ground::Light}) {
    scene_.ground = ground;
    BoneInScene full = scene_.bones.back();
    full.presence = 1.0;
    const Pixels behind = draw_bones({}), whole = draw_bones({full}),
                 faint = draw_bones({scene_.bones.back()});
    double whole_sum = 0.0, faint_sum = 0.0;
    std::size_t count = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const Colour back = pixel_at(behind, x, y);
        const double step = shown_of(pixel_at(whole, x, y)) - shown_of(back);
        if (std::abs(step) < 0.02) continue;
        ++count;
        whole_sum += std::abs(step);
        faint_sum += std::abs(shown_of(pixel_at(faint, x, y)) - shown_of(back));
      }
    }
    ASSERT_GT(count, 500U);
    EXPECT_NEAR(faint_sum / whole_sum, neighbour_presence, 0.05);
  }
}

}  // namespace
}  // namespace hallux::tests

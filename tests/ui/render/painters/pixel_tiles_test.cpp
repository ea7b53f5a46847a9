#include "ui/render/painters/pixel_tiles.h"

#include <gtest/gtest.h>

#include <functional>

#include "simulator/base/random.h"
#include "ui/render/painters/tool_shadow.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr PixelSize size{333, 217};

bool is_inside(const std::vector<PixelBox>& boxes, int x, int y) {
  int count = 0;
  for (const PixelBox& box : boxes) {
    count += x >= box.left && x < box.right && y >= box.bottom && y < box.top ? 1 : 0;
  }
  EXPECT_LE(count, 1) << x << " " << y << " is drawn twice";
  return count == 1;
}

TEST(PixelTiles, HoldWhatWasAddedInBoxesThatDoNotOverlap) {
  Random random(11);
  for (int round = 0; round < 40; ++round) {
    PixelTiles tiles{size};
    std::vector<PixelBox> added;
    for (int i = 0; i < 6; ++i) {
      const int left = static_cast<int>(random.uniform(-20.0, 330.0));
      const int bottom = static_cast<int>(random.uniform(-20.0, 215.0));
      added.push_back({left, bottom, left + static_cast<int>(random.uniform(0.0, 60.0)),
                       bottom + static_cast<int>(random.uniform(0.0, 60.0))});
      tiles.add(added.back());
    }
    const std::vector<PixelBox> boxes = tiles.boxes();
    ASSERT_LE(boxes.size(), boxes_at_most);
    for (const PixelBox& box : boxes) EXPECT_EQ(common(box, all_of(size)), box);
    for (const PixelBox& box : added) {
      const PixelBox seen = common(box, all_of(size));
      for (int y = seen.bottom; y < seen.top; y += 7) {
        for (int x = seen.left; x < seen.right; x += 7) EXPECT_TRUE(is_inside(boxes, x, y));
      }
    }
  }
}

TEST(PixelTiles, OfNothingAreEmptyAndOfAllAreOneBox) {
  PixelTiles tiles{size};
  EXPECT_TRUE(tiles.boxes().empty());
  tiles.add(PixelBox{400, 300, 500, 310});
  EXPECT_TRUE(tiles.boxes().empty()) << "beside the picture";
  tiles.add(all_of(size));
  EXPECT_EQ(tiles.boxes(), std::vector{all_of(size)});
}

TEST(PixelTiles, InMorePiecesThanAreTakenBecomeOneBox) {
  constexpr PixelSize large{3840, 2160};
  PixelTiles tiles{large};
  for (int x = 0; x < large.width; x += 128) {
    for (int y = 0; y < large.height; y += 128) tiles.add(PixelBox{x, y, x + 1, y + 1});
  }
  ASSERT_EQ(tiles.boxes().size(), 1U);
  EXPECT_GT(pixel_count(tiles.boxes()), pixel_count(all_of(large)) / 2);
}

bool is_blade_shading(const ToolShadow& shadow, const Vec3& in_tool_mm) {
  const Vec3& key = shadow.key_in_tool;
  const double to_plane = -in_tool_mm.z / (std::abs(key.z) < 0.02 ? 0.02 : key.z);
  const Vec2 hit = Vec2(in_tool_mm) + to_plane * Vec2(key);
  const Vec2 outside =
      glm::max(Vec2(-shadow.blade_depth_mm - hit.x, -shadow.blade_half_width_mm - hit.y),
               Vec2(hit.x, hit.y - shadow.blade_half_width_mm));
  return to_plane >= 0.15 && std::max(outside.x, outside.y) < 0.25 + 0.10 * std::abs(to_plane);
}

/// As in shaders/tool_shadow.glsl, in double precision: whether any light is kept away.
bool is_shaded(const ToolShadow& shadow, const Vec3& in_tool_mm) {
  const Vec3& key = shadow.key_in_tool;
  const Vec2 across(in_tool_mm.y, in_tool_mm.z), way(key.y, key.z);
  const double along = std::max(-glm::dot(across, way) / std::max(glm::dot(way, way), 0.01), 0.0);
  const Vec3 passed = in_tool_mm + along * key;
  const auto distance_behind = [&](double from_x_mm) {
    return glm::length(Vec3(passed.y, passed.z, std::max(passed.x - from_x_mm, 0.0)));
  };
  const bool is_tip_shading =
      shadow.shaft_radius_mm > 0.0
          ? along >= 0.15 && distance_behind(0.0) - shadow.shaft_radius_mm < 0.12 + 0.10 * along
          : is_blade_shading(shadow, in_tool_mm);
  return is_tip_shading ||
         (along >= 0.5 && distance_behind(shadow.handpiece_from_mm) - 7.5 < 1.0 + 0.10 * along);
}

Vec3 within(Random& random, double half) {
  return Vec3(random.uniform(-half, half), random.uniform(-half, half),
              random.uniform(-half, half));
}

struct Balls {
  int touched = 0, said = 0;
};

/// Of 4000, each in another shadow of those: by how many it is touched, and of how many it is said.
Balls count_balls(const std::function<ToolShadow(const RigidTransform&, const Float3&)>& cast) {
  Random random(23);
  Balls balls;
  for (int i = 0; i < 4000; ++i) {
    const RigidTransform world_from_tool{
        rotation_about(glm::normalize(within(random, 1.0)), random.uniform(-3.0, 3.0)),
        within(random, 20.0)};
    const ToolShadow shadow = cast(world_from_tool, to_float(glm::normalize(within(random, 1.0))));
    const Vec3 middle = within(random, 30.0);
    const double radius_mm = random.uniform(0.1, 4.0);
    bool is_touched = false;
    for (int k = 0; k < 30 && !is_touched; ++k) {
      const Vec3 step = glm::normalize(within(random, 1.0)) * random.uniform(0.0, radius_mm);
      is_touched = is_shaded(shadow, middle + step);
    }
    const bool is_said = may_shade(shadow, middle, radius_mm);
    EXPECT_TRUE(is_said || !is_touched) << i;
    balls.touched += is_touched ? 1 : 0;
    balls.said += is_said ? 1 : 0;
  }
  return balls;
}

TEST(ToolShadow, IsSaidOfEveryBallThatItTouchesAndNotOfAll) {
  const Balls balls = count_balls([](const RigidTransform& world_from_tool, const Float3& light) {
    SawInScene saw;
    saw.world_from_tool = world_from_tool;
    saw.blade = {.width_mm = 9.0, .depth_mm = 25.0};
    return tool_shadow(saw, light);
  });
  EXPECT_GT(balls.touched, 200);
  EXPECT_LT(balls.said, 3000) << "a test that says yes to everything lights everything anew";
}

TEST(ToolShadow, OfADriverIsSaidOfEveryBallThatItTouchesAndNotOfAll) {
  const Balls balls = count_balls([](const RigidTransform& world_from_tool, const Float3& light) {
    return tool_shadow(DriverInScene{world_from_tool, simulator::Drill{.bit = {.length_mm = 30.0}}},
                       light);
  });
  EXPECT_GT(balls.touched, 100);
  EXPECT_LT(balls.said, 3000);
}

TEST(ToolShadow, IsTheSawsWhereThereIsADriverToo) {
  Scene scene;
  EXPECT_FALSE(tool_shadow(scene, Float3(0.0F, 1.0F, 0.0F)));
  EXPECT_EQ(world_from_shading_tool(scene), nullptr);
  scene.driver = DriverInScene{};
  EXPECT_GT(tool_shadow(scene, Float3(0.0F, 1.0F, 0.0F))->shaft_radius_mm, 0.0);
  EXPECT_EQ(world_from_shading_tool(scene), &scene.driver->world_from_tool);
  scene.saw = SawInScene{};
  EXPECT_EQ(tool_shadow(scene, Float3(0.0F, 1.0F, 0.0F))->shaft_radius_mm, 0.0);
  EXPECT_EQ(world_from_shading_tool(scene), &scene.saw->world_from_tool);
}

}  // namespace
}  // namespace hallux::tests

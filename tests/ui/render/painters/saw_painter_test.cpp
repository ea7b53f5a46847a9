#include "ui/render/painters/saw_painter.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "simulator/base/random.h"
#include "ui/render/scene/swarf.h"

namespace hallux::tests {
namespace {

using namespace ui;

bool holds(const Box& box, const Vec3& point_mm) {
  return glm::all(glm::lessThanEqual(box.low_mm, point_mm)) &&
         glm::all(glm::lessThanEqual(point_mm, box.high_mm));
}

// Only there is it drawn translucent: what stood outside would be missing from the picture.
TEST(SawPainter, AllThatIsSeenThroughLiesInItsBox) {
  constexpr double seen_through_within_mm = 19.0, nearer_by_mm = 2.0;  // as in tool.frag
  SawInScene saw;
  saw.blade = {.width_mm = 12.0, .depth_mm = 25.0, .kerf_mm = 0.5};
  const ToolMesh handpiece = handpiece_mesh(saw.blade);
  Random random(9);
  std::size_t seen_through = 0, whole = 0;
  for (int i = 0; i < 400; ++i) {
    const auto some = [&](double half) {
      return Vec3(random.uniform(-half, half), random.uniform(-half, half),
                  random.uniform(-half, half));
    };
    saw.world_from_tool = {rotation_about(glm::normalize(some(1.0)), random.uniform(-3.0, 3.0)),
                           some(30.0)};
    const Vec3 eye_mm = saw.world_from_tool.translation_mm + some(160.0);
    const Vec3 to_teeth = glm::normalize(saw.world_from_tool.translation_mm - eye_mm);
    const Box box = before_the_teeth(saw, eye_mm);
    whole += box.is_empty() ? 1U : 0U;
    for (const ToolVertex& vertex : handpiece.vertices) {
      const Vec3 point_in_tool_mm(vertex.point_in_tool_mm);
      const Vec3 from_teeth = transform_direction(saw.world_from_tool, point_in_tool_mm);
      if (-glm::dot(from_teeth, to_teeth) < nearer_by_mm ||
          glm::length(glm::cross(from_teeth, to_teeth)) > seen_through_within_mm) {
        continue;
      }
      ++seen_through;
      ASSERT_TRUE(holds(box, point_in_tool_mm)) << i;
    }
  }
  EXPECT_GT(seen_through, 1000U);
  EXPECT_GT(whole, 50U);
}

TEST(Swarf, IsTheSameForTheSameSeedAndEnds) {
  Swarf first(4), second(4);
  const SwarfSource source{{}, 10.0, 12.0, false};
  for (int i = 0; i < 60; ++i) {
    first.advance(1.0 / 60.0, source);
    second.advance(1.0 / 60.0, source);
  }
  ASSERT_GT(first.chips().size(), 50U);
  ASSERT_LE(first.chips().size(), Swarf::chips_at_most);
  ASSERT_EQ(first.chips().size(), second.chips().size());
  for (std::size_t i = 0; i < first.chips().size(); ++i) {
    EXPECT_EQ(first.chips()[i].place_mm, second.chips()[i].place_mm);
  }
  for (int i = 0; i < 20; ++i) first.advance(0.1, {});
  EXPECT_TRUE(first.chips().empty());
}

}  // namespace
}  // namespace hallux::tests

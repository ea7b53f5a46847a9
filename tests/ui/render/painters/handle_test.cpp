#include "ui/render/painters/handle.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "simulator/base/random.h"
#include "ui/render/scene/driver_model.h"
#include "ui/render/scene/forceps_model.h"
#include "ui/render/scene/tool_model.h"

namespace hallux::tests {
namespace {

using namespace ui;

bool holds(const Box& box, const Vec3& point_mm) {
  return glm::all(glm::lessThanEqual(box.low_mm, point_mm)) &&
         glm::all(glm::lessThanEqual(point_mm, box.high_mm));
}

/// Only in its box a handle is drawn translucent: what stood outside would be missing from the
/// picture. So in many poses all that gives way lies in the box, and often enough something does.
/// Returns in how many of 400 poses all of it is whole.
std::size_t expect_boxed(const std::vector<Vec3>& points_in_tool_mm,
                         const std::function<Handle(const RigidTransform&)>& handle_at) {
  Random random(9);
  std::size_t seen_through = 0, outside = 0, whole = 0;
  for (int i = 0; i < 400; ++i) {
    const auto some = [&](double half) {
      return Vec3(random.uniform(-half, half), random.uniform(-half, half),
                  random.uniform(-half, half));
    };
    const RigidTransform world_from_tool{
        rotation_about(glm::normalize(some(1.0)), random.uniform(-3.0, 3.0)), some(30.0)};
    const Vec3 eye_mm = world_from_tool.translation_mm + some(160.0);
    const Vec3 to_tip = glm::normalize(world_from_tool.translation_mm - eye_mm);
    const Handle handle = handle_at(world_from_tool);
    const Box box = before_the_tip(handle, eye_mm);
    whole += box.is_empty() ? 1U : 0U;
    for (const Vec3& point_mm : points_in_tool_mm) {
      const Vec3 from_tip = transform_direction(world_from_tool, point_mm);
      if (-glm::dot(from_tip, to_tip) < handle.keeps_mm ||
          glm::length(glm::cross(from_tip, to_tip)) > whole_beyond_mm) {
        continue;
      }
      ++seen_through;
      outside += holds(box, point_mm) ? 0U : 1U;
    }
  }
  EXPECT_EQ(outside, 0U);
  EXPECT_GT(seen_through, 100U);
  return whole;
}

void add_points(std::vector<Vec3>& points_mm, const ToolMesh& mesh,
                const RigidTransform& tool_from_part = {}) {
  for (const ToolVertex& vertex : mesh.vertices)
    points_mm.push_back(transform_point(tool_from_part, Vec3(vertex.point_in_tool_mm)));
}

TEST(Handle, AllThatIsSeenThroughOfASawLiesInItsBox) {
  SawInScene saw;
  saw.blade = {.width_mm = 12.0, .depth_mm = 25.0, .kerf_mm = 0.5};
  std::vector<Vec3> points_mm;
  add_points(points_mm, handpiece_mesh(saw.blade));
  const std::size_t whole = expect_boxed(points_mm, [&](const RigidTransform& world_from_tool) {
    saw.world_from_tool = world_from_tool;
    return handle_of(saw);
  });
  EXPECT_GT(whole, 50U);
}

TEST(Handle, AllThatIsSeenThroughOfADriverLiesInItsBox) {
  simulator::WireDriver wire;
  wire.wire.length_mm = 60.0;
  for (const simulator::Tool& tool :
       {simulator::Tool(wire), simulator::Tool(simulator::Drill{.bit = {.length_mm = 30.0}}),
        simulator::Tool(simulator::Screwdriver{})}) {
    std::vector<Vec3> points_mm, held_mm;
    add_points(points_mm, chuck_mesh(tool));
    add_points(points_mm, driver_body_mesh(tool));
    add_points(held_mm, held_mesh(tool));
    const std::size_t whole = expect_boxed(points_mm, [&](const RigidTransform& world_from_tool) {
      return handle_of(DriverInScene{world_from_tool, tool});
    });
    EXPECT_GT(whole, 50U);
    const std::size_t held = expect_boxed(held_mm, [&](const RigidTransform& world_from_tool) {
      return held_of(DriverInScene{world_from_tool, tool});
    });
    EXPECT_GT(held, 100U);
  }
}

TEST(Handle, AllThatIsSeenThroughOfForcepsLiesInItsBox) {
  for (const double opening_mm : {0.0, 12.0, 45.0}) {
    const RigidTransform first = tool_from_arm(opening_mm);
    std::vector<Vec3> points_mm;
    add_points(points_mm, forceps_handle_mesh(), first);
    add_points(points_mm, mirrored_in_y(forceps_handle_mesh()),
               {glm::conjugate(first.rotation), first.translation_mm});
    expect_boxed(points_mm, [&](const RigidTransform& world_from_tool) {
      return handle_of(ForcepsInScene{world_from_tool, opening_mm});
    });
  }
}

}  // namespace
}  // namespace hallux::tests

#include "ui/render/scene/forceps_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/ui/render/scene/tool_mesh_checks.h"

namespace hallux::tests {
namespace {

using namespace ui;

TEST(ForcepsModel, AllPartsAreClosedAlsoInTheMirror) {
  for (const ToolMesh& mesh : {jaw_mesh(), forceps_handle_mesh()}) {
    EXPECT_EQ(flaw_of(mesh, 3000), "");
    EXPECT_EQ(flaw_of(mirrored_in_y(mesh), 3000), "");
  }
}

TEST(ForcepsModel, ThePointsAreAsFarApartAsItIsOpen) {
  const auto point_of = [](double opening_mm) {
    return transform_point(tool_from_arm(opening_mm), Vec3(jaw_length_mm, 0.0, 0.0));
  };
  for (const double opening_mm : {0.0, 1.0, 8.0, 20.0, 45.0}) {
    const Vec3 point_mm = point_of(opening_mm);
    EXPECT_NEAR(point_mm.x, 0.0, 1.0e-9);
    EXPECT_NEAR(point_mm.y, 0.5 * opening_mm, 1.0e-9);
  }
  EXPECT_EQ(point_of(80.0), point_of(forceps_opening_most_mm));
  // The jaw's mesh ends there.
  double farthest_mm = 0.0, nearest_mm = 9.0;
  for (const ToolVertex& vertex : jaw_mesh().vertices) {
    const Vec3 off_mm = Vec3(vertex.point_in_tool_mm) - Vec3(jaw_length_mm, 0.0, 0.0);
    nearest_mm = std::min(nearest_mm, glm::length(off_mm));
    farthest_mm = std::max(farthest_mm, off_mm.x);
  }
  EXPECT_LT(nearest_mm, 0.1);
  EXPECT_LT(farthest_mm, 1.5) << "it comes to the point from beside, not from before";
}

TEST(ForcepsModel, KeepsWithinItsSizes) {
  for (const ToolVertex& vertex : forceps_handle_mesh().vertices) {
    EXPECT_GE(vertex.point_in_tool_mm.x, -forceps_handle_mm);
    EXPECT_GE(vertex.point_in_tool_mm.y, -forceps_arm_half_mm);
    EXPECT_LE(vertex.point_in_tool_mm.y, 5.0F);
  }
  for (const ToolVertex& vertex : jaw_mesh().vertices) {
    EXPECT_LE(vertex.point_in_tool_mm.y, jaw_half_mm);
    EXPECT_GE(vertex.point_in_tool_mm.y, -5.0F);
    EXPECT_LE(std::abs(vertex.point_in_tool_mm.z), forceps_half_thickness_mm);
  }
}

}  // namespace
}  // namespace hallux::tests

#include "ui/render/scene/driver_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/base/units.h"
#include "tests/ui/render/scene/tool_mesh_checks.h"
#include "ui/render/scene/screw_model.h"

namespace hallux::tests {
namespace {

using namespace ui;
using namespace simulator;

double radius_of(const ToolVertex& vertex) {
  return std::hypot(vertex.point_in_tool_mm.y, vertex.point_in_tool_mm.z);
}
double angle_of(const ToolVertex& vertex) {
  return std::atan2(vertex.point_in_tool_mm.z, vertex.point_in_tool_mm.y);
}

/// Between -0.5 and 0.5: how far the vertex is from a right-handed helix about x, in shares of its
/// way in a turn.
double off_helix(const ToolVertex& vertex, double lead_mm, double start) {
  const double share = vertex.point_in_tool_mm.x / lead_mm - angle_of(vertex) / (2.0 * pi) - start;
  return share - std::round(share);
}

const std::array<Tool, 3> drivers{WireDriver{}, Drill{}, Screwdriver{}};

TEST(DriverModel, AllPartsAreClosedWithTheirNormalsOutsideAndFewTriangles) {
  for (const Tool& tool : drivers) {
    EXPECT_EQ(flaw_of(held_mesh(tool), 6500), "") << tool.index();
    EXPECT_EQ(flaw_of(chuck_mesh(tool)), "") << tool.index();
    EXPECT_EQ(flaw_of(driver_body_mesh(tool)), "") << tool.index();
  }
  EXPECT_EQ(flaw_of(blur_mesh(Drill{})), "");
  EXPECT_TRUE(blur_mesh(WireDriver{}).triangles.empty());
}

TEST(DriverModel, WiresAndBitsOfAllSizesAreClosed) {
  for (const double diameter_mm : wire_diameters_mm) {
    for (const double point : {0.5, 1.0, 4.0}) {
      const Wire wire{diameter_mm, 50.0, point * diameter_mm};
      ASSERT_TRUE(is_made(wire));
      EXPECT_EQ(flaw_of(wire_mesh(wire)), "") << diameter_mm << " " << point;
    }
  }
  for (const double diameter_mm : drill_diameters_mm) {
    for (const double point : {0.0, 0.3, 0.87}) {
      for (const double length_mm : {30.0, 150.0}) {
        const DrillBit bit{diameter_mm, length_mm, point * diameter_mm};
        ASSERT_TRUE(is_made(bit));
        EXPECT_EQ(flaw_of(held_mesh(simulator::Drill{.bit = bit})), "")
            << diameter_mm << " " << point;
      }
    }
  }
}

TEST(DriverModel, AWireHasAPointOfThreeFlatFacets) {
  const Wire wire{1.6, 120.0, 3.0};
  const ToolMesh mesh = wire_mesh(wire);
  double back_mm = 0.0, front_mm = -1.0;
  for (const ToolVertex& vertex : mesh.vertices) {
    back_mm = std::min(back_mm, static_cast<double>(vertex.point_in_tool_mm.x));
    front_mm = std::max(front_mm, static_cast<double>(vertex.point_in_tool_mm.x));
    EXPECT_LE(radius_of(vertex), 0.8 + 1.0e-5);
  }
  EXPECT_NEAR(front_mm, 0.0, 1.0e-6);
  EXPECT_NEAR(back_mm, -120.0, 1.0e-6);
  // What leans forward, by area.
  const double lean = 0.8 / std::hypot(0.8, 3.0);
  std::array<double, 3> facets_mm2{};
  double other_mm2 = 0.0;
  for (const Triangle& triangle : mesh.triangles) {
    std::array<Vec3, 3> points_mm;
    for (std::size_t i = 0; i < 3; ++i)
      points_mm[i] = Vec3(mesh.vertices[triangle[i]].point_in_tool_mm);
    const Vec3 twice = glm::cross(points_mm[1] - points_mm[0], points_mm[2] - points_mm[0]);
    const double area_mm2 = 0.5 * glm::length(twice);
    if (area_mm2 < 1.0e-9 || twice.x < 0.2 * area_mm2) continue;
    const double turns = std::atan2(twice.z, twice.y) / (2.0 * pi) * 3.0;
    const auto facet = static_cast<std::size_t>(std::lround(turns) + 3) % 3;
    const bool is_flat = std::abs(turns - std::round(turns)) < 1.0e-3 &&
                         std::abs(twice.x / (2.0 * area_mm2) - lean) < 1.0e-3;
    (is_flat ? facets_mm2[facet] : other_mm2) += area_mm2;
  }
  for (const double facet_mm2 : facets_mm2) EXPECT_NEAR(facet_mm2, facets_mm2[0], 1.0e-3);
  EXPECT_GT(facets_mm2[0], 1.0);
  EXPECT_LT(other_mm2, 0.05 * facets_mm2[0]);
}

TEST(DriverModel, ABitHasTwoRightHandedFlutes) {
  const DrillBit bit{2.0, 60.0, 0.6};
  const double lead_mm = pi * 2.0 * std::sqrt(3.0);
  std::size_t deep = 0;
  double start = 0.0, least_mm = 1.0;
  for (const ToolVertex& vertex : held_mesh(simulator::Drill{.bit = bit}).vertices) {
    const double x_mm = vertex.point_in_tool_mm.x;
    EXPECT_LE(radius_of(vertex), 1.0 + 1.0e-5);
    if (x_mm < -20.0 || x_mm > -1.0) continue;
    least_mm = std::min(least_mm, radius_of(vertex));
    if (radius_of(vertex) > 0.36) continue;
    if (deep++ == 0) start = off_helix(vertex, lead_mm, 0.0);
    // The other flute lies half a turn on.
    const double off = 2.0 * off_helix(vertex, lead_mm, start);
    EXPECT_NEAR(off, std::round(off), 0.2) << x_mm;
  }
  EXPECT_GT(deep, 100U);
  EXPECT_GT(least_mm, 0.25);
}

TEST(DriverModel, ChuckAndBodyLieBehindWhatTheyHold) {
  for (const Tool& tool : drivers) {
    const double chuck_mm = chuck_x_mm(tool);
    EXPECT_LT(chuck_mm, -20.0);
    double back_mm = 0.0;
    for (const ToolMesh& mesh : {chuck_mesh(tool), driver_body_mesh(tool)}) {
      for (const ToolVertex& vertex : mesh.vertices) {
        const Float3& point_mm = vertex.point_in_tool_mm;
        EXPECT_LE(point_mm.x, chuck_mm + 2.01);
        EXPECT_LE(std::abs(point_mm.y), driver_half_y_mm + 1.0e-4);
        EXPECT_LE(std::abs(point_mm.z), driver_half_z_mm);
        back_mm = std::min(back_mm, static_cast<double>(point_mm.x));
      }
    }
    EXPECT_GE(back_mm, chuck_mm - driver_length_mm - 1.0e-3);
  }
}

TEST(ScrewModel, AllSizesAreClosed) {
  for (Screw screw : cortical_screws) {
    for (const double length_mm : {6.0, 20.0, 80.0}) {
      for (const bool is_self_drilling : {false, true}) {
        screw.length_mm = length_mm;
        screw.is_self_drilling = is_self_drilling;
        ASSERT_TRUE(is_made(screw));
        EXPECT_EQ(flaw_of(screw_mesh(screw)), "") << screw.thread_diameter_mm << " " << length_mm;
      }
    }
  }
  const Screw headless{3.0, 2.0, 2.1, 3.0, 3.0, 0.0, 0.4, 40.0};
  ASSERT_TRUE(is_made(headless));
  EXPECT_EQ(flaw_of(screw_mesh(headless)), "");
}

TEST(ScrewModel, TheThreadIsARightHandedHelixOfItsPitchBetweenItsDiameters) {
  for (const Screw& screw : cortical_screws) {
    std::size_t crest = 0;
    double start = 0.0, least_mm = 9.0, most_mm = 0.0;
    for (const ToolVertex& vertex : screw_mesh(screw).vertices) {
      const double x_mm = vertex.point_in_tool_mm.x, radius_mm = radius_of(vertex);
      if (x_mm < -16.0 || x_mm > -8.0) continue;
      least_mm = std::min(least_mm, radius_mm);
      most_mm = std::max(most_mm, radius_mm);
      if (radius_mm < 0.499 * screw.thread_diameter_mm) continue;
      if (crest++ == 0) start = off_helix(vertex, screw.pitch_mm, 0.0);
      EXPECT_NEAR(off_helix(vertex, screw.pitch_mm, start), 0.0, 0.13) << x_mm;
    }
    EXPECT_GT(crest, 100U);
    EXPECT_NEAR(most_mm, 0.5 * screw.thread_diameter_mm, 1.0e-5);
    EXPECT_NEAR(least_mm, 0.5 * screw.shaft_diameter_mm, 1.0e-5);
  }
}

TEST(ScrewModel, TheHeadHasItsSizesAndAHexagon) {
  const Screw screw;
  const HexagonSize hexagon = hexagon_of(screw);
  double widest_mm = 0.0, back_mm = 0.0;
  std::size_t floor = 0;
  for (const ToolVertex& vertex : screw_mesh(screw).vertices) {
    const double x_mm = vertex.point_in_tool_mm.x;
    back_mm = std::min(back_mm, x_mm);
    widest_mm = std::max(widest_mm, radius_of(vertex));
    if (vertex.material != static_cast<float>(ToolMaterial::Grip)) continue;
    ++floor;
    EXPECT_LE(radius_of(vertex), hexagon.across_mm / std::sqrt(3.0) + 1.0e-5);
    EXPECT_LE(x_mm, -screw.length_mm - screw.head_height_mm + hexagon.depth_mm + 1.0e-5);
  }
  EXPECT_GT(floor, 6U);
  EXPECT_NEAR(widest_mm, 0.5 * screw.head_diameter_mm, 1.0e-5);
  EXPECT_NEAR(back_mm, -screw.length_mm - screw.head_height_mm, 1.0e-5);
  EXPECT_EQ(hexagon_mm(2.0, 24).size(), 24U);
  for (const Vec2& point_mm : hexagon_mm(2.0, 24)) {
    EXPECT_GE(glm::length(point_mm), 1.0 - 1.0e-9);
    EXPECT_LE(glm::length(point_mm), 2.0 / std::sqrt(3.0) + 1.0e-9);
  }
}

}  // namespace
}  // namespace hallux::tests

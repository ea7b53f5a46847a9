#include "simulator/cutting/slice/slab_slice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "simulator/cutting/slice/slab_query.h"
#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/simulator/cutting/worlds/random_worlds.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

SlabSlice contact_of(const CutSolid& solid, const KerfPlane& plane) {
  return slice_slab(solid, Bvh(solid.mesh), plane, 0, Vec2(-40.0), Vec2(40.0));
}

double area_mm2(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = glm::cross(b - a, c - a);
  return 0.5 * std::sqrt(glm::dot(normal, normal));
}

/// The area that the contact's parts of a touched triangle cover together.
double area_of_parts_mm2(const SlabSlice& contact, const IndexedMesh& mesh, std::uint32_t touched) {
  double sum_mm2 = 0.0;
  const auto place = [&](std::uint32_t point) { return contact.points[point].point_in_bone_mm; };
  for (const StripTriangle& strip : contact.triangles) {
    if (strip.touched != touched) continue;
    sum_mm2 += area_mm2(place(strip.points[0]), place(strip.points[1]), place(strip.points[2]));
  }
  for (const OuterPart& part : contact.outer_parts) {
    if (part.touched != touched) continue;
    const StripEdge& edge = contact.edges[part.edge];
    const Vec3 &first = mesh.points_mm[part.corners[0]],
               &last = mesh.points_mm[part.corners[part.corner_count - 1U]];
    sum_mm2 += area_mm2(place(edge.a), first, place(edge.b));
    if (part.corner_count == 2) sum_mm2 += area_mm2(first, last, place(edge.b));
  }
  return sum_mm2;
}

/// How often a strip edge is walked in its direction, and against it.
struct Walks {
  int along = 0, against = 0;
};

std::vector<Walks> walks_of(const SlabSlice& contact) {
  std::vector<Walks> walks(contact.edges.size());
  for (const StripTriangle& triangle : contact.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const StripEdge& edge = contact.edges[triangle.edges[k]];
      const std::uint32_t from = triangle.points[k], to = triangle.points[(k + 1) % 3];
      if (edge.a == from && edge.b == to) {
        EXPECT_TRUE(triangle.runs_along[k]);
        ++walks[triangle.edges[k]].along;
      } else {
        EXPECT_TRUE(edge.a == to && edge.b == from && !triangle.runs_along[k]);
        ++walks[triangle.edges[k]].against;
      }
    }
  }
  return walks;
}

TEST(SlabSlice, EveryStripEdgeHasTwoSidesAndEveryContourEdgeOne) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const CutSolid solid = uncut_solid(seed % 2 == 0 ? random_bone(random) : lattice_bone(random));
    const SlabSlice contact =
        contact_of(solid, seed % 2 == 0 ? random_plane(random) : lattice_plane(random));
    const std::vector<Walks> walks = walks_of(contact);
    std::vector<int> parts_of_edge(contact.edges.size(), 0);
    for (const OuterPart& part : contact.outer_parts) ++parts_of_edge[part.edge];
    for (std::size_t i = 0; i < walks.size(); ++i) {
      const bool is_contour = contact.edges[i].level != 0;
      ASSERT_EQ(walks[i].along, 1) << "seed " << seed;
      ASSERT_EQ(walks[i].against, is_contour ? 0 : 1) << "seed " << seed;
      ASSERT_EQ(parts_of_edge[i], is_contour ? 1 : 0) << "seed " << seed;
    }
  }
}

TEST(SlabSlice, ContourPointsLieOnThePlanesAndAllOthersBetween) {
  Random random(4);
  const CutSolid solid = uncut_solid(random_bone(random));
  const KerfPlane plane = random_plane(random);
  const SlabSlice contact = contact_of(solid, plane);
  ASSERT_FALSE(contact.points.empty());
  const double half_mm = 0.5 * plane.thickness_mm;
  for (const StripPoint& point : contact.points) {
    const double height = height_mm(contact.axes, point.point_in_bone_mm);
    if (point.base_point == no_index) {
      EXPECT_NEAR(std::abs(height), half_mm, 1e-12);
    } else {
      EXPECT_EQ(point.point_in_bone_mm, solid.mesh.points_mm[point.base_point]);
      EXPECT_TRUE(height >= -half_mm && height < half_mm);
    }
  }
}

TEST(SlabSlice, StripAndOuterPartsTogetherAreTheTouchedTriangles) {
  Random random(9);
  const CutSolid solid = uncut_solid(random_bone(random));
  const SlabSlice contact = contact_of(solid, random_plane(random));
  ASSERT_FALSE(contact.touched.empty());
  for (std::uint32_t i = 0; i < contact.touched.size(); ++i) {
    const Triangle& corners = solid.mesh.triangles[contact.touched[i].base_triangle];
    const double whole_mm2 =
        area_mm2(solid.mesh.points_mm[corners[0]], solid.mesh.points_mm[corners[1]],
                 solid.mesh.points_mm[corners[2]]);
    EXPECT_NEAR(area_of_parts_mm2(contact, solid.mesh, i), whole_mm2, 1e-12 * (1.0 + whole_mm2));
  }
}

TEST(SlabSlice, ContoursRunCounterClockwiseAroundBoneBelowAndClockwiseAbove) {
  const CutSolid solid = uncut_solid(hollow_tube({.segments = 12}));
  const SlabSlice contact = contact_of(solid, axis_plane(0, 0.1, 0.5));
  EXPECT_EQ(contact.skin_count, 2U);
  std::map<std::int8_t, double> doubled_area;
  for (const StripEdge& edge : contact.edges) {
    const Vec2 a = place_mm(contact.axes, contact.points[edge.a].point_in_bone_mm);
    const Vec2 b = place_mm(contact.axes, contact.points[edge.b].point_in_bone_mm);
    doubled_area[edge.level] += a.x * b.y - a.y * b.x;
  }
  // A regular polygon of 12 corners on the radius r has the area 3 r^2.
  EXPECT_NEAR(0.5 * doubled_area[-1], 3.0 * (64.0 - 25.0), 1e-9);
  EXPECT_NEAR(0.5 * doubled_area[1], -3.0 * (64.0 - 25.0), 1e-9);
}

TEST(SlabSlice, APlaneThatMissesTouchesNothing) {
  const SlabSlice contact =
      contact_of(uncut_solid(solid_block(Vec3(10.0))), axis_plane(2, 5.3, 0.5));
  EXPECT_TRUE(contact.touched.empty());
  EXPECT_TRUE(contact.points.empty());
  EXPECT_EQ(contact.skin_count, 0U);
}

// What a frame costs is counted, not timed: nothing in the contact knows of bone elsewhere.
TEST(SlabSlice, FarTrianglesChangeNothing) {
  const IndexedMesh near = hollow_tube({.segments = 24, .rings = 6});
  IndexedMesh both = near;
  append_mesh(both,
              moved(dense_sphere(9.0, 100'000), {Quat(1.0, 0.0, 0.0, 0.0), Vec3(60.0, 0.0, 0.0)}));
  const KerfPlane plane = plane_through(Vec3(1.0, 0.0, 0.0), Vec3(1.0, 0.2, 0.1), 0.5);
  const SlabSlice alone = contact_of(uncut_solid(near), plane);
  const SlabSlice together = contact_of(uncut_solid(both), plane);
  ASSERT_EQ(alone.touched.size(), together.touched.size());
  for (std::size_t i = 0; i < alone.touched.size(); ++i) {
    EXPECT_EQ(alone.touched[i].base_triangle, together.touched[i].base_triangle);
  }
  EXPECT_EQ(alone.points.size(), together.points.size());
  EXPECT_EQ(alone.edges.size(), together.edges.size());
  EXPECT_EQ(alone.triangles.size(), together.triangles.size());
  EXPECT_EQ(alone.outer_parts.size(), together.outer_parts.size());
  EXPECT_EQ(alone.skin_count, together.skin_count);
}

TEST(SlabQuery, APointOnTheUpperPlaneIsAboveAndOneOnTheLowerInside) {
  EXPECT_EQ(slab_part(0.25, 0.25), SlabPart::Above);
  EXPECT_EQ(slab_part(-0.25, 0.25), SlabPart::Inside);
  EXPECT_EQ(slab_part(-0.2500001, 0.25), SlabPart::Below);
  const IndexedMesh block = solid_block(Vec3(10.0));
  // The upper face of the block lies on the slab's lower plane, then on its upper one.
  EXPECT_FALSE(
      triangles_reaching_slab(block, Bvh(block), axes_of(axis_plane(2, 5.25, 0.5)), 0.25).empty());
  EXPECT_FALSE(
      triangles_reaching_slab(block, Bvh(block), axes_of(axis_plane(2, 4.75, 0.5)), 0.25).empty());
  EXPECT_TRUE(
      triangles_reaching_slab(block, Bvh(block), axes_of(axis_plane(2, -5.25, 0.5)), 0.25).empty());
}

TEST(SlabQuery, ASkinNamesEachCornerOfTheTrianglesOnceAndKnowsItsHeight) {
  const IndexedMesh tube = hollow_tube({.segments = 24, .rings = 8});
  const Bvh bvh(tube);
  const KerfAxes axes = axes_of(plane_through(Vec3(0.1), Vec3(0.3, 0.4, 1.0), 0.5));
  const SlabSkin skin = gather_slab_skin(tube, bvh, axes, 0.25);
  ASSERT_FALSE(skin.triangles.empty());
  EXPECT_EQ(skin.triangles, triangles_reaching_slab(tube, bvh, axes, 0.25));
  ASSERT_EQ(skin.corners.size(), skin.triangles.size());
  std::set<std::uint32_t> named;
  for (const SlabCorner& corner : skin.points) {
    EXPECT_TRUE(named.insert(corner.base_point).second);
    EXPECT_EQ(corner.point_in_bone_mm, tube.points_mm[corner.base_point]);
    EXPECT_EQ(corner.height_mm, height_mm(axes, corner.point_in_bone_mm));
    EXPECT_EQ(corner.part, slab_part(corner.height_mm, 0.25));
  }
  std::set<std::uint32_t> used;
  for (std::size_t i = 0; i < skin.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t base_point = skin.points[skin.corners[i][k]].base_point;
      EXPECT_EQ(base_point, tube.triangles[skin.triangles[i]][k]);
      used.insert(base_point);
    }
  }
  EXPECT_EQ(used, named);
}

}  // namespace
}  // namespace hallux::tests

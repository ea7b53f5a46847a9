#include "simulator/cutting/fill/ring_filler.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

namespace hallux::tests {
namespace {

using namespace simulator;

/// Corners in the lattice's plane, at height 0.
std::vector<LatticeCorner> flat(const std::vector<LatticePoint>& places) {
  std::vector<LatticeCorner> corners;
  corners.reserve(places.size());
  for (const LatticePoint& place : places) corners.push_back({place, 0});
  return corners;
}

void add_ring(RingFiller& filler, const std::vector<std::uint32_t>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) filler.add(ring[i], ring[(i + 1) % ring.size()]);
}

/// Directed edges less the opposite ones.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> border_of(
    const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> border;
  for (const Triangle& corners : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
      if (from < to) ++border[{from, to}];
      if (from > to) --border[{to, from}];
    }
  }
  std::erase_if(border, [](const auto& entry) { return entry.second == 0; });
  return border;
}

std::int64_t doubled_area(const std::vector<LatticeCorner>& corners,
                          const std::vector<Triangle>& triangles) {
  std::int64_t sum = 0;
  for (const Triangle& triangle : triangles) {
    sum += turn(corners[triangle[0]].place, corners[triangle[1]].place, corners[triangle[2]].place);
  }
  return sum;
}

TEST(RingFiller, FillsARingWhateverTheOrderOfItsEdges) {
  const std::vector<LatticeCorner> corners = flat({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
  RingFiller filler;
  filler.begin();
  for (const auto& [from, to] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
           {3, 4}, {0, 1}, {4, 0}, {2, 3}, {1, 2}}) {
    filler.add(from, to);
  }
  std::vector<Triangle> triangles;
  ASSERT_TRUE(filler.fill(corners, FaceView::UV, triangles));
  EXPECT_EQ(triangles.size(), 3U);
  EXPECT_EQ(doubled_area(corners, triangles), 20);
  EXPECT_EQ(border_of(triangles).size(), 5U);
}

TEST(RingFiller, LeavesHolesOpen) {
  const std::vector<LatticeCorner> corners =
      flat({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {3, 3}, {3, 6}, {6, 6}, {6, 3}});
  RingFiller filler;
  filler.begin();
  add_ring(filler, {0, 1, 2, 3});
  add_ring(filler, {4, 5, 6, 7});
  std::vector<Triangle> triangles;
  ASSERT_TRUE(filler.fill(corners, FaceView::UV, triangles));
  EXPECT_EQ(doubled_area(corners, triangles), 2 * (81 - 9));
  EXPECT_EQ(border_of(triangles).size(), 8U);
}

TEST(RingFiller, RingsThatMeetInAPointAreFilledAsTheyAre) {
  const std::vector<LatticeCorner> corners = flat({{0, 0}, {2, -1}, {2, 1}, {-2, 1}, {-2, -1}});
  RingFiller filler;
  filler.begin();
  add_ring(filler, {0, 1, 2, 0, 3, 4});
  std::vector<Triangle> triangles;
  ASSERT_TRUE(filler.fill(corners, FaceView::UV, triangles));
  EXPECT_EQ(doubled_area(corners, triangles), 8);
  EXPECT_EQ(border_of(triangles).size(), 6U);
}

// A face's border may run out to a point and back: a triangle over there and back would name a
// point twice.
TEST(RingFiller, AWayThereAndBackLeavesNoTriangleThatNamesAPointTwice) {
  const std::vector<LatticeCorner> corners = flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {6, 2}, {8, 2}});
  for (const std::vector<std::uint32_t>& ring :
       {std::vector<std::uint32_t>{0, 1, 2, 4, 2, 3}, {1, 2, 4, 5, 4, 2, 3, 0}, {0, 4, 0, 5}}) {
    RingFiller filler;
    filler.begin();
    add_ring(filler, ring);
    std::vector<Triangle> triangles;
    ASSERT_TRUE(filler.fill(corners, FaceView::UV, triangles));
    for (const Triangle& named : triangles) {
      EXPECT_TRUE(named[0] != named[1] && named[1] != named[2] && named[2] != named[0]);
    }
    const bool is_square = ring.size() > 4;
    EXPECT_EQ(doubled_area(corners, triangles), is_square ? 32 : 0);
    EXPECT_EQ(border_of(triangles).size(), is_square ? 4U : 0U);
  }
}

TEST(RingFiller, EdgesThatFormNoRingAreRefusedAndForgotten) {
  const std::vector<LatticeCorner> corners = flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  RingFiller filler;
  std::vector<Triangle> triangles;
  filler.begin();
  filler.add(0, 1);
  filler.add(1, 2);
  EXPECT_FALSE(filler.fill(corners, FaceView::UV, triangles));
  EXPECT_TRUE(triangles.empty());
  filler.begin();
  EXPECT_TRUE(filler.is_empty());
  add_ring(filler, {0, 1, 2, 3});
  ASSERT_TRUE(filler.fill(corners, FaceView::UV, triangles));
  EXPECT_EQ(doubled_area(corners, triangles), 32);
}

// A square on each plane of the axes, counter-clockwise seen from where the view looks.
TEST(RingFiller, EveryViewSeesItsOwnFaceCounterClockwise) {
  struct Case {
    Vec3 normal;
    FaceView view;
  };
  const std::vector<Case> cases{
      {Vec3(0.0, 0.1, 1.0), FaceView::UV}, {Vec3(0.1, 0.0, -1.0), FaceView::VU},
      {Vec3(1.0, 0.2, 0.0), FaceView::VZ}, {Vec3(-1.0, 0.0, 0.3), FaceView::ZV},
      {Vec3(0.0, 1.0, 0.1), FaceView::ZU}, {Vec3(0.2, -1.0, 0.0), FaceView::UZ},
  };
  for (const Case& asked : cases) {
    EXPECT_EQ(view_along(asked.normal), asked.view);
    // An L in the plane across the normal's greatest axis, turning left around the normal: its
    // fourth corner is reflex.
    const Vec3 n = asked.normal;
    const Vec3 axis(std::abs(n.x) == 1.0 ? n.x : 0.0, std::abs(n.y) == 1.0 ? n.y : 0.0,
                    std::abs(n.z) == 1.0 ? n.z : 0.0);
    const Vec3 right(axis.y, axis.z, axis.x);
    const Vec3 up = glm::cross(axis, right);
    std::vector<LatticeCorner> corners;
    for (const auto& [a, b] :
         std::vector<std::pair<double, double>>{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}) {
      const Vec3 point = a * right + b * up;
      corners.push_back({{static_cast<std::int64_t>(point.x), static_cast<std::int64_t>(point.y)},
                         static_cast<std::int64_t>(point.z)});
    }
    RingFiller filler;
    filler.begin();
    add_ring(filler, {0, 1, 2, 3, 4, 5});
    std::vector<Triangle> triangles;
    ASSERT_TRUE(filler.fill(corners, asked.view, triangles));
    double unsigned_area = 0.0, along = 0.0;
    for (const Triangle& triangle : triangles) {
      const auto place = [&](std::size_t k) {
        const LatticeCorner& corner = corners[triangle[k]];
        return Vec3(static_cast<double>(corner.place.u), static_cast<double>(corner.place.v),
                    static_cast<double>(corner.height));
      };
      const Vec3 normal = glm::cross(place(1) - place(0), place(2) - place(0));
      along += glm::dot(normal, axis);
      unsigned_area += std::sqrt(glm::dot(normal, normal));
    }
    EXPECT_EQ(along, 14.0);
    EXPECT_EQ(unsigned_area, 14.0);
  }
}

}  // namespace
}  // namespace hallux::tests

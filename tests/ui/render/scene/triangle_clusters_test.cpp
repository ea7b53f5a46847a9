#include "ui/render/scene/triangle_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "simulator/base/random.h"
#include "ui/render/stereo.h"

namespace hallux::tests {
namespace {

using namespace ui;

Vec3 some_point(Random& random, double half_mm) {
  return Vec3(random.uniform(-half_mm, half_mm), random.uniform(-half_mm, half_mm),
              random.uniform(-half_mm, half_mm));
}

EyeView some_view() {
  Camera camera;
  camera.magnification = 7.0;
  return view_of(standard_view(camera, StandardView::Operator), {}, Eye::Left, 16.0 / 9.0);
}

TEST(TriangleClusters, AnOrderByPlaceNamesEachPlaceOnceAndKeepsNeighboursTogether) {
  Random random(7);
  std::vector<Vec3> places_mm(4000);
  for (Vec3& place_mm : places_mm) place_mm = some_point(random, 40.0);
  const std::vector<std::uint32_t> order = order_by_place(places_mm);
  std::vector<std::uint32_t> sorted = order, all(places_mm.size());
  std::iota(all.begin(), all.end(), 0U);
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, all);
  const auto mean_step_mm = [&](const std::vector<std::uint32_t>& numbers) {
    double sum_mm = 0.0;
    for (std::size_t i = 1; i < numbers.size(); ++i) {
      sum_mm += glm::distance(places_mm[numbers[i - 1]], places_mm[numbers[i]]);
    }
    return sum_mm / static_cast<double>(numbers.size() - 1);
  };
  EXPECT_LT(mean_step_mm(order), 0.2 * mean_step_mm(all));
}

TEST(TriangleClusters, PlacesInOnePointOrNoneHaveAnOrder) {
  EXPECT_TRUE(order_by_place({}).empty());
  const std::vector<Vec3> same(5, Vec3(3.0, 4.0, 5.0));
  EXPECT_EQ(order_by_place(same), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST(TriangleClusters, WhatLandsInAPartOfThePictureMayBeSeenThroughIt) {
  const EyeView view = some_view();
  const Vec2 low(0.3, 0.2), high(0.6, 0.45);
  const Frustum frustum = frustum_through(view.clip_from_world(), low, high);
  Random random(11);
  std::size_t inside = 0, refused = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 point_mm = some_point(random, 35.0);
    Box box;
    box.add(point_mm);
    const Vec3 place = place_in_picture(view, point_mm);
    const bool is_inside =
        place.x > low.x && place.x < high.x && 1.0 - place.y > low.y && 1.0 - place.y < high.y;
    if (is_inside) {
      ++inside;
      EXPECT_TRUE(may_be_seen(frustum, box));
    } else {
      refused += may_be_seen(frustum, box) ? 0U : 1U;
    }
    // Around a point that is seen, any box is.
    box.add(point_mm + some_point(random, 10.0));
    EXPECT_TRUE(may_be_seen(frustum, box) || !is_inside);
  }
  EXPECT_GT(inside, 500U);
  EXPECT_EQ(refused, 20000U - inside);
}

TEST(TriangleClusters, RunsThatFollowEachOtherAreDrawnAtOnce) {
  const auto box_at = [](double x_mm) {
    Box box;
    box.add(Vec3(x_mm, 0.0, 0.0));
    return box;
  };
  const std::vector<TriangleCluster> clusters{{{0, 10}, box_at(0.5), {}},
                                              {{10, 10}, box_at(0.6), {}},
                                              {{20, 10}, box_at(7.0), {}},
                                              {{30, 4}, box_at(0.1), {}}};
  // An orthographic box of one millimetre to each side.
  const Frustum frustum = frustum_through(DoubleMatrix4(1.0), Vec2(0.0), Vec2(1.0));
  std::vector<TriangleRun> runs{{5, 5}};
  find_seen(clusters, frustum, runs);
  EXPECT_EQ(runs, (std::vector<TriangleRun>{{0, 20}, {30, 4}}));
}

TEST(TriangleClusters, WhatFacesAwayShowsNoneOfItsTriangles) {
  Random random(17);
  std::size_t away = 0;
  for (int i = 0; i < 3000; ++i) {
    // Triangles of a wavy patch, and an eye anywhere around it.
    const Vec3 axis = glm::normalize(some_point(random, 1.0));
    std::vector<Vec3> normals;
    std::vector<Vec3> points_mm;
    TriangleCluster cluster;
    for (int k = 0; k < 12; ++k) {
      normals.push_back(glm::normalize(axis + some_point(random, 0.3)));
      points_mm.push_back(some_point(random, 2.0));
      cluster.box.add(points_mm.back());
    }
    cluster.normals = cone_around(normals);
    const Vec3 eye_mm = some_point(random, 60.0);
    if (!faces_away(cluster, eye_mm)) continue;
    ++away;
    for (const Vec3& normal : normals) {
      for (const Vec3& point_mm : points_mm) EXPECT_GT(glm::dot(normal, point_mm - eye_mm), 0.0);
    }
  }
  EXPECT_GT(away, 500U);
  EXPECT_LT(away, 1500U);
}

TEST(TriangleClusters, NormalsAllAroundMayFaceAnything) {
  const std::vector<Vec3> opposite{Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)};
  EXPECT_EQ(cone_around(opposite).sine, 1.0);
  const std::vector<Vec3> wide{Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)};
  EXPECT_EQ(cone_around(wide).sine, 1.0);
  EXPECT_EQ(cone_around({}).sine, 1.0);
  // Triangles without area have no say.
  const std::vector<Vec3> one{Vec3(0.0, 1.0, 0.0), Vec3(0.0)};
  EXPECT_EQ(cone_around(one).sine, 0.0);
}

}  // namespace
}  // namespace hallux::tests

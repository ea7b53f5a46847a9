#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include "scenarios/foot/first_metatarsal.h"
#include "scenarios/foot/topology.h"
#include "simulator/base/units.h"
#include "simulator/mesh/bvh.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;
using simulator::IndexedMesh;

/// The patient at the edge length that is shipped, made once for the whole program.
class FineBone : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto start = std::chrono::steady_clock::now();
    bone_ = make_first_metatarsal(
        first_metatarsal_table(), {.eminence_mm = 4.0, .edge_mm = 0.3}, [&](double fraction) {
          const std::chrono::duration<double> since = std::chrono::steady_clock::now() - start;
          std::cout << "fraction " << fraction << " after " << since.count() << " s\n";
          return true;
        });
  }
  inline static Bone bone_;
};

/// The smallest angle of each triangle, ascending [degree].
std::vector<double> least_angles(const IndexedMesh& mesh) {
  std::vector<double> angles;
  for (const simulator::Triangle& t : mesh.triangles) {
    double least = pi;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = mesh.points_mm[t[(k + 1) % 3]] - mesh.points_mm[t[k]];
      const Vec3 b = mesh.points_mm[t[(k + 2) % 3]] - mesh.points_mm[t[k]];
      least =
          std::min(least, std::acos(glm::dot(a, b) / std::sqrt(glm::dot(a, a) * glm::dot(b, b))));
    }
    angles.push_back(degree_from_radian(least));
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

TEST_F(FineBone, IsTwoClosedSpheres) {
  EXPECT_NO_THROW(check_sphere(bone_.outer, "outer surface"));
  EXPECT_NO_THROW(check_sphere(bone_.canal, "canal"));
  std::cout << "triangles: outer " << bone_.outer.triangles.size() << ", canal "
            << bone_.canal.triangles.size() << "\n";
  EXPECT_GT(bone_.outer.triangles.size(), 80'000U);
  EXPECT_LT(bone_.outer.triangles.size(), 120'000U);
}

TEST_F(FineBone, HasNoNeedles) {
  for (const IndexedMesh* mesh : {&bone_.outer, &bone_.canal}) {
    const std::vector<double> angles = least_angles(*mesh);
    std::cout << "least angle " << angles.front() << ", first percentile "
              << angles[angles.size() / 100] << " degrees\n";
    EXPECT_GT(angles.front(), 10.0);
    EXPECT_GT(angles[angles.size() / 100], 33.0);
  }
}

TEST_F(FineBone, HasAWallAsThickAsItsCortexEverywhere) {
  const simulator::Bvh outer(bone_.outer);
  double thinnest = 100.0;
  for (const Vec3& p : bone_.canal.points_mm) {
    const double wall = -outer.signed_distance_mm(p);
    EXPECT_GE(wall, simulator::cortex_thickness_mm(*bone_.cortex, p.x) - 0.05);
    thinnest = std::min(thinnest, wall);
  }
  std::cout << "thinnest wall " << thinnest << " mm\n";
  EXPECT_GE(thinnest, bone_.cortex->floor_mm);
}

TEST_F(FineBone, HasAnEminenceOfTheHeightAskedFor) {
  EXPECT_NEAR(simulator::find_landmark(bone_, "eminence_apex")->z, -14.6, 0.1);
}

}  // namespace
}  // namespace hallux::scenarios

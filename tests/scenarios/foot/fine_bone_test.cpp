#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <string>

#include "scenarios/foot/first_metatarsal.h"
#include "scenarios/foot/first_proximal_phalanx.h"
#include "scenarios/foot/topology.h"
#include "simulator/base/progress.h"
#include "simulator/base/units.h"
#include "simulator/mesh/bvh.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;
using simulator::IndexedMesh;

struct FineCase {
  const char* name;
  Bone (*make)(const Progress&);
  std::size_t least_triangles, most_triangles;
};

Bone make_metatarsal(const Progress& progress) {
  return make_first_metatarsal(first_metatarsal_table(), {.eminence_mm = 4.0, .edge_mm = 0.3},
                               progress);
}

Bone make_phalanx(const Progress& progress) {
  return make_first_proximal_phalanx(first_proximal_phalanx_table(), {.edge_mm = 0.3}, progress);
}

/// The patients at the edge length that is shipped, each made once for the whole program.
class FineBone : public testing::TestWithParam<FineCase> {
 protected:
  void SetUp() override {
    const std::string name = GetParam().name;
    if (bones.find(name) == bones.end()) bones.emplace(name, GetParam().make(stopwatch()));
  }
  const Bone& bone() const { return bones.at(GetParam().name); }
  inline static std::map<std::string, Bone> bones;

 private:
  static Progress stopwatch() {
    const auto start = std::chrono::steady_clock::now();
    return [start](double fraction) {
      const std::chrono::duration<double> since = std::chrono::steady_clock::now() - start;
      std::cout << "fraction " << fraction << " after " << since.count() << " s\n";
      return true;
    };
  }
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

TEST_P(FineBone, IsTwoClosedSpheres) {
  EXPECT_NO_THROW(check_sphere(bone().outer, "outer surface"));
  EXPECT_NO_THROW(check_sphere(bone().canal, "canal"));
  std::cout << "triangles: outer " << bone().outer.triangles.size() << ", canal "
            << bone().canal.triangles.size() << "\n";
  EXPECT_GT(bone().outer.triangles.size(), GetParam().least_triangles);
  EXPECT_LT(bone().outer.triangles.size(), GetParam().most_triangles);
}

TEST_P(FineBone, HasNoNeedles) {
  for (const IndexedMesh* mesh : {&bone().outer, &bone().canal}) {
    const std::vector<double> angles = least_angles(*mesh);
    std::cout << "least angle " << angles.front() << ", first percentile "
              << angles[angles.size() / 100] << " degrees\n";
    EXPECT_GT(angles.front(), 10.0);
    EXPECT_GT(angles[angles.size() / 100], 33.0);
  }
}

TEST_P(FineBone, HasAWallAsThickAsItsCortexEverywhere) {
  const simulator::Bvh outer(bone().outer);
  double thinnest = 100.0;
  for (const Vec3& p : bone().canal.points_mm) {
    const double wall = -outer.signed_distance_mm(p);
    EXPECT_GE(wall, simulator::cortex_thickness_mm(*bone().cortex, p.x) - 0.05);
    thinnest = std::min(thinnest, wall);
  }
  std::cout << "thinnest wall " << thinnest << " mm\n";
  EXPECT_GE(thinnest, bone().cortex->floor_mm);
}

TEST(FineMetatarsal, HasAnEminenceOfTheHeightAskedFor) {
  const Bone bone = make_metatarsal({});
  EXPECT_NEAR(simulator::find_landmark(bone, "eminence_apex")->z, -14.6, 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    Shipped, FineBone,
    testing::Values(FineCase{"FirstMetatarsal", make_metatarsal, 80'000, 120'000},
                    FineCase{"FirstProximalPhalanx", make_phalanx, 36'000, 52'000}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace hallux::scenarios

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "scenarios/foot/first_metatarsal.h"
#include "simulator/mesh/read_mesh.h"
#include "tests/scenarios/foot/rigid_fit.h"

namespace hallux::scenarios {
namespace {

using scenarios_test::area_samples;
using simulator::IndexedMesh;

double extent_along_x(const std::vector<Vec3>& points, const RigidTransform& bone_from_real) {
  double low = 1e9;
  double high = -1e9;
  for (const Vec3& p : points) {
    const double x = transform_point(bone_from_real, p).x;
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return high - low;
}

/// Distances of samples of both surfaces to the other, ascending [mm].
std::vector<double> symmetric_distances(const IndexedMesh& a, const IndexedMesh& b) {
  const simulator::Bvh tree_a(a);
  const simulator::Bvh tree_b(b);
  std::vector<double> distances;
  for (const Vec3& p : area_samples(a, 20000)) distances.push_back(tree_b.nearest(p)->distance_mm);
  for (const Vec3& p : area_samples(b, 20000)) distances.push_back(tree_a.nearest(p)->distance_mm);
  std::sort(distances.begin(), distances.end());
  return distances;
}

/// The folder of real bones is named by HALLUX_MESHES; they are not part of the project.
TEST(RealBone, IsMetByTheUnmodifiedTableWithinAThirdOfAMillimetre) {
  const char* folder = std::getenv("HALLUX_MESHES");
  ASSERT_NE(folder, nullptr) << "run by ./test --meshes DIR, which names the folder of real bones";
  IndexedMesh real = simulator::read_mesh(std::filesystem::path(folder) / "bp3d_metatarsal1_r.stl");
  const IndexedMesh made =
      make_first_metatarsal(first_metatarsal_table(), {.edge_mm = 0.3, .with_canal = false}).outer;
  const simulator::Bvh tree(made);
  const std::vector<Vec3> made_samples = area_samples(made, 3000);

  RigidTransform bone_from_real =
      scenarios_test::fit_rigidly(area_samples(real, 1500), tree, made_samples);
  const double scale =
      extent_along_x(made.points_mm, {}) / extent_along_x(real.points_mm, bone_from_real);
  for (Vec3& p : real.points_mm) p *= scale;
  bone_from_real.translation_mm *= scale;
  bone_from_real = scenarios_test::refine_fit(area_samples(real, 6000), tree, bone_from_real, 60);
  for (Vec3& p : real.points_mm) p = transform_point(bone_from_real, p);

  const std::vector<double> distances = symmetric_distances(made, real);
  double sum = 0.0;
  for (const double d : distances) sum += d;
  const double mean = sum / static_cast<double>(distances.size());
  const double p95 = distances[distances.size() * 95 / 100];
  std::cout << "scale " << scale << ", mean " << mean << " mm, P95 " << p95 << " mm, greatest "
            << distances.back() << " mm\n";
  EXPECT_LT(mean, 0.35);
  EXPECT_LT(p95, 0.9);
}

}  // namespace
}  // namespace hallux::scenarios

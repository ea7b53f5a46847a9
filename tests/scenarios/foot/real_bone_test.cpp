#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "scenarios/foot/first_metatarsal.h"
#include "scenarios/foot/first_proximal_phalanx.h"
#include "simulator/mesh/read_mesh.h"
#include "tests/scenarios/foot/measured_phalanx.h"
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

struct Likeness {
  double mean_mm = 0.0, p95_mm = 0.0, greatest_mm = 0.0;
};

/// How far two surfaces lie apart after the real one is scaled to the same length and laid on the
/// made one. The folder of real bones is named by HALLUX_MESHES; they are not part of the project.
Likeness likeness_to_real(const IndexedMesh& made, const char* real_file) {
  const char* folder = std::getenv("HALLUX_MESHES");
  if (folder == nullptr) {
    throw std::runtime_error("run by ./test --meshes DIR, which names the folder of real bones");
  }
  IndexedMesh real = simulator::read_mesh(std::filesystem::path(folder) / real_file);
  const simulator::Bvh tree(made);
  RigidTransform bone_from_real =
      scenarios_test::fit_rigidly(area_samples(real, 1500), tree, area_samples(made, 3000));
  const double scale =
      extent_along_x(made.points_mm, {}) / extent_along_x(real.points_mm, bone_from_real);
  for (Vec3& p : real.points_mm) p *= scale;
  bone_from_real.translation_mm *= scale;
  bone_from_real = scenarios_test::refine_fit(area_samples(real, 6000), tree, bone_from_real, 60);
  for (Vec3& p : real.points_mm) p = transform_point(bone_from_real, p);

  const std::vector<double> distances = symmetric_distances(made, real);
  double sum = 0.0;
  for (const double d : distances) sum += d;
  const Likeness found{sum / static_cast<double>(distances.size()),
                       distances[distances.size() * 95 / 100], distances.back()};
  std::cout << "scale " << scale << ", mean " << found.mean_mm << " mm, P95 " << found.p95_mm
            << " mm, greatest " << found.greatest_mm << " mm\n";
  return found;
}

TEST(RealBone, IsMetByTheFirstMetatarsalWithinAThirdOfAMillimetre) {
  const IndexedMesh made =
      make_first_metatarsal(first_metatarsal_table(), {.edge_mm = 0.3, .with_canal = false}).outer;
  const Likeness found = likeness_to_real(made, "bp3d_metatarsal1_r.stl");
  EXPECT_LT(found.mean_mm, 0.35);
  EXPECT_LT(found.p95_mm, 0.9);
}

TEST(RealBone, IsMetByTheFirstProximalPhalanxWithTheFacetAsMeasuredWithinAQuarterOfAMillimetre) {
  const IndexedMesh made = make_first_proximal_phalanx(scenarios_test::measured_phalanx_table(),
                                                       {.edge_mm = 0.3, .with_canal = false})
                               .outer;
  const Likeness found = likeness_to_real(made, "bp3d_prox_phalanx1_r.stl");
  EXPECT_LT(found.mean_mm, 0.25);
  EXPECT_LT(found.p95_mm, 0.6);
}

/// Levelling moves the facet's lateral half by up to some 3 mm, and nothing else: the bound is that
/// of a believable bone.
TEST(RealBone, IsMetByTheFirstProximalPhalanxAsShippedWithinAMillimetre) {
  const IndexedMesh made = make_first_proximal_phalanx(first_proximal_phalanx_table(),
                                                       {.edge_mm = 0.3, .with_canal = false})
                               .outer;
  const Likeness found = likeness_to_real(made, "bp3d_prox_phalanx1_r.stl");
  EXPECT_LT(found.mean_mm, 1.0);
  EXPECT_LT(found.p95_mm, 2.5);
}

/// The phalanx without its shape: one ellipse of its mean widths from end to end, and flat ends
/// with round rims.
BoneTable bar_table() {
  BoneTable table = first_proximal_phalanx_table();
  table.relief_mm = 0.0;
  table.features.clear();
  for (Station& station : table.stations) {
    station = {.position = station.position,
               .centre_y_mm = 1.0,
               .centre_z_mm = 1.8,
               .half_width_mm = 8.0,
               .half_height_mm = 6.2};
  }
  table.base = {.x_mm = 0.0, .rim_radius_mm = 5.0};
  table.head = {.x_mm = table.length_mm, .rim_radius_mm = 5.0};
  return table;
}

/// A distance alone proves little: this is what that bound must tell from a bone.
TEST(RealBone, IsNotMetByABarWithinThatBound) {
  const IndexedMesh made =
      make_first_proximal_phalanx(bar_table(), {.edge_mm = 0.3, .with_canal = false}).outer;
  const Likeness found = likeness_to_real(made, "bp3d_prox_phalanx1_r.stl");
  EXPECT_GT(found.mean_mm, 1.0);
  EXPECT_GT(found.p95_mm, 2.5);
}

}  // namespace
}  // namespace hallux::scenarios

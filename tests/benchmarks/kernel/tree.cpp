// The search tree built in other ways: the thesis left open what the parameters of its octree are
// worth (8.4.2).
#include <cmath>
#include <string>

#include "simulator/base/units.h"
#include "simulator/mesh/bvh.h"
#include "tests/benchmarks/kernel/results.h"
#include "tests/benchmarks/peers/half_space.h"
#include "tests/benchmarks/report/chart.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/worlds/bone_like.h"

namespace hallux::benchmarks {

namespace {

using namespace simulator;

struct Variant {
  std::string name;
  BvhBuild build;
};

struct Costs {
  double build_ms = 0.0, slab_us = 0.0, distance_us = 0.0, ray_us = 0.0;
};

/// Where a saw's teeth are while it goes through the shaft, a few micrometres apart.
std::vector<Vec3> tooth_places(std::size_t count) {
  std::vector<Vec3> places_mm;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    places_mm.emplace_back(2.0 + std::sin(20.0 * pi * share), 4.0 * std::sin(2.0 * pi * share),
                           8.0 - 16.0 * share);
  }
  return places_mm;
}

template <typename Ask>
double microseconds_each(const std::vector<Vec3>& places_mm, Ask ask) {
  const Percentiles spread = time_ms(
      {.least = 3, .most = 9, .limit_s = 1.0}, [] { return 0; },
      [&](int) {
        for (const Vec3& place_mm : places_mm) ask(place_mm);
      });
  return 1000.0 * spread.median / static_cast<double>(places_mm.size());
}

Costs measure_variant(const IndexedMesh& mesh, const BvhBuild& build, double& sum) {
  Costs costs;
  costs.build_ms = time_ms(
                       {.least = 3, .most = 5, .limit_s = 1.0}, [] { return 0; },
                       [&](int) { sum += Bvh(mesh, build).contains(Vec3(0.0)) ? 1.0 : 0.0; })
                       .median;
  const Bvh tree(mesh, build);
  const HalfSpace plane = sides_of(oblique_kerf(), 0.0)[0];
  std::vector<std::uint32_t> triangles;
  costs.slab_us =
      1000.0 * time_ms(
                   {.least = 20, .most = 200, .limit_s = 0.3}, [] { return 0; },
                   [&](int) {
                     triangles.clear();
                     tree.triangles_in_slab(plane.normal, plane.offset_mm, 0.25, triangles);
                     sum += static_cast<double>(triangles.size());
                   })
                   .median;
  const std::vector<Vec3> places_mm = tooth_places(4'000);
  costs.distance_us = microseconds_each(
      places_mm, [&](const Vec3& place_mm) { sum += tree.signed_distance_mm(place_mm); });
  const Vec3 direction = glm::normalize(Vec3(0.2, 0.3, -1.0));
  costs.ray_us = microseconds_each(places_mm, [&](const Vec3& place_mm) {
    if (const auto hit = tree.first_hit(place_mm, direction)) sum += hit->distance_mm;
  });
  return costs;
}

}  // namespace

void measure_tree(const Effort& effort, Results& results) {
  std::vector<Variant> variants;
  for (const std::uint32_t leaf_size : {1U, 2U, 4U, 8U, 16U, 32U, 64U}) {
    variants.push_back({"surface area, leaves of " + std::to_string(leaf_size), {leaf_size, 44}});
  }
  for (const std::uint32_t leaf_size : {4U, 16U}) {
    variants.push_back({"halves, leaves of " + std::to_string(leaf_size), {leaf_size, 0}});
  }
  Table table{.name = "tree",
              .title = "The search tree with other parameters",
              .columns = {"bone", "tree", "build ms", "slab query us", "distance us", "ray us"},
              .rows = {},
              .notes = {"Hallux's tree: surface area heuristic over 16 bins, leaves of 4.",
                        "Distances and rays from a saw's teeth on their way through the shaft."}};
  double sum = 0.0;
  for (const std::size_t triangles : {50'000U, 500'000U}) {
    if (triangles > effort.greatest_mesh) continue;
    const IndexedMesh mesh = make_bone_like({triangles, true});
    for (const Variant& variant : variants) {
      const Costs costs = measure_variant(mesh, variant.build, sum);
      table.rows.push_back({std::to_string(triangles / 1'000) + "k hollow", variant.name,
                            costs.build_ms, costs.slab_us, costs.distance_us, costs.ray_us});
    }
  }
  if (!std::isfinite(sum)) results.faults.emplace_back("tree: a distance is not a number");
  results.tables.push_back(std::move(table));
}

}  // namespace hallux::benchmarks

#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "simulator/base/random.h"
#include "simulator/mesh/bvh.h"
#include "tests/support/worlds.h"

namespace hallux::tests {

namespace {

constexpr double radius_mm = 12.0;

simulator::IndexedMesh sphere_of(const benchmark::State& state) {
  return dense_sphere(radius_mm, static_cast<std::size_t>(state.range(0)));
}

void build_tree(benchmark::State& state) {
  const simulator::IndexedMesh mesh = sphere_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(simulator::Bvh(mesh));
}
BENCHMARK(build_tree)->Arg(5'000)->Arg(50'000)->Unit(benchmark::kMillisecond);

// A tool moves little from one tick to the next: each query lies a few micrometres from the last.
void distance_along_a_slow_walk(benchmark::State& state) {
  const simulator::Bvh tree(sphere_of(state));
  double x_mm = -0.5 * radius_mm;
  for (auto _ : state) {
    benchmark::DoNotOptimize(tree.signed_distance_mm(Vec3(x_mm, 0.9 * radius_mm, 0.1)));
    x_mm = x_mm > 0.5 * radius_mm ? -0.5 * radius_mm : x_mm + 0.005;
  }
}
BENCHMARK(distance_along_a_slow_walk)->Arg(5'000)->Arg(50'000);

void distance_anywhere_near(benchmark::State& state) {
  const simulator::Bvh tree(sphere_of(state));
  Random random(1, "points");
  std::vector<Vec3> points_mm(4096);
  for (Vec3& point_mm : points_mm) {
    const double side_mm = 1.1 * radius_mm;
    point_mm = Vec3(random.uniform(-side_mm, side_mm), random.uniform(-side_mm, side_mm),
                    random.uniform(-side_mm, side_mm));
  }
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(tree.signed_distance_mm(points_mm[next]));
    next = (next + 1) % points_mm.size();
  }
}
BENCHMARK(distance_anywhere_near)->Arg(5'000)->Arg(50'000);

void triangles_in_a_kerf(benchmark::State& state) {
  const simulator::Bvh tree(sphere_of(state));
  std::vector<std::uint32_t> triangles;
  for (auto _ : state) {
    triangles.clear();
    tree.triangles_in_slab(Vec3(0.0, 0.0, 1.0), 2.0, 0.25, triangles);
    benchmark::DoNotOptimize(triangles.data());
  }
}
BENCHMARK(triangles_in_a_kerf)->Arg(5'000)->Arg(50'000);

}  // namespace

}  // namespace hallux::tests

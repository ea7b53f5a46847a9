#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "simulator/base/random.h"
#include "simulator/cutting/remaining/remaining_bone.h"
#include "simulator/mesh/bvh.h"
#include "simulator/record/record.h"
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
BENCHMARK(distance_along_a_slow_walk)->Arg(5'000)->Arg(50'000)->Arg(500'000);

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
BENCHMARK(distance_anywhere_near)->Arg(5'000)->Arg(50'000)->Arg(500'000);

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

// The rows of the table of queries: each point a few micrometres from the last, as a tool moves.
template <typename Ask>
void walk(benchmark::State& state, const Ask& ask) {
  const simulator::Bvh tree(sphere_of(state));
  double x_mm = -0.5 * radius_mm;
  for (auto _ : state) {
    benchmark::DoNotOptimize(ask(tree, Vec3(x_mm, 0.9 * radius_mm, 0.1)));
    x_mm = x_mm > 0.5 * radius_mm ? -0.5 * radius_mm : x_mm + 0.005;
  }
}

void ray_down(benchmark::State& state) {
  walk(state, [](const simulator::Bvh& tree, const Vec3& at) {
    return tree.first_hit(at + Vec3(0.0, 5.0, 0.0), Vec3(0.0, -1.0, 0.0));
  });
}
BENCHMARK(ray_down)->Arg(50'000)->Arg(500'000);

Quat blade_down() { return rotation_from_axes(Vec3(0.0, -1.0, 0.0), Vec3(0.0, 0.0, 1.0)); }

// What still stands, with a kerf of 8 mm in it: points along the teeth in the slot (range 1: 0), in
// the bone below it (1), and over its mouth (2).
void nearest_standing(benchmark::State& state) {
  const simulator::Bvh tree(sphere_of(state));
  simulator::KerfSet kerfs({}, RigidTransform{});
  kerfs.freeze(simulator::quantise({blade_down(), Vec3(0.0, 13.0, 0.0)}));
  for (const double y_mm : {13.0, 4.0}) {
    simulator::ToolSample sample;
    sample.kerf = 0;
    sample.status = static_cast<std::uint32_t>(simulator::ToolStatus::SawOn);
    sample.world_from_tool = simulator::quantise({blade_down(), Vec3(0.0, y_mm, 0.0)});
    kerfs.apply(sample);
  }
  const simulator::RemainingBone bone{tree, kerfs, {}};
  const double y_mm = state.range(1) == 0 ? 4.01 : state.range(1) == 1 ? 3.0 : 12.2;
  double z_mm = -5.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(bone.nearest(Vec3(0.05, y_mm, z_mm)));
    z_mm = z_mm > 5.0 ? -5.0 : z_mm + 0.005;
  }
}
BENCHMARK(nearest_standing)->ArgsProduct({{50'000, 500'000}, {0, 1, 2}});

}  // namespace

}  // namespace hallux::tests

// What one tick of a tool with a point costs while it bores, stands on bone and slides on it.
//
//     bore_table [TRIANGLES...]
//
// Bones of 5,000, 50,000 and 500,000 triangles, or as many as are said. Processor time of each
// tick, as Markdown.
#include <utility>
#include <vector>

#include "simulator/base/elementary.h"
#include "tests/benchmarks/haptics/tick_costs.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/worlds/bone_like.h"
#include "tests/simulator/contact/bore/bore_world.h"
#include "tests/simulator/step/simulation_run.h"

namespace hallux::benchmarks {

namespace {

using tests::BoreWorld;
using tests::pointing;

const Vec3 down{0.0, -1.0, 0.0};

/// Times of ticks, each with the handle that `handle_at` gives.
template <typename HandleAt>
Percentiles cost_us(BoreWorld& world, int ticks, const HandleAt& handle_at) {
  std::vector<double> times_us;
  for (int i = 0; i < ticks; ++i) {
    const RigidTransform handle = handle_at(i);
    const Stopwatch watch;
    world.tick(handle, true);
    times_us.push_back(1000.0 * watch.worked_milliseconds());
  }
  return percentiles_of(std::move(times_us));
}

/// Through the shaft with 10 N and out beyond it, beside a hole that is there.
Percentiles bored(const simulator::Bone& bone) {
  BoreWorld world(bone, simulator::bore_tool(simulator::WireDriver{}));
  const Vec3 middle = middle_of(bone.outer);
  world.holes.push_back({middle + Vec3{3.0, 12.0, 0.0}, middle + Vec3{3.0, -12.0, 0.0}, 0.8});
  world.state.wound_from_tool = pointing(middle + Vec3{0.0, 12.0, 0.0}, down);
  world.holes.reserve(8);
  world.bores.push_back(
      simulator::begin_bore(pointing(middle + Vec3{3.0, 8.0, 0.0}, down), 0.0, 0.8));
  return cost_us(world, 8000, [&](int) {
    RigidTransform handle = world.state.wound_from_tool;
    handle.translation_mm += 5.0 * down;
    return handle;
  });
}

/// Laid flat on the shaft, pressed, skidding and tilted to and fro.
Percentiles laid(const simulator::Bone& bone) {
  BoreWorld world(bone, simulator::bore_tool(simulator::WireDriver{}));
  const Vec3 middle = middle_of(bone.outer);
  const Vec3 along{1.0, 0.0, 0.0};
  world.state.wound_from_tool = pointing(middle + Vec3{8.0, 12.0, 0.0}, along);
  return cost_us(world, 8000, [&](int tick) {
    const double swing = elementary::sin(0.003 * tick);
    const Vec3 place = middle + Vec3{8.0 + 3.0 * swing, 4.0, 2.0 * swing};
    return pointing(place, unit(along + Vec3{0.0, 0.15 * swing - 0.2, 0.0}));
  });
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  using namespace hallux::benchmarks;
  const TickCosts costs{.program = "bore_table",
                        .name = "bore_cost",
                        .title = "What a tick of a wire costs, processor time",
                        .counted = "ticks",
                        .work = {{"bored", bored}, {"laid on", laid}}};
  return print_tick_costs(costs, count, words);
}

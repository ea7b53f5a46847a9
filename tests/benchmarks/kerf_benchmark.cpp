#include <benchmark/benchmark.h>

#include "simulator/cutting/kerf.h"

namespace hallux::tests {

namespace {

// A saw that advances by the argument's micrometres a tick: what the step pays to open the kerf.
void stamp_of_one_tick(benchmark::State& state) {
  const simulator::BladeSize blade{.width_mm = 12.0, .depth_mm = 30.0, .kerf_mm = 0.5};
  const double advance_mm = static_cast<double>(state.range(0)) * 0.001;
  simulator::KerfField field{simulator::FieldGrid{}};
  simulator::FieldWindow changed;
  simulator::PlanarPose from;
  for (auto _ : state) {
    simulator::PlanarPose to = from;
    to.tip_mm.x += advance_mm;
    field.stamp(blade, from, to, changed);
    benchmark::DoNotOptimize(changed);
    from = to;
    if (from.tip_mm.x < 30.0) continue;
    state.PauseTiming();
    field.reset();
    from = {};
    state.ResumeTiming();
  }
}
BENCHMARK(stamp_of_one_tick)->Arg(1)->Arg(5)->Arg(100);

}  // namespace

}  // namespace hallux::tests

// Printed with every program's numbers: a machine that is slower here is slower by its nature.
#include <benchmark/benchmark.h>

#include "tests/benchmarks/calibration_work.h"

namespace hallux::benchmarks {

namespace {

void calibration(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(million_square_roots());
}
BENCHMARK(calibration)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace hallux::benchmarks

// A fixed piece of work, printed with every program's numbers: a machine that is slower here is slower by its nature.
#include <benchmark/benchmark.h>

#include <cmath>

namespace hallux::tests {

namespace {

// A million square roots, each waiting for the last: about what a processor does one after another in 4 to 8 ms.
void calibration(benchmark::State& state) {
  for (auto _ : state) {
    double value = 2.0;
    for (int i = 0; i < 1'000'000; ++i) value = std::sqrt(value + 1.0);
    benchmark::DoNotOptimize(value);
  }
}
BENCHMARK(calibration)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace hallux::tests

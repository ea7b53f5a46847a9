#include "tests/benchmarks/kernel/results.h"

#include <cmath>

#include "tests/benchmarks/calibration_work.h"
#include "tests/benchmarks/report/percentiles.h"

namespace hallux::benchmarks {

void expect_volume(Results& results, const std::string& what, double expected_mm3,
                   double found_mm3) {
  // Each volume is a sum over the whole bone; that of a slab is the difference of two such sums.
  if (std::abs(found_mm3 - expected_mm3) <= 1e-6 * std::abs(expected_mm3)) return;
  results.faults.push_back(what + ": " + std::to_string(found_mm3) + " mm3 instead of " +
                           std::to_string(expected_mm3));
}

void measure_calibration(const Effort&, Results& results) {
  double sink = 0.0;
  const Percentiles spread = time_ms(
      {.least = 50, .most = 50}, [] { return 0; }, [&](int) { sink += million_square_roots(); });
  if (!(sink > 0.0)) results.faults.emplace_back("calibration: a square root went wrong");
  results.tables.push_back(
      {"calibration",
       "Calibration: a million square roots, each waiting for the last",
       {"runs", "median ms", "p99 ms", "least ms"},
       {{static_cast<double>(spread.count), spread.median, spread.p99, spread.least}},
       {"Times are processor time. Divide by it before numbers of two machines are compared."}});
}

}  // namespace hallux::benchmarks

#include "tests/benchmarks/report/percentiles.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>

#include "tests/benchmarks/calibration_work.h"

namespace hallux::benchmarks {

namespace {

double at_share(const std::vector<double>& sorted, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

}  // namespace

double Stopwatch::worked_ms() {
  timespec worked{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &worked);
  return 1e3 * static_cast<double>(worked.tv_sec) + 1e-6 * static_cast<double>(worked.tv_nsec);
}

Percentiles percentiles_of(std::vector<double> values) {
  Percentiles spread;
  spread.count = values.size();
  if (values.empty()) return spread;
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = values.size() > 1 ? std::sqrt(squares / (count - 1.0)) : 0.0;
  spread.least = values.front();
  spread.median = at_share(values, 0.5);
  spread.p99 = at_share(values, 0.99);
  spread.greatest = values.back();
  return spread;
}

double calibration_ms() {
  double sum = 0.0;
  const Percentiles spread = time_ms(
      {20, 20, 1.0}, [] { return 0; }, [&](int) { sum += million_square_roots(); });
  return sum > 0.0 ? spread.median : 0.0;
}

}  // namespace hallux::benchmarks

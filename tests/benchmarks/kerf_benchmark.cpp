// What a tick pays to open the kerf, and a frame to follow its outline. A saw feeds along its
// direction with the tremor of a hand; its poses are rounded as the record's are. Arguments:
// direction in the kerf's plane [degrees], feed [um a tick].
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "simulator/base/elementary.h"
#include "simulator/base/random.h"
#include "simulator/cutting/field/kerf.h"
#include "simulator/cutting/field/region_outline.h"

namespace hallux::tests {

namespace {

using namespace simulator;
using Clock = std::chrono::steady_clock;

constexpr Blade blade{.width_mm = 12.0, .depth_mm = 30.0, .kerf_mm = 0.5};
constexpr double tremor_mm = 0.005;
constexpr double tremor_rad = 0.0005;

double rounded(double value, double quantum) { return std::round(value / quantum) * quantum; }

/// The saw's poses: from nothing 20 mm into the bone, then the same again.
class Feed {
 public:
  explicit Feed(const benchmark::State& state)
      : turn_rad_(static_cast<double>(state.range(0)) * 3.14159265358979 / 180.0),
        feed_mm_(static_cast<double>(state.range(1)) * 0.001) {}

  bool is_over() const { return way_mm_ > 20.0; }
  void start_again() { way_mm_ = 0.0; }
  PlanarPose next() {
    way_mm_ += feed_mm_;
    const double turn_rad = turn_rad_ + random_.uniform(-tremor_rad, tremor_rad);
    const Vec2 feed(elementary::cos(turn_rad_), elementary::sin(turn_rad_));
    const double aside_mm = random_.uniform(-tremor_mm, tremor_mm);
    const Vec2 tip_mm = way_mm_ * feed + aside_mm * Vec2(-feed.y, feed.x);
    return {Vec2(rounded(tip_mm.x, 1e-3), rounded(tip_mm.y, 1e-3)),
            glm::normalize(Vec2(rounded(elementary::cos(turn_rad), 1e-6),
                                rounded(elementary::sin(turn_rad), 1e-6)))};
  }

 private:
  double turn_rad_, feed_mm_, way_mm_ = 0.0;
  Random random_{3};
};

/// Times one call a round and reports median and 99th percentile [us].
class Timings {
 public:
  template <class Work>
  void time(benchmark::State& state, Work work) {
    const auto start = Clock::now();
    work();
    const std::chrono::duration<double> taken = Clock::now() - start;
    state.SetIterationTime(taken.count());
    taken_us_.push_back(taken.count() * 1e6);
  }
  void report(benchmark::State& state) {
    std::sort(taken_us_.begin(), taken_us_.end());
    state.counters["median_us"] = taken_us_[taken_us_.size() / 2];
    state.counters["p99_us"] = taken_us_[taken_us_.size() * 99 / 100];
  }

 private:
  std::vector<double> taken_us_;
};

void stamp_of_one_tick(benchmark::State& state) {
  KerfField field{FieldGrid{}};
  FieldWindow changed;
  Feed feed(state);
  Timings timings;
  PlanarPose from = feed.next();
  field.stamp(blade, from, from, changed);
  for (auto _ : state) {
    const PlanarPose to = feed.next();
    timings.time(state, [&] { field.stamp(blade, from, to, changed); });
    benchmark::DoNotOptimize(changed);
    from = to;
    if (!feed.is_over()) continue;
    field = KerfField(FieldGrid{});
    feed.start_again();
    from = feed.next();
    field.stamp(blade, from, from, changed);
  }
  timings.report(state);
}
BENCHMARK(stamp_of_one_tick)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->ArgsProduct({{0, 30, 45, 90}, {5, 200}});

// The whole blade at once: the tick that freezes a kerf.
void first_stamp(benchmark::State& state) {
  KerfField field{FieldGrid{}};
  FieldWindow changed;
  Feed feed(state);
  Timings timings;
  for (auto _ : state) {
    field = KerfField(FieldGrid{});
    const PlanarPose pose = feed.next();
    timings.time(state, [&] { field.stamp(blade, pose, pose, changed); });
    benchmark::DoNotOptimize(changed);
  }
  timings.report(state);
}
BENCHMARK(first_stamp)->UseManualTime()->Unit(benchmark::kMicrosecond)->Args({0, 5})->Args({30, 5});

// A picture frame: the outline after 16 ticks since the last.
void outline_of_one_frame(benchmark::State& state) {
  KerfField field{FieldGrid{}};
  OutlineTracker tracker{FieldGrid{}};
  FieldWindow changed;
  Feed feed(state);
  Timings timings;
  PlanarPose from = feed.next();
  const auto advance = [&] {
    const PlanarPose to = feed.next();
    field.stamp(blade, from, to, changed);
    from = to;
  };
  double corners = 0.0;
  for (auto _ : state) {
    for (std::int64_t tick = 0; tick < state.range(2); ++tick) advance();
    timings.time(state, [&] { tracker.update(field); });
    corners = std::max(corners, static_cast<double>(tracker.outline().corners_mm.size()));
    if (!feed.is_over()) continue;
    field = KerfField(FieldGrid{});
    tracker = OutlineTracker(FieldGrid{});
    feed.start_again();
    from = feed.next();
    advance();
    tracker.update(field);
  }
  timings.report(state);
  state.counters["corners_max"] = corners;
}
BENCHMARK(outline_of_one_frame)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->ArgsProduct({{0, 30, 45, 90}, {5, 200}, {1, 16}});

// All of a blade's outline, nothing known before.
void outline_from_scratch(benchmark::State& state) {
  KerfField field{FieldGrid{}};
  FieldWindow changed;
  Feed feed(state);
  PlanarPose from = feed.next();
  for (; !feed.is_over(); from = feed.next()) field.stamp(blade, from, from, changed);
  Timings timings;
  for (auto _ : state) {
    timings.time(state, [&] { benchmark::DoNotOptimize(outline_of(field)); });
  }
  timings.report(state);
}
BENCHMARK(outline_from_scratch)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->Args({0, 20})
    ->Args({30, 20});

}  // namespace

}  // namespace hallux::tests

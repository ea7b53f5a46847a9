// Growth: how much room to take when the room ends.
//
// A scheme of p percent takes p percent of what is needed. All is appended step by step, each step
// sent at once, as the thesis did. Beside the time stands what the buffers themselves count: stores
// made, and bytes moved from store to store. The latter is exact and the same on every machine; a
// line through it is drawn beside the measured one.
#include <epoxy/gl.h>

#include <algorithm>
#include <string>
#include <vector>

#include "simulator/mesh/indexed_mesh.h"
#include "tests/benchmarks/display_buffers/sections.h"
#include "tests/benchmarks/display_buffers/workloads.h"
#include "tests/benchmarks/report/chart.h"
#include "tests/benchmarks/report/percentiles.h"
#include "ui/render/gl/display_buffer.h"
#include "ui/render/scene/bone_mesh.h"

namespace hallux::benchmarks {

namespace {

using simulator::Triangle;

constexpr int schemes = 21;

struct Appended {
  double worked_ms = 0.0;
  std::uint64_t stores = 0, moved_bytes = 0, appended_bytes = 0;
};

std::uint32_t count_of(const AppendStep& step, const ui::BoneVertex&) { return step.vertices; }
std::uint32_t count_of(const AppendStep& step, const Triangle&) { return step.triangles; }

/// All steps on one buffer.
template <typename Element>
Appended append_all(std::size_t initial, const std::vector<AppendStep>& steps, double factor) {
  ui::DisplayBuffer<Element> buffer({}, {.growth = {.factor = factor, .least = 1}});
  buffer.append(std::vector<Element>(initial));
  buffer.upload();
  glFinish();
  const ui::BufferCounts before = buffer.counts();
  const std::vector<Element> added(4096);
  const Stopwatch watch;
  Appended result;
  for (const AppendStep& step : steps) {
    const std::size_t count = std::min<std::size_t>(count_of(step, Element{}), added.size());
    buffer.append(std::span(added).first(count));
    buffer.upload();
    result.appended_bytes += count * sizeof(Element);
  }
  glFinish();
  result.worked_ms = watch.worked_milliseconds();
  result.stores = buffer.counts().stores - before.stores;
  result.moved_bytes =
      buffer.counts().uploaded_bytes - before.uploaded_bytes - result.appended_bytes;
  return result;
}

template <typename Element>
Appended median_of(std::size_t initial, const std::vector<AppendStep>& steps, double factor,
                   std::size_t repetitions) {
  std::vector<double> times_ms;
  Appended result;
  // Exactly what is needed takes a thousand times as long as all else: once says enough.
  for (std::size_t i = 0; i < (factor <= 1.0 ? 1 : repetitions); ++i) {
    result = append_all<Element>(initial, steps, factor);
    times_ms.push_back(result.worked_ms);
  }
  result.worked_ms = percentiles_of(times_ms).median;
  return result;
}

struct Figure {
  std::string number, what;  ///< "7.3", "Cutting the foot: vertices"
};

double megabytes(std::uint64_t bytes) { return static_cast<double>(bytes) / 1.0e6; }

/// The measured times, and a line of what is explained by bytes alone: the fixed share as with most
/// room, the rest by bytes.
std::string draw_figure(const Figure& figure, const std::vector<Appended>& by_scheme) {
  LineChart chart{
      .title = "Thesis " + figure.number + ": " + figure.what + " (schemes of 101 to 120 %)",
      .along_name = "room taken beyond what is needed [%]",
      .value_name = "processor time [ms]",
      .along = {},
      .series = {{"measured", {}}, {"from bytes moved alone", {}}}};
  double moved = 0.0, time = 0.0;
  const double least = by_scheme.back().worked_ms;
  const double least_moved = megabytes(by_scheme.back().moved_bytes);
  for (int scheme = 1; scheme < schemes; ++scheme) {
    const Appended& one = by_scheme[static_cast<std::size_t>(scheme)];
    moved += megabytes(one.moved_bytes) - least_moved;
    time += one.worked_ms - least;
  }
  const double ms_per_mb = moved > 0.0 ? std::max(time / moved, 0.0) : 0.0;
  for (int scheme = 1; scheme < schemes; ++scheme) {
    const Appended& one = by_scheme[static_cast<std::size_t>(scheme)];
    chart.along.push_back(scheme);
    chart.series[0].values.push_back(one.worked_ms);
    chart.series[1].values.push_back(least +
                                     ms_per_mb * (megabytes(one.moved_bytes) - least_moved));
  }
  return draw_lines(chart);
}

template <typename Element>
void measure_figure(const Figure& figure, std::size_t initial, const AppendWork& work,
                    const BufferEffort& effort, BufferResults& results) {
  Table table{
      .name = "growth_" + figure.number,
      .title = "Thesis " + figure.number + ": " + figure.what,
      .columns = {"scheme %", "processor ms", "stores", "moved MB", "appended MB"},
      .rows = {},
      .notes = {std::to_string(initial) + " elements of " + std::to_string(sizeof(Element)) +
                " bytes at the beginning, " + std::to_string(work.steps.size()) + " steps"}};
  std::vector<Appended> by_scheme;
  for (int scheme = 0; scheme < schemes; ++scheme) {
    const double factor = 1.0 + 0.01 * scheme;
    const Appended one = median_of<Element>(initial, work.steps, factor, effort.repetitions);
    by_scheme.push_back(one);
    table.rows.push_back({100.0 + scheme, one.worked_ms, static_cast<double>(one.stores),
                          megabytes(one.moved_bytes), megabytes(one.appended_bytes)});
  }
  if (by_scheme.front().stores <= by_scheme.back().stores) {
    results.faults.push_back(figure.number + ": more room did not make fewer stores");
  }
  results.charts.push_back({"growth_" + figure.number, draw_figure(figure, by_scheme)});
  results.tables.push_back(table);
}

}  // namespace

void measure_growth(const BufferEffort& effort, BufferResults& results) {
  int vertex_figure = 3, index_figure = 7;
  for (const BufferModel& model : buffer_models(effort.is_quick)) {
    for (const AppendWork& work :
         {cutting_of(model), subdividing_of(model, effort.subdivided_at_most)}) {
      const std::string what = work.name + " the " + model.name;
      measure_figure<ui::BoneVertex>({"7." + std::to_string(vertex_figure++), what + ", vertices"},
                                     model.mesh.points_mm.size(), work, effort, results);
      measure_figure<Triangle>({"7." + std::to_string(index_figure++), what + ", indices"},
                               model.mesh.triangles.size(), work, effort, results);
    }
  }
}

}  // namespace hallux::benchmarks

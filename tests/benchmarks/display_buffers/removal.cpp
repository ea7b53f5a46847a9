// Removal: with and without the overwrite trick, a batch of triangles a frame.
//
// The thesis removed faster by overwriting on its small mesh and slower on its large one, and left
// open why. Four readings of its method are measured beside the two policies: what it compares with
// (a rebuild for each triangle, or one for each frame), how a triangle's indices are found (known,
// or searched), and what is sent after a change (that, or all).
#include <epoxy/gl.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "simulator/base/random.h"
#include "tests/benchmarks/display_buffers/placed_buffer.h"
#include "tests/benchmarks/display_buffers/sections.h"
#include "tests/benchmarks/display_buffers/workloads.h"
#include "tests/benchmarks/report/chart.h"
#include "tests/benchmarks/report/percentiles.h"

namespace hallux::benchmarks {

namespace {

using simulator::Triangle;

constexpr Triangle blank{0, 0, 0};
constexpr std::size_t batch = 40;  ///< triangles a frame: about what a saw's frame hides

struct Method {
  std::string name;
  RemovalPolicy removal = RemovalPolicy::Overwrite;
  bool sends_each = false;  ///< after each triangle; otherwise after each frame
  bool searches = false;    ///< the place of a triangle is looked for
  bool sends_all = false;   ///< a change makes the whole buffer go
};

std::vector<Method> methods() {
  return {
      {"overwrite, sent once a frame (Hallux)"},
      {"move last, sent once a frame", RemovalPolicy::MoveLast},
      {"overwrite, each triangle sent", RemovalPolicy::Overwrite, true},
      {"rebuild once a frame", RemovalPolicy::Rebuild},
      {"rebuild for each triangle (thesis, unoptimised)", RemovalPolicy::Rebuild, true},
      {"overwrite, place searched, each sent", RemovalPolicy::Overwrite, true, true},
      {"overwrite, whole buffer sent once a frame", RemovalPolicy::Overwrite, false, false, true}};
}

/// The triangle's place as one finds it who keeps no record: by its indices.
std::uint32_t search(const PlacedBuffer<Triangle>& buffer, const Triangle& triangle) {
  const auto all = buffer.elements();
  return static_cast<std::uint32_t>(std::find(all.begin(), all.end(), triangle) - all.begin());
}

void send_all(const PlacedBuffer<Triangle>& buffer) {
  glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.name());
  const auto bytes = std::as_bytes(buffer.elements());
  glBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

std::vector<std::uint32_t> shuffled(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  Random random(11);
  for (std::size_t i = count; i > 1; --i) {
    std::swap(order[i - 1],
              order[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
  }
  return order;
}

/// Microseconds a triangle, of frames that each remove one batch.
Percentiles remove_batches(const Method& method, const std::vector<Triangle>& triangles,
                           const std::vector<std::uint32_t>& order, std::size_t frames) {
  PlacedBuffer<Triangle> buffer(blank, method.removal);
  buffer.append(triangles);
  buffer.upload();
  glFinish();
  std::vector<double> times_us;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const std::span<const std::uint32_t> gone = std::span(order).subspan(frame * batch, batch);
    const Stopwatch watch;
    if (method.sends_each) {
      for (const std::uint32_t element : gone) {
        const std::uint32_t found = method.searches ? search(buffer, triangles[element]) : element;
        buffer.remove(std::span(&found, 1));
        buffer.upload();
      }
    } else {
      buffer.remove(gone);
      if (method.sends_all) send_all(buffer);
      buffer.upload();
    }
    glFinish();
    times_us.push_back(1000.0 * watch.worked_milliseconds() / static_cast<double>(batch));
  }
  return percentiles_of(times_us);
}

}  // namespace

void measure_removal(const BufferEffort& effort, BufferResults& results) {
  Table table{.name = "removal_7.11",
              .title = "Thesis 7.11: removing triangles, a batch of " + std::to_string(batch) +
                       " a frame [us of processor time a triangle]",
              .columns = {"method", "model", "mean", "SD", "median", "p99"},
              .rows = {},
              .notes = {"in an order drawn by chance, the same for all methods"}};
  BarChart chart{.title = "Thesis 7.11: time to remove a triangle",
                 .unit = "microseconds of processor time",
                 .groups = {},
                 .series = {}};
  const std::vector<Method> all = methods();
  for (const Method& method : all) chart.series.push_back({method.name, {}});
  for (const BufferModel& model : buffer_models(effort.is_quick)) {
    const std::vector<Triangle>& triangles = model.mesh.triangles;
    const std::vector<std::uint32_t> order = shuffled(triangles.size());
    const std::size_t frames = std::min<std::size_t>(triangles.size() / batch, 60);
    chart.groups.push_back(model.name + " " + std::to_string(triangles.size()));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Percentiles spread = remove_batches(all[i], triangles, order, frames);
      table.rows.push_back({all[i].name, chart.groups.back(), spread.mean, spread.deviation,
                            spread.median, spread.p99});
      chart.series[i].values.push_back(spread.median);
    }
  }
  results.tables.push_back(table);
  results.charts.push_back({"removal_7.11", draw_bars(chart)});
}

}  // namespace hallux::benchmarks

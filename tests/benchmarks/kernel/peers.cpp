// The table of peers: what every library does once with a plane or a slab, beside our contact and
// our slab.
#include <algorithm>
#include <cmath>

#include "simulator/cutting/solid/remove_slab.h"
#include "simulator/cutting/solid/slab_volume.h"
#include "tests/benchmarks/kernel/peer_runs.h"
#include "tests/benchmarks/kernel/results.h"
#include "tests/benchmarks/report/chart.h"
#include "tests/benchmarks/worlds/bone_like.h"

namespace hallux::benchmarks {

namespace {

using namespace simulator;

struct MeasuredWorld {
  std::string name;
  std::size_t triangles = 0;
  Outcomes outcomes;

  double median_ms(Method method) const { return outcomes.at(method).time_ms.median; }
};

/// The removed volume by a route that no method here shares: section areas over the slab's height.
double expected_removal_mm3(const BoneWorld& world) {
  const CutSolid solid = uncut_solid(world.mesh);
  const Section section = slice_section(solid, Bvh(solid.mesh), world.plane);
  return slab_volume_mm3(solid, section, std::vector<std::uint8_t>(section.regions.size(), 1));
}

MeasuredWorld measure(std::size_t wanted, bool is_hollow, Results& results) {
  const BoneWorld world{wanted, is_hollow, make_bone_like({wanted, is_hollow}), oblique_kerf()};
  MeasuredWorld measured{world.name(), world.mesh.triangles.size(), {}};
  run_vtk(world, measured.outcomes);
  run_cgal(world, measured.outcomes);
  run_thesis(world, measured.outcomes);
  run_ours(world, measured.outcomes);
  const double expected_mm3 = expected_removal_mm3(world);
  for (const NamedMethod& method : all_methods) {
    const Outcome& outcome = measured.outcomes.at(method.method);
    const std::string what = measured.name + ", " + method.text;
    if (outcome.removed_mm3) expect_volume(results, what, expected_mm3, *outcome.removed_mm3);
    if (!outcome.is_closed) results.faults.push_back(what + ": not closed");
  }
  return measured;
}

Table table_of_times(const std::vector<MeasuredWorld>& worlds) {
  Table table{
      .name = "peers",
      .title = "One cut of 0.5 mm through the shaft, each method once",
      .columns = {"bone", "triangles", "method", "runs", "median ms", "p99 ms", "removed mm3"},
      .rows = {},
      .notes = {}};
  for (const MeasuredWorld& world : worlds) {
    for (const NamedMethod& method : all_methods) {
      const Outcome& outcome = world.outcomes.at(method.method);
      table.rows.push_back({world.name, static_cast<double>(world.triangles), method.text,
                            static_cast<double>(outcome.time_ms.count), outcome.time_ms.median,
                            outcome.time_ms.p99,
                            outcome.removed_mm3 ? Cell(*outcome.removed_mm3) : Cell()});
    }
  }
  table.notes = {
      "Times are processor time, all threads together (every method here works on one).",
      "Outside the clock: our search tree, each peer's own mesh, and the copy that CGAL works on "
      "in place.",
      "Hallux's contact and slab leave the uncut triangles where they are: one mesh and a patch, "
      "not two compacted "
      "buffers. What that defers is in the row below it (and in commits, which are a job).",
      "The thesis's slice removes nothing and follows one shell: of a hollow bone it never reaches "
      "the canal.",
      "Removed volumes agree within a millionth with the section's area over the slab's height, or "
      "this run fails."};
  return table;
}

double fastest_split_ms(const MeasuredWorld& world) {
  return std::min({world.median_ms(Method::VtkHalves), world.median_ms(Method::CgalHalves),
                   world.median_ms(Method::CgalSplit)});
}

Table table_of_ratios(const std::vector<MeasuredWorld>& worlds) {
  Table table{
      .name = "peer_ratios",
      .title = "How many times faster, as ratios of medians in this run",
      .columns = {"bone", "contact : fastest split", "goal", "slab : VTK", "goal",
                  "slab : CGAL difference", "slab : CGAL clip", "goal", "contact : thesis's slice"},
      .rows = {},
      .notes = {"Goals are set for 50k and 500k triangles."}};
  for (const MeasuredWorld& world : worlds) {
    const double contact_ms = world.median_ms(Method::OurContact);
    const double slab_ms = world.median_ms(Method::OurSlab);
    const bool is_50k = world.name.rfind("50k", 0) == 0, is_500k = world.name.rfind("500k", 0) == 0;
    const auto goal = [&](double at_50k, double at_500k) {
      return is_50k ? Cell(at_50k) : is_500k ? Cell(at_500k) : Cell();
    };
    table.rows.push_back({world.name, fastest_split_ms(world) / contact_ms, goal(20.0, 50.0),
                          world.median_ms(Method::VtkHalves) / slab_ms, goal(10.0, 30.0),
                          world.median_ms(Method::CgalDifference) / slab_ms,
                          world.median_ms(Method::CgalHalves) / slab_ms, goal(50.0, 150.0),
                          world.median_ms(Method::ThesisSlice) / contact_ms});
  }
  return table;
}

NamedChart chart_of_times(const std::vector<MeasuredWorld>& worlds) {
  BarChart chart{"One cut of 0.5 mm through a bone's shaft: median time", "ms", {}, {}};
  for (const NamedMethod& method : all_methods) chart.series.push_back({method.text, {}});
  for (const MeasuredWorld& world : worlds) {
    chart.groups.push_back(world.name);
    for (std::size_t i = 0; i < all_methods.size(); ++i) {
      chart.series[i].values.push_back(world.median_ms(all_methods[i].method));
    }
  }
  return {"peers", draw_bars(chart)};
}

}  // namespace

void measure_peers(const Effort& effort, Results& results) {
  std::vector<MeasuredWorld> worlds;
  for (const std::size_t wanted : {5'000U, 50'000U, 500'000U, 2'000'000U}) {
    if (wanted > effort.greatest_mesh) continue;
    for (const bool is_hollow : {false, true})
      worlds.push_back(measure(wanted, is_hollow, results));
  }
  results.tables.push_back(table_of_times(worlds));
  results.tables.push_back(table_of_ratios(worlds));
  results.charts.push_back(chart_of_times(worlds));
}

}  // namespace hallux::benchmarks

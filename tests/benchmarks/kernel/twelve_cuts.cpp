// The thesis's chapter 7 again: twelve cuts across a foot and across a sphere, and the rate of the
// simulation's frames.
//
// Each cut lies across x, the next one 1/13 of the model's width further; the saw points along z,
// its width lies along y, and it is moved up and down and gradually forward along a sine. No
// picture is drawn: a frame is what the cut costs.
#include <algorithm>
#include <string>
#include <utility>

#include "simulator/cutting/solid/commit_patch.h"
#include "simulator/mesh/bvh.h"
#include "tests/benchmarks/kernel/our_cut.h"
#include "tests/benchmarks/kernel/results.h"
#include "tests/benchmarks/kernel/strokes.h"
#include "tests/benchmarks/peers/thesis_mesh.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/worlds/bone_like.h"
#include "tests/support/worlds.h"

namespace hallux::benchmarks {

namespace {

using namespace simulator;

constexpr int cut_count = 12;
constexpr std::size_t frames_per_cut = 400;
constexpr Blade saw{.width_mm = 12.0, .depth_mm = 60.0, .kerf_mm = 0.5};

struct Model {
  std::string name;
  IndexedMesh mesh;
  std::size_t bodies = 1;  ///< that hang together before the cuts; each cut parts each
};

struct Box {
  Vec3 low_mm{1e300}, high_mm{-1e300};
};

Box box_of(const IndexedMesh& mesh) {
  Box box;
  for (const Vec3& point_mm : mesh.points_mm) {
    box.low_mm = glm::min(box.low_mm, point_mm);
    box.high_mm = glm::max(box.high_mm, point_mm);
  }
  return box;
}

struct CutPlan {
  KerfPlane plane;
  SawingStroke stroke;
  FieldGrid grid;
};

/// The kerf's x is the feed (the model's -z), its y the saw's width (the model's y), its z the
/// model's x.
CutPlan plan_cut(const Box& box, int cut) {
  const Vec3 middle_mm = 0.5 * (box.low_mm + box.high_mm), size_mm = box.high_mm - box.low_mm;
  const double x_mm = box.low_mm.x + size_mm.x * (cut + 1) / (cut_count + 1);
  const Vec3 feed(0.0, 0.0, -1.0), normal(1.0, 0.0, 0.0);
  CutPlan plan;
  plan.plane = {
      {rotation_from_axes(feed, glm::cross(normal, feed)), Vec3(x_mm, middle_mm.y, middle_mm.z)},
      saw.kerf_mm};
  plan.stroke = {.reach_mm = 0.5 * size_mm.y,
                 .begin_mm = -0.5 * size_mm.z - 0.5,
                 .end_mm = 0.5 * size_mm.z + 0.5};
  const double half_mm = 0.5 * std::max(size_mm.y, size_mm.z) + 2.0;
  plan.grid.origin_mm = Vec2(-half_mm, -half_mm);
  plan.grid.u_count = plan.grid.v_count =
      static_cast<std::int32_t>(2.0 * half_mm / plan.grid.spacing_mm) + 1;
  return plan;
}

/// Milliseconds of the frames in which the saw changed something.
struct Frames {
  std::vector<double> alone_ms;  ///< what a frame itself costs
  /// What is done once in a cut (slice; commit, tree, parts) put into its first and last.
  std::vector<double> with_jobs_ms;
  std::size_t parts = 0, wanted_parts = 0;
  std::size_t folded = 0;  ///< triangles turned over
};

void add_cut(Frames& frames, const std::vector<double>& cut_ms, double before_ms, double after_ms) {
  if (cut_ms.empty()) return;
  frames.alone_ms.insert(frames.alone_ms.end(), cut_ms.begin(), cut_ms.end());
  std::vector<double> with_jobs_ms = cut_ms;
  with_jobs_ms.front() += before_ms;
  with_jobs_ms.back() += after_ms;
  frames.with_jobs_ms.insert(frames.with_jobs_ms.end(), with_jobs_ms.begin(), with_jobs_ms.end());
}

Frames cut_with_ours(const Model& model) {
  Frames frames;
  CutSolid solid = uncut_solid(model.mesh);
  const Box box = box_of(model.mesh);
  Bvh bvh(solid.mesh);
  for (int cut = 0; cut < cut_count; ++cut) {
    const CutPlan plan = plan_cut(box, cut);
    KerfField field(plan.grid);
    const Stopwatch before;
    OurCut ours(solid, bvh, plan.plane, field, cut);
    const double before_ms = before.worked_milliseconds();
    std::vector<double> cut_ms;
    for (const PlanarPose& pose : poses_of(plan.stroke, frames_per_cut)) {
      const Stopwatch watch;
      if (ours.advance(saw, pose)) cut_ms.push_back(watch.worked_milliseconds());
    }
    const Stopwatch after;
    solid = commit_patch(solid, ours.patch());
    bvh = Bvh(solid.mesh);
    add_cut(frames, cut_ms, before_ms, after.worked_milliseconds());
  }
  frames.parts = split_pieces(solid).size();
  frames.wanted_parts = model.bodies * (cut_count + 1);
  return frames;
}

/// What the blade touches first, looked for every 2 mm across its way.
std::vector<std::uint32_t> first_touches(const IndexedMesh& mesh, const CutPlan& plan) {
  const Bvh bvh(mesh);
  const Vec3 feed = transform_direction(plan.plane.bone_from_kerf, Vec3(1.0, 0.0, 0.0));
  std::vector<std::uint32_t> touches;
  for (double across_mm = -plan.stroke.reach_mm; across_mm < plan.stroke.reach_mm;
       across_mm += 2.0) {
    const Vec3 from_mm = transform_point(plan.plane.bone_from_kerf, Vec3(-100.0, across_mm, 0.0));
    if (const auto hit = bvh.first_hit(from_mm, feed)) touches.push_back(hit->triangle);
  }
  return touches;
}

Frames cut_with_thesis(const Model& model) {
  Frames frames;
  ThesisMesh mesh(model.mesh);
  const Box box = box_of(model.mesh);
  for (int cut = 0; cut < cut_count; ++cut) {
    const CutPlan plan = plan_cut(box, cut);
    const std::vector<std::uint32_t> touches = first_touches(mesh.mesh(), plan);
    const Stopwatch before;
    mesh.begin_cut(plan.plane, touches);
    const double before_ms = before.worked_milliseconds();
    std::vector<double> cut_ms;
    for (const PlanarPose& pose : poses_of(plan.stroke, frames_per_cut)) {
      const Stopwatch watch;
      if (mesh.advance(saw, pose) > 0) cut_ms.push_back(watch.worked_milliseconds());
    }
    frames.folded += mesh.folded_triangles();
    const Stopwatch after;
    frames.parts = mesh.count_parts();
    add_cut(frames, cut_ms, before_ms, after.worked_milliseconds());
  }
  return frames;
}

Percentiles rates_of(const std::vector<double>& times_ms) {
  std::vector<double> rates_per_s;
  for (const double time_ms : times_ms) rates_per_s.push_back(1000.0 / time_ms);
  return percentiles_of(rates_per_s);
}

double share_above_20(const std::vector<double>& times_ms) {
  const auto fast = std::count_if(times_ms.begin(), times_ms.end(),
                                  [](double time_ms) { return time_ms < 50.0; });
  return 100.0 * static_cast<double>(fast) / static_cast<double>(times_ms.size());
}

std::vector<Cell> row_of(const std::string& who, const std::vector<double>& times_ms) {
  const Percentiles rates = rates_of(times_ms);
  const double mean_ms = percentiles_of(times_ms).mean;
  return {who,
          static_cast<double>(times_ms.size()),
          rates.mean,
          rates.deviation,
          rates.least,
          rates.greatest,
          1000.0 / mean_ms,
          share_above_20(times_ms)};
}

/// Thesis tables 7.1 and 7.2, and the shares of its section 7.3.
void add_thesis_rows(Table& table) {
  const auto row = [&](const char* who, double mean, double deviation, double least,
                       double greatest, Cell share) {
    table.rows.push_back({who, {}, mean, deviation, least, greatest, {}, std::move(share)});
  };
  row("thesis 7.1: foot, fast machine, drawn", 60.98, 19.37, 5.99, 429.36, {});
  row("thesis 7.1: sphere, fast machine, drawn", 60.97, 14.61, 18.47, 313.31, {});
  row("thesis 7.1: both, fast machine, drawn", 60.98, 20.23, 2.29, 1000.0, 99.78);
  row("thesis 7.1: foot, slow machine, drawn", 51.21, 16.11, 0.23, 100.49, {});
  row("thesis 7.1: sphere, slow machine, drawn", 54.21, 11.19, 5.28, 121.78, {});
  row("thesis 7.1: both, slow machine, drawn", 52.74, 15.23, 0.1, 200.0, 95.77);
}

/// Thesis table 7.2: the mean less one, two and three deviations.
Table deviations_of(const Table& rates) {
  Table table{
      .name = "twelve_cuts_deviations",
      .title =
          "The same as the thesis's table 7.2: mean rate less 0, 1, 2 and 3 deviations [frames/s]",
      .columns = {"what", "mean", "-1 SD", "-2 SD", "-3 SD"},
      .rows = {},
      .notes = {"Rates are not distributed normally (nor were the thesis's): a negative entry says "
                "only that."}};
  for (const std::vector<Cell>& row : rates.rows) {
    const double mean = std::get<double>(row[2]), deviation = std::get<double>(row[3]);
    table.rows.push_back(
        {row[0], mean, mean - deviation, mean - 2.0 * deviation, mean - 3.0 * deviation});
  }
  return table;
}

}  // namespace

void measure_twelve_cuts(const Effort&, Results& results) {
  Table table{
      .name = "twelve_cuts",
      .title = "Twelve cuts: frames per second of the simulation",
      .columns = {"what", "frames", "mean", "SD", "min", "max", "frames : time", "above 20 [%]"},
      .rows = {},
      .notes = {"Rates from processor time, of frames in which the saw changed something. The "
                "thesis's own rates (its "
                "table 7.1) include drawing, on its own two machines.",
                "With jobs: contact, commit, search tree and parts are counted in the frame where "
                "they fall; in "
                "Hallux they run beside the frames."}};
  for (const Model& model : {Model{"foot", make_foot_like(120'000), 5},
                             Model{"sphere", tests::dense_sphere(20.0, 1'000), 1}}) {
    const std::string name = model.name + " of " + std::to_string(model.mesh.triangles.size());
    const Frames ours = cut_with_ours(model), thesis = cut_with_thesis(model);
    table.rows.push_back(row_of("Hallux: " + name, ours.alone_ms));
    table.rows.push_back(row_of("Hallux with jobs: " + name, ours.with_jobs_ms));
    table.rows.push_back(row_of("thesis's method: " + name, thesis.alone_ms));
    table.rows.push_back(row_of("thesis's method with slice: " + name, thesis.with_jobs_ms));
    table.notes.push_back(
        name + ": " + std::to_string(ours.parts) + " pieces from us; the thesis's method left " +
        std::to_string(thesis.parts) + " parts (canals are never reached) and turned over " +
        std::to_string(thesis.folded) + " triangles");
    if (ours.parts != ours.wanted_parts) {
      results.faults.push_back(name + ": " + std::to_string(ours.parts) +
                               " pieces after twelve cuts instead of " +
                               std::to_string(ours.wanted_parts));
    }
  }
  add_thesis_rows(table);
  results.tables.push_back(table);
  results.tables.push_back(deviations_of(table));
}

}  // namespace hallux::benchmarks

// What the thesis rejected: the blade subtracted pose by pose, by CGAL in exact numbers, beside our
// frames.
#include <algorithm>
#include <string>

#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/mesh/bvh.h"
#include "tests/benchmarks/kernel/our_cut.h"
#include "tests/benchmarks/kernel/results.h"
#include "tests/benchmarks/kernel/strokes.h"
#include "tests/benchmarks/peers/cgal_solid.h"
#include "tests/benchmarks/report/chart.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/worlds/bone_like.h"

namespace hallux::benchmarks {

namespace {

using namespace simulator;

struct Step {
  double time_ms = 0.0;
  std::size_t triangles = 0;  ///< of the whole solid
};

/// The blade's box at a pose.
IndexedMesh blade_at(const KerfPlane& plane, const Blade& blade, const PlanarPose& pose) {
  const Quat turn = rotation_from_axes(Vec3(pose.direction.x, pose.direction.y, 0.0),
                                       Vec3(-pose.direction.y, pose.direction.x, 0.0));
  const RigidTransform kerf_from_blade{turn, Vec3(pose.tip_mm.x, pose.tip_mm.y, 0.0)};
  const Vec3 half_mm(0.0, 0.5 * blade.width_mm, 0.5 * plane.thickness_mm);
  return box_in_kerf({plane.bone_from_kerf * kerf_from_blade, plane.thickness_mm},
                     Vec3(-blade.depth_mm, -half_mm.y, -half_mm.z), half_mm);
}

/// The shares of the stroke at which the blade is in bone, as our kernel finds them; what it costs
/// at each.
std::vector<Step> our_steps(const IndexedMesh& mesh, const std::vector<PlanarPose>& poses,
                            std::vector<PlanarPose>& in_bone) {
  const CutSolid bone = uncut_solid(mesh);
  const Bvh bvh(bone.mesh);
  KerfField field{FieldGrid{}};
  OurCut ours(bone, bvh, oblique_kerf(), field);
  std::vector<Step> steps;
  for (const PlanarPose& pose : poses) {
    const Stopwatch watch;
    const bool has_cut = ours.advance(swaying_blade, pose);
    const double time_ms = watch.worked_milliseconds();
    if (!has_cut) continue;
    in_bone.push_back(pose);
    steps.push_back({time_ms, mesh.triangles.size() - ours.patch().hidden.size() +
                                  ours.patch().triangles.size()});
  }
  return steps;
}

/// Subtracts pose by pose until the time is up; the last step is always finished.
std::vector<Step> exact_steps(const IndexedMesh& mesh, const std::vector<PlanarPose>& poses,
                              double limit_s) {
  CgalExactSolid bone(mesh);
  std::vector<Step> steps;
  const Stopwatch whole;
  for (const PlanarPose& pose : poses) {
    CgalExactSolid blade(blade_at(oblique_kerf(), swaying_blade, pose));
    const Stopwatch watch;
    bone.subtract(blade);
    steps.push_back({watch.worked_milliseconds(), bone.triangle_count()});
    if (whole.milliseconds() > 1000.0 * limit_s) break;
  }
  return steps;
}

std::vector<Cell> row_of(const std::string& method, const std::vector<Step>& steps,
                         std::size_t wanted) {
  std::vector<double> times_ms;
  for (const Step& step : steps) times_ms.push_back(step.time_ms);
  const std::size_t fifth = std::max<std::size_t>(1, steps.size() / 5);
  const auto part = [&](std::size_t first) {
    return percentiles_of({times_ms.begin() + static_cast<std::ptrdiff_t>(first),
                           times_ms.begin() + static_cast<std::ptrdiff_t>(first + fifth)})
        .median;
  };
  const Percentiles spread = percentiles_of(times_ms);
  return {method,
          std::to_string(steps.size()) + " of " + std::to_string(wanted),
          spread.median,
          part(0),
          part(steps.size() - fifth),
          spread.greatest,
          static_cast<double>(steps.front().triangles),
          static_cast<double>(steps.back().triangles)};
}

Series times_of(const std::string& name, const std::vector<Step>& steps) {
  Series series{name, {}};
  for (const Step& step : steps) series.values.push_back(step.time_ms);
  return series;
}

Series triangles_of(const std::string& name, const std::vector<Step>& steps) {
  Series series{name, {}};
  for (const Step& step : steps) series.values.push_back(static_cast<double>(step.triangles));
  return series;
}

}  // namespace

void measure_repeated_boolean(const Effort& effort, Results& results) {
  const IndexedMesh mesh = make_bone_like({5'000, true});
  std::vector<PlanarPose> in_bone;
  const std::vector<Step> ours = our_steps(mesh, poses_of(sway_through, 100), in_bone);
  if (ours.empty()) {
    results.faults.emplace_back("repeated Boolean: the blade met no bone");
    return;
  }
  std::vector<Step> exact = exact_steps(mesh, in_bone, effort.exact_boolean_limit_s);
  results.tables.push_back(
      {.name = "repeated_boolean",
       .title = "A blade in 100 poses, subtracted one by one, on 5k triangles hollow",
       .columns = {"method", "steps in bone", "median ms", "first fifth ms", "last fifth ms",
                   "max ms", "triangles, first", "triangles, last"},
       .rows = {row_of("CGAL corefinement, exact numbers (EPECK)", exact, in_bone.size()),
                row_of("Hallux: field, outline, patch", ours, in_bone.size())},
       .notes = {
           "CGAL stops after " + text_of(effort.exact_boolean_limit_s) +
               " s; with inexact numbers (EPICK) it must not be cut again and again: it hangs or "
               "fails.",
           "CGAL subtracts the blade at each pose, Hallux what the blade sweeps between poses."}});
  LineChart times{"One step of a cut, 5k triangles hollow", "step in bone", "ms", {}, {}};
  for (std::size_t i = 0; i < ours.size(); ++i) times.along.push_back(static_cast<double>(i + 1));
  LineChart triangles = times;
  triangles.title = "Triangles of the bone while it is cut";
  triangles.value_name = "triangles";
  times.series = {times_of("CGAL, exact", exact), times_of("Hallux", ours)};
  triangles.series = {triangles_of("CGAL, exact", exact), triangles_of("Hallux", ours)};
  results.charts.push_back({"repeated_boolean_times", draw_lines(times)});
  results.charts.push_back({"repeated_boolean_triangles", draw_lines(triangles)});
}

}  // namespace hallux::benchmarks

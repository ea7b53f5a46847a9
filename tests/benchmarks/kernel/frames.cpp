// A whole cut, frame by frame: what a frame costs must follow the section, not the steps taken so
// far.
#include <algorithm>
#include <cmath>
#include <string>

#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/mesh/bvh.h"
#include "tests/benchmarks/kernel/our_cut.h"
#include "tests/benchmarks/kernel/results.h"
#include "tests/benchmarks/kernel/strokes.h"
#include "tests/benchmarks/report/chart.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/worlds/bone_like.h"

namespace hallux::benchmarks {

namespace {

using namespace simulator;

struct Cut {
  std::string bone;
  std::size_t steps = 0;
  std::vector<double> frame_ms;    ///< of the frames that changed something
  std::vector<double> worked_ms;   ///< the same as processor time
  std::vector<double> share;       ///< of the stroke, beside frame_ms
  std::vector<double> hundredths;  ///< patch triangles after each hundredth of the stroke
  std::vector<FrameParts> parts;   ///< beside frame_ms
  double contact_ms = 0.0;
  std::size_t greatest_patch = 0;  ///< triangles
  std::size_t last_patch = 0;
  std::uint64_t refusals = 0;
};

/// Grows a cut in `steps` frames, a multiple of 100; frames that took nothing are not counted.
Cut make_cut(const BoneLike& wanted, std::size_t steps, Results& results) {
  const CutSolid bone = uncut_solid(make_bone_like(wanted));
  const Bvh bvh(bone.mesh);
  KerfField field{FieldGrid{}};
  Cut cut;
  cut.bone = std::to_string(wanted.triangles / 1'000) + (wanted.is_hollow ? "k hollow" : "k solid");
  cut.steps = steps;
  const Stopwatch contact_watch;
  OurCut ours(bone, bvh, oblique_kerf(), field);
  cut.contact_ms = contact_watch.milliseconds();
  const std::vector<PlanarPose> poses = poses_of(sway_through, steps);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Stopwatch watch;
    const bool has_cut = ours.advance(swaying_blade, poses[i]);
    const double frame_ms = watch.milliseconds(), worked_ms = watch.worked_milliseconds();
    const auto triangles = static_cast<double>(ours.patch().triangles.size());
    if (i % (steps / 100) == 0 && triangles > 0.0) cut.hundredths.push_back(triangles);
    if (!has_cut) continue;
    cut.frame_ms.push_back(frame_ms);
    cut.worked_ms.push_back(worked_ms);
    cut.parts.push_back(ours.parts());
    cut.share.push_back(static_cast<double>(i) / static_cast<double>(steps));
    cut.greatest_patch = std::max(cut.greatest_patch, ours.patch().triangles.size());
  }
  cut.last_patch = ours.patch().triangles.size();
  cut.refusals = ours.refusals();
  if (cut.frame_ms.empty() || cut.refusals > 0) {
    results.faults.push_back(cut.bone + ": a frame was refused, or the blade met no bone");
  }
  return cut;
}

/// The median frame in each fiftieth of the stroke; 0 where there is none.
Series course_of(const Cut& cut) {
  constexpr std::size_t part_count = 50;
  std::vector<std::vector<double>> parts(part_count);
  for (std::size_t i = 0; i < cut.frame_ms.size(); ++i) {
    const auto part = static_cast<std::size_t>(cut.share[i] * part_count);
    parts[std::min(part, part_count - 1)].push_back(cut.worked_ms[i]);
  }
  Series series{cut.bone + ", " + std::to_string(cut.steps) + " steps", {}};
  for (std::vector<double>& part : parts) series.values.push_back(percentiles_of(part).median);
  return series;
}

Table table_of(const std::vector<Cut>& cuts) {
  Table table{
      .name = "frames",
      .title =
          "Frames of a cut: field, outline, patch and upload buffers, until the shaft is cut "
          "through",
      .columns = {"bone", "steps", "frames in bone", "contact ms", "median ms", "p99 ms", "max ms",
                  "median worked ms", "p99 worked ms", "goal median", "goal p99",
                  "patch triangles, last", "patch triangles, most"},
      .rows = {},
      .notes = {
          "A frame is everything that makes the changed bone ready for upload, on one thread.",
          "The contact is made once, by a job."}};
  for (const Cut& cut : cuts) {
    const Percentiles spread = percentiles_of(cut.frame_ms), worked = percentiles_of(cut.worked_ms);
    const bool is_50k = cut.bone == "50k hollow", is_500k = cut.bone.rfind("500k", 0) == 0;
    table.rows.push_back(
        {cut.bone, static_cast<double>(cut.steps), static_cast<double>(spread.count),
         cut.contact_ms, spread.median, spread.p99, spread.greatest, worked.median, worked.p99,
         is_50k ? Cell(0.2) : Cell(),
         is_50k    ? Cell(0.5)
         : is_500k ? Cell(1.5)
                   : Cell(),
         static_cast<double>(cut.last_patch), static_cast<double>(cut.greatest_patch)});
  }
  return table;
}

/// Where the time of a frame goes.
Table table_of_parts(const std::vector<Cut>& cuts) {
  Table table{.name = "frame_parts",
              .title = "Where a frame's processor time goes: medians [us]",
              .columns = {"bone", "steps", "field", "outline", "patch", "upload buffers"},
              .rows = {},
              .notes = {}};
  for (const Cut& cut : cuts) {
    const auto median_us = [&](double FrameParts::*part) {
      std::vector<double> times_us;
      for (const FrameParts& parts : cut.parts) times_us.push_back(1000.0 * parts.*part);
      return percentiles_of(times_us).median;
    };
    table.rows.push_back({cut.bone, static_cast<double>(cut.steps),
                          median_us(&FrameParts::field_ms), median_us(&FrameParts::outline_ms),
                          median_us(&FrameParts::patch_ms), median_us(&FrameParts::buffers_ms)});
  }
  return table;
}

/// The same end reached in few steps and in many: the ratio of cost and of triangles.
void compare(const Cut& few, const Cut& many, Table& table, Results& results) {
  const double cost = percentiles_of(many.worked_ms).median / percentiles_of(few.worked_ms).median;
  const double triangles =
      percentiles_of(many.hundredths).mean / percentiles_of(few.hundredths).mean;
  table.notes.push_back(
      few.bone + ", " + std::to_string(many.steps) + " against " + std::to_string(few.steps) +
      " steps: median work of a frame x " + text_of(cost) +
      "; patch triangles, mean over the hundredths of the stroke, x " + text_of(triangles));
  if (std::abs(triangles - 1.0) > 0.1) {
    results.faults.push_back(few.bone + ": the patch's size depends on the number of steps");
  }
}

}  // namespace

void measure_frames(const Effort& effort, Results& results) {
  std::vector<Cut> cuts;
  for (const BoneLike bone : {BoneLike{5'000, true}, BoneLike{50'000, false},
                              BoneLike{50'000, true}, BoneLike{500'000, true}}) {
    if (bone.triangles > effort.greatest_mesh) continue;
    for (const std::size_t steps : {std::size_t{100}, effort.many_steps}) {
      cuts.push_back(make_cut(bone, steps, results));
    }
  }
  Table table = table_of(cuts);
  LineChart chart{
      "A frame along the stroke: median of each fiftieth", "part of the stroke [%]", "ms", {}, {}};
  for (int part = 0; part < 50; ++part) chart.along.push_back(2.0 * part + 1.0);
  for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
    compare(cuts[i], cuts[i + 1], table, results);
    chart.series.push_back(course_of(cuts[i]));
    chart.series.push_back(course_of(cuts[i + 1]));
  }
  results.tables.push_back(std::move(table));
  results.tables.push_back(table_of_parts(cuts));
  results.charts.push_back({"frames", draw_lines(chart)});
}

}  // namespace hallux::benchmarks

// A cut that is done, in two ways: bone cut anew, kerf by kerf, as plain triangles (decision 0004), and
// half-edges into which each patch is put in place (WorkingSolid).
//
// Both slice, outline and patch alike. They differ in what a frame hides, in what a cut costs that is
// done, in what an earlier kerf costs that goes on, and in what lies in memory.
#include <malloc.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "simulator/cutting/solid/commit_patch.h"
#include "simulator/cutting/solid/working_solid.h"
#include "simulator/mesh/bvh.h"
#include "tests/benchmarks/kernel/our_cut.h"
#include "tests/benchmarks/kernel/strokes.h"
#include "tests/benchmarks/report/spread.h"
#include "tests/benchmarks/report/table.h"
#include "tests/benchmarks/worlds/bone_like.h"

namespace hallux::benchmarks {

namespace {

using namespace simulator;

constexpr std::size_t frames_per_kerf = 100;
constexpr int runs = 5;

double used_mib() {
  const struct mallinfo2 used = mallinfo2();
  return static_cast<double>(used.uordblks + used.hblkhd) / (1024.0 * 1024.0);
}

/// Twelve planes along the bone, each askew as oblique_kerf.
KerfPlane plane_of(std::int32_t kerf) {
  KerfPlane plane = oblique_kerf();
  plane.bone_from_kerf.translation_mm.x = -22.0 + 4.0 * kerf;
  return plane;
}

/// What one way of committing cost.
struct Cost {
  std::vector<double> frame_ms;
  std::vector<double> commit_ms;  ///< until the next contact can be sliced: solid and tree
  std::vector<double> put_ms;     ///< of that, the patch put into the solid
  std::vector<double> again_ms;   ///< the first kerf goes on: every kerf is done again
  double memory_mib = 0.0;
  CutSolid solid;
};

struct Stage {
  CutSolid solid;
  std::unique_ptr<const Bvh> bvh;
};

Stage stage_of(CutSolid solid) {
  Stage stage{std::move(solid), nullptr};
  stage.bvh = std::make_unique<const Bvh>(stage.solid.mesh);
  return stage;
}

/// The kerfs' final outlines, so that a repetition costs what a job costs.
struct Outlines {
  std::vector<RegionOutline> outlines;
};

void cut_anew(const IndexedMesh& mesh, std::int32_t kerfs, Cost& cost, Outlines& outlines) {
  const double before_mib = used_mib();
  std::vector<Stage> stages;
  stages.push_back(stage_of(uncut_solid(mesh)));
  for (std::int32_t kerf = 0; kerf < kerfs; ++kerf) {
    const Stage& stage = stages.back();
    KerfField field{FieldGrid{}};
    OurCut cut(stage.solid, *stage.bvh, plane_of(kerf), field, kerf);
    for (const PlanarPose& pose : poses_of(sway_through, frames_per_kerf)) {
      const Stopwatch watch;
      if (cut.advance(swaying_blade, pose)) cost.frame_ms.push_back(watch.worked_milliseconds());
    }
    const Stopwatch watch;
    CutSolid committed = commit_patch(stage.solid, cut.patch());
    const double put_ms = watch.worked_milliseconds();
    stages.push_back(stage_of(std::move(committed)));
    if (kerf + 1 == kerfs) {
      cost.put_ms.push_back(put_ms);
      cost.commit_ms.push_back(watch.worked_milliseconds());
    }
    OutlineTracker tracker(field.grid());
    tracker.update(field);
    outlines.outlines.push_back(tracker.outline());
  }
  cost.memory_mib = used_mib() - before_mib;
  cost.solid = stages.back().solid;
}

void again_anew(const IndexedMesh& mesh, const Outlines& outlines, Cost& cost) {
  const CutSolid whole = uncut_solid(mesh);
  const Bvh whole_bvh(whole.mesh);
  const FieldGrid grid;
  const Stopwatch watch;
  Stage stage;
  for (std::size_t i = 0; i < outlines.outlines.size(); ++i) {
    const auto kerf = static_cast<std::int32_t>(i);
    const CutSolid& solid = i == 0 ? whole : stage.solid;
    const Bvh& bvh = i == 0 ? whole_bvh : *stage.bvh;
    const KerfContact contact = slice_contact(solid, bvh, plane_of(kerf), kerf, grid);
    PatchBuilder builder(contact);
    SolidPatch patch;
    builder.build(outlines.outlines[i], patch);
    stage = stage_of(commit_patch(solid, patch));
  }
  cost.again_ms.push_back(watch.worked_milliseconds());
}

void cut_in_place(const IndexedMesh& mesh, std::int32_t kerfs, Cost& cost) {
  const double before_mib = used_mib();
  const CutSolid whole = uncut_solid(mesh);
  auto working = std::make_unique<WorkingSolid>(whole);
  IndexedSolid base = working->indexed();
  auto bvh = std::make_unique<const Bvh>(base.solid.mesh);
  for (std::int32_t kerf = 0; kerf < kerfs; ++kerf) {
    KerfField field{FieldGrid{}};
    OurCut cut(base.solid, *bvh, plane_of(kerf), field, kerf);
    for (const PlanarPose& pose : poses_of(sway_through, frames_per_kerf)) {
      const Stopwatch watch;
      const bool has_cut = cut.advance(swaying_blade, pose);
      if (has_cut) working->show(cut.patch(), base);
      if (has_cut) cost.frame_ms.push_back(watch.worked_milliseconds());
    }
    const Stopwatch watch;
    if (working->commit(cut.patch(), base) == CommitOutcome::NoRoom) {
      std::cerr << "no room after " << kerf << " kerfs\n";
      working = std::make_unique<WorkingSolid>(commit_patch(base.solid, cut.patch()));
    }
    const double put_ms = watch.worked_milliseconds();
    base = working->indexed();
    bvh = std::make_unique<const Bvh>(base.solid.mesh);
    if (kerf + 1 == kerfs) {
      cost.put_ms.push_back(put_ms);
      cost.commit_ms.push_back(watch.worked_milliseconds());
    }
  }
  cost.memory_mib = used_mib() - before_mib;
  cost.solid = base.solid;
}

void again_in_place(const IndexedMesh& mesh, const Outlines& outlines, Cost& cost) {
  const CutSolid whole = uncut_solid(mesh);
  const FieldGrid grid;
  const Stopwatch watch;
  auto working = std::make_unique<WorkingSolid>(whole);
  IndexedSolid base = working->indexed();
  auto bvh = std::make_unique<const Bvh>(base.solid.mesh);
  for (std::size_t i = 0; i < outlines.outlines.size(); ++i) {
    const auto kerf = static_cast<std::int32_t>(i);
    const KerfContact contact = slice_contact(base.solid, *bvh, plane_of(kerf), kerf, grid);
    PatchBuilder builder(contact);
    SolidPatch patch;
    builder.build(outlines.outlines[i], patch);
    if (working->commit(patch, base) == CommitOutcome::NoRoom) {
      working = std::make_unique<WorkingSolid>(commit_patch(base.solid, patch));
    }
    base = working->indexed();
    bvh = std::make_unique<const Bvh>(base.solid.mesh);
  }
  cost.again_ms.push_back(watch.worked_milliseconds());
}

std::vector<Cell> row_of(const std::string& bone, std::int32_t kerfs, const char* how,
                         const Cost& cost) {
  const Spread frame = spread_of(cost.frame_ms);
  return {bone,
          static_cast<double>(kerfs),
          how,
          frame.median,
          frame.p99,
          spread_of(cost.put_ms).median,
          spread_of(cost.commit_ms).median,
          spread_of(cost.again_ms).median,
          cost.memory_mib};
}

/// Whether both ways left the same solid.
bool measure(std::size_t triangles, std::int32_t kerfs, Table& table) {
  const IndexedMesh mesh = make_bone_like({triangles, true});
  Cost anew, in_place;
  for (int run = 0; run < runs; ++run) {
    Outlines outlines;
    cut_anew(mesh, kerfs, anew, outlines);
    malloc_trim(0);
    cut_in_place(mesh, kerfs, in_place);
    malloc_trim(0);
    again_anew(mesh, outlines, anew);
    again_in_place(mesh, outlines, in_place);
  }
  const std::string bone = std::to_string(triangles / 1'000) + "k hollow";
  table.rows.push_back(row_of(bone, kerfs, "cut anew", anew));
  table.rows.push_back(row_of(bone, kerfs, "in place", in_place));
  return anew.solid.mesh.triangles.size() == in_place.solid.mesh.triangles.size();
}

int run_all() {
  Table table{
      .name = "commits",
      .title = "A cut that is done: bone cut anew, and half-edges changed in place",
      .columns = {"bone", "kerfs", "how", "frame median ms", "frame p99 ms", "patch put in ms",
                  "commit with tree ms", "first kerf goes on ms", "memory MiB"},
      .rows = {},
      .notes = {}};
  bool is_same = true;
  for (const std::size_t triangles : {std::size_t{50'000}, std::size_t{500'000}}) {
    for (const std::int32_t kerfs : {1, 2, 6, 12}) {
      is_same = measure(triangles, kerfs, table) && is_same;
    }
  }
  std::cout << "calibration " << calibration_ms() << " ms\n";
  print_table(std::cout, table);
  if (!is_same) std::cerr << "wrong: the two ways left different solids\n";
  return is_same ? 0 : 1;
}

}  // namespace

}  // namespace hallux::benchmarks

int main() { return hallux::benchmarks::run_all(); }

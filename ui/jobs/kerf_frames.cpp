#include "ui/jobs/kerf_frames.h"

#include <algorithm>
#include <string>

#include "simulator/base/progress.h"
#include "simulator/cutting/solid/opened_volume.h"

namespace hallux::ui {

namespace {

using namespace simulator;

constexpr std::uint32_t nudges_at_most = 8;  // as cut_kerf promises

using Milliseconds = std::chrono::duration<double, std::milli>;

RegionOutline outline_around(const FieldGrid& grid) {
  const Vec2 size_mm = grid.spacing_mm * Vec2(grid.u_count - 1, grid.v_count - 1);
  const Vec2& low = grid.origin_mm;
  return {{low, low + Vec2(size_mm.x, 0.0), low + size_mm, low + Vec2(0.0, size_mm.y)}, {4}};
}

}  // namespace

KerfFrames::KerfFrames(const CutSolid& solid, OpenedKerf& kerf, GroupOutcome& outcome)
    : solid_(solid),
      kerf_(kerf),
      outcome_(outcome),
      bvh_(solid.mesh),
      start_(Clock::now()),
      contact_(slice_contact(solid, bvh_, kerf.plane, static_cast<std::int32_t>(kerf.number),
                             kerf.grid)),
      builder_(contact_) {
  outcome_.contact_ms = Milliseconds(Clock::now() - start_).count();
}

void KerfFrames::build(const RegionOutline& region) {
  is_refused_ = !builder_.build(region, patch_);
  if (is_refused_) ++outcome_.refused_frames;
  outcome_.triangles_max = std::max(outcome_.triangles_max, patch_.triangles.size());
}

void KerfFrames::follow(const BladePath& path, const Progress& progress) {
  OutlineTracker tracker(kerf_.grid);
  tracker.update(*kerf_.field);
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    report(progress, static_cast<double>(i) / static_cast<double>(path.poses.size()));
    const auto start = Clock::now();
    stamp_motion(*kerf_.field, path.blade, path.poses[i == 0 ? 0 : i - 1], path.poses[i]);
    tracker.update(*kerf_.field);
    build(tracker.outline());
    outcome_.frame_ms.push_back(Milliseconds(Clock::now() - start).count());
  }
  kerf_.region = tracker.outline();
}

void KerfFrames::open_all() {
  kerf_.field.reset();
  kerf_.region = outline_around(kerf_.grid);
  build(kerf_.region);
}

KerfCut KerfFrames::commit() {
  if (is_refused_) {
    KerfCut cut = cut_opened_kerf(solid_, bvh_, kerf_);
    outcome_.nudges = cut.nudges;
    return cut;
  }
  KerfCut cut;
  cut.removed_mm3 = opened_volume_mm3(solid_, kerf_.plane, kerf_.region);
  cut.takes_section = builder_.takes_section();
  cut.solid = patch_.hidden.empty() ? solid_ : commit_patch(solid_, patch_);
  return cut;
}

KerfCut cut_opened_kerf(const CutSolid& solid, const Bvh& bvh, const OpenedKerf& kerf) {
  KerfCut cut = cut_kerf(solid, bvh, kerf.plane, static_cast<std::int32_t>(kerf.number), kerf.grid,
                         kerf.region);
  if (cut.nudges <= nudges_at_most) return cut;
  throw KernelRefusal("group " + std::to_string(kerf.number + 1) +
                      ": no closed solid could be built for what its blade opened, and nothing was "
                      "written; move its plane by 0.01 mm, and keep these files for a report");
}

}  // namespace hallux::ui

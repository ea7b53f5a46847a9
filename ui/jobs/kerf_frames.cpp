#include "ui/jobs/kerf_frames.h"

#include <algorithm>
#include <chrono>
#include <string>

#include "simulator/base/progress.h"
#include "simulator/bone/growing_kerf.h"
#include "ui/jobs/cut_sweep.h"

namespace hallux::ui {

namespace {

using namespace simulator;

using Clock = std::chrono::steady_clock;

double milliseconds_since(const Clock::time_point& start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// The frames of the kerf that was begun.
class KerfFrames {
 public:
  KerfFrames(SawnBone& bone, GroupOutcome& outcome)
      : bone_(bone),
        outcome_(outcome),
        stands_(bone.stands()),
        start_(Clock::now()),
        growing_(stands_, bone.begun().plane, bone.begun().number, bone.begun().grid) {
    outcome_.contact_ms = milliseconds_since(start_);
  }

  /// What the blade opened in the end.
  RegionOutline open_along(const BladePath& path, const Progress& progress) {
    KerfField& field = bone_.field();
    for (std::size_t i = 0; i < path.poses.size(); ++i) {
      hallux::report(progress, static_cast<double>(i) / static_cast<double>(path.poses.size()));
      const auto start = Clock::now();
      stamp_motion(field, path.blade, path.poses[i == 0 ? 0 : i - 1], path.poses[i]);
      note(growing_.build(field, patch_));
      outcome_.frame_ms.push_back(milliseconds_since(start));
    }
    return growing_.region();
  }

  RegionOutline open_all() {
    RegionOutline region = bone_.open_all();
    note(growing_.build(region, patch_));
    return region;
  }

 private:
  void note(bool is_built) {
    if (!is_built) ++outcome_.refused_frames;
    outcome_.triangles_max = std::max(outcome_.triangles_max, patch_.triangles.size());
  }

  SawnBone& bone_;
  GroupOutcome& outcome_;
  SolidWithTree stands_;
  Clock::time_point start_;
  GrowingKerf growing_;
  SolidPatch patch_;
};

/// A frame that was refused is built again beside it (see cut_kerf); where that does not help,
/// nothing is written.
void commit(SawnBone& bone, RegionOutline region, GroupOutcome& outcome) {
  outcome.nudges = bone.commit(std::move(region)).nudges;
  const std::optional<std::size_t> refused = bone.refused_kerf();
  if (!refused) return;
  throw KernelRefusal("group " + std::to_string(*refused + 1) +
                      ": no closed solid could be built for what its blade opened, and nothing was "
                      "written; move its plane by 0.01 mm, and keep these files for a report");
}

/// Said with the name of the file that the sweep came from.
BegunKerf begin(SawnBone& bone, const CutGroup& group, const KerfPlane& asked) {
  if (!group.sweep_file) return bone.begin(asked, false);
  try {
    return bone.begin(asked, true);
  } catch (const MeshError& error) {
    throw CutInputError(group.sweep_file->filename().string() + ": " + error.what());
  }
}

}  // namespace

GroupOutcome saw(SawnBone& bone, const CutGroup& group, const Progress& progress) {
  const KerfPlane asked = bone.plane_of(group.normal, group.offset, group.kerf_mm);
  std::optional<Sweep> sweep;
  if (group.sweep_file) {
    sweep = read_sweep(*group.sweep_file);
    expect_in_plane(*sweep, asked, group.sweep_file->filename().string());
  }
  const double before_mm3 = bone.removed_mm3();
  const BegunKerf begun = begin(bone, group, asked);
  GroupOutcome outcome;
  outcome.kerf = begun.number;
  if (!begun.can_open) return outcome;
  KerfFrames frames(bone, outcome);
  RegionOutline region =
      sweep ? frames.open_along(path_in_plane(*sweep, bone.begun().plane), progress)
            : frames.open_all();
  commit(bone, std::move(region), outcome);
  outcome.removed_mm3 = bone.removed_mm3() - before_mm3;
  return outcome;
}

}  // namespace hallux::ui

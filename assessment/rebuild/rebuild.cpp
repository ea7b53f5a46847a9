#include "assessment/rebuild/rebuild.h"

#include <algorithm>
#include <span>
#include <utility>

#include "assessment/rebuild/fragment_solids.h"
#include "assessment/rebuild/open_kerfs.h"
#include "simulator/base/check.h"
#include "simulator/jobs/lying_bones.h"

namespace hallux::assessment {

namespace {

using simulator::Recording;
using simulator::ToolSample;
using simulator::ToolStatus;

/// Stamping takes about this share of the time; the rest is cutting solids.
constexpr double stamping_share = 0.5;
constexpr std::size_t samples_per_report = 4096;
/// What is not removed is not done, however little is missing.
constexpr double almost_done = 0.999;

void note_cutting(RebuiltBone& rebuilt, const ToolSample& sample) {
  const bool is_of_kerf = sample.kerf >= 0 && sample.kerf < rebuilt.fields.count();
  if (!is_of_kerf || !has(sample.status, ToolStatus::Cutting)) return;
  RebuiltKerf& kerf = rebuilt.kerfs[static_cast<std::size_t>(sample.kerf)];
  if (kerf.cutting_samples++ == 0) kerf.first_cutting_tick = sample.tick;
  kerf.last_cutting_tick = sample.tick;
}

RebuiltKerf frozen_at(std::int64_t tick) {
  RebuiltKerf kerf;
  kerf.frozen_tick = kerf.first_cutting_tick = kerf.last_cutting_tick = tick;
  return kerf;
}

void stamp_kerfs(RebuiltBone& rebuilt, const Recording& recording, const SampleFollower& follow,
                 const Progress& progress) {
  const auto count = static_cast<double>(recording.samples.size());
  open_kerfs(
      rebuilt.fields, recording,
      [&](std::int64_t tick) { rebuilt.kerfs.push_back(frozen_at(tick)); },
      [&](std::size_t index, std::span<const simulator::RisenKerf>) {
        note_cutting(rebuilt, recording.samples[index]);
        if (follow) follow(recording.samples[index], rebuilt.fields);
        if (index % samples_per_report == 0)
          report(progress, stamping_share * static_cast<double>(index) / count);
      });
}

void put_kerfs(RebuiltBone& rebuilt, const Recording& recording, const OpenedFields& opened) {
  freeze_kerfs(
      rebuilt.fields, recording,
      [&](std::int64_t tick) { rebuilt.kerfs.push_back(frozen_at(tick)); },
      [&](std::size_t index) { note_cutting(rebuilt, recording.samples[index]); });
  for (std::size_t kerf = 0; kerf < opened.size(); ++kerf) {
    rebuilt.fields.put(static_cast<std::int32_t>(kerf), opened[kerf].window,
                       opened[kerf].inside_mm);
  }
}

}  // namespace

double RebuiltKerf::done_fraction() const noexcept {
  for (std::size_t region = 0; region < is_touched.size(); ++region) {
    if (is_removed[region] != 0) return 1.0;
    if (is_touched[region] != 0) return std::min(opened_fraction[region], almost_done);
  }
  return 0.0;
}

std::size_t bone_of(const RebuiltBone& rebuilt, std::int32_t kerf) noexcept {
  return static_cast<std::size_t>(
      rebuilt.fields.fragments()[rebuilt.fields.fragment_of(kerf)].bone);
}

simulator::KerfNumbers kerfs_of_bone(const RebuiltBone& rebuilt, std::size_t bone) noexcept {
  simulator::KerfNumbers kerfs;
  for (std::int32_t kerf = 0; kerf < rebuilt.fields.count(); ++kerf) {
    if (bone_of(rebuilt, kerf) == bone) kerfs.add(kerf);
  }
  return kerfs;
}

bool RebuiltKerf::is_finished() const noexcept { return done_fraction() == 1.0; }

RebuiltBone rebuild(simulator::Bones bones, const simulator::Tray& tray,
                    const simulator::Recording& recording, const Progress& progress,
                    const OpenedFields* opened, const SampleFollower& follow,
                    const ClosedHinges& hinges) {
  RebuiltBone rebuilt{simulator::KerfSet(tray, poses_of(bones))};
  if (opened != nullptr) {
    CHECK(!follow);
    CHECK(are_of(*opened, tray, bones, recording));
    put_kerfs(rebuilt, recording, *opened);
  } else {
    stamp_kerfs(rebuilt, recording, follow, progress);
  }
  FragmentSolids solids(rebuilt, bones, hinges);
  solids.follow(recording, [&](double share) {
    report(progress, stamping_share + (1.0 - stamping_share) * share);
  });
  report(progress, 1.0);
  return rebuilt;
}

}  // namespace hallux::assessment

#include "assessment/heat_track.h"

#include "simulator/base/check.h"
#include "simulator/cutting/kerf_set.h"

namespace hallux::assessment {

namespace {

using simulator::CutEventKind;

constexpr std::size_t samples_per_report = 4096;

}  // namespace

HeatTrack follow_heat(const simulator::Bone& bone, const simulator::BladeSize& blade,
                      double cycles_per_minute, const simulator::Recording& recording,
                      std::size_t stretch, const Progress& progress) {
  CHECK(stretch > 0);
  const simulator::TissueMap tissue(bone);
  simulator::KerfSet kerfs(blade, bone.world_from_bone);
  simulator::HeatField heat(blade, bone.world_from_bone, cycles_per_minute);
  HeatTrack track;
  auto event = recording.events.begin();
  const std::size_t count = recording.samples.size();
  for (std::size_t index = 0; index < count; ++index) {
    const simulator::ToolSample& sample = recording.samples[index];
    for (; event != recording.events.end() && event->tick <= sample.tick; ++event) {
      if (event->kind == CutEventKind::PlaneFrozen) kerfs.freeze(event->pose);
    }
    kerfs.follow(sample);
    heat.follow(sample, {tissue, kerfs, {}});
    const bool ends_stretch = (index + 1) % stretch == 0 || index + 1 == count;
    if (ends_stretch) track.hottest_celsius.push_back(heat.hottest_now_celsius());
    if (index % samples_per_report == 0) {
      report(progress, static_cast<double>(index) / static_cast<double>(count));
    }
  }
  track.summary = heat.summary();
  report(progress, 1.0);
  return track;
}

}  // namespace hallux::assessment

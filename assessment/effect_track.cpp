#include "assessment/effect_track.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "assessment/process/standing_wound.h"
#include "assessment/rebuild/open_kerfs.h"
#include "simulator/base/check.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/jobs/lying_bones.h"

namespace hallux::assessment {

namespace {

constexpr std::size_t samples_per_report = 4096;

}  // namespace

EffectTrack track_effects(simulator::Bones bones, const simulator::Tray& tray, bool is_guided,
                          const simulator::Recording& recording, std::size_t stretch,
                          const Progress& progress) {
  CHECK(stretch > 0);
  const BoneTissues tissues(bones);
  simulator::KerfSet kerfs(tray, poses_of(bones));
  simulator::ToolEffects effects(bones.first().world_from_bone, {tray.first_saw(), is_guided});
  std::int32_t tool = 0;
  EffectTrack track;
  const std::size_t count = recording.samples.size();
  open_kerfs(
      kerfs, recording, [](std::int64_t) {},
      [&](std::size_t index, std::span<const simulator::RisenKerf>) {
        if (kerfs.tool() != tool) effects.hold(tray[tool = kerfs.tool()]);
        effects.apply(recording.samples[index], standing_wound(tissues, kerfs));
        track.greatest_deflection_mm =
            std::max(track.greatest_deflection_mm, std::abs(effects.flex().deflection_mm));
        const bool ends_stretch = (index + 1) % stretch == 0 || index + 1 == count;
        if (ends_stretch) track.hottest_celsius.push_back(effects.heat().hottest_now_celsius());
        if (index % samples_per_report == 0)
          report(progress, static_cast<double>(index) / static_cast<double>(count));
      });
  track.heat = effects.heat().summary();
  report(progress, 1.0);
  return track;
}

}  // namespace hallux::assessment

#include "assessment/process/wrong_bones.h"

#include <algorithm>

namespace hallux::assessment {

namespace {

bool is_operated_on(const scenarios::Plan& plan, std::size_t bone) noexcept {
  return std::ranges::any_of(plan.cuts,
                             [bone](const scenarios::PlannedCut& cut) { return cut.bone == bone; });
}

/// The blade was led into bone there: it has been in this kerf since the kerf began. One that a cut
/// has in a further fragment begins while the blade is in another kerf.
bool is_begun_there(const simulator::Recording& recording, const RebuiltKerf& kerf,
                    std::int32_t number) {
  const auto& samples = recording.samples;
  const auto found =
      std::ranges::lower_bound(samples, kerf.frozen_tick, {}, &simulator::ToolSample::tick);
  return found != samples.end() && found->kerf == number;
}

}  // namespace

Finding measure_wrong_bones(const Evidence& evidence) {
  const RebuiltBone& rebuilt = evidence.rebuilt;
  Finding found;
  for (std::int32_t kerf = 0; kerf < rebuilt.fields.count(); ++kerf) {
    const RebuiltKerf& begun = rebuilt.kerfs[static_cast<std::size_t>(kerf)];
    const bool counts = !is_operated_on(evidence.plan, bone_of(rebuilt, kerf)) &&
                        is_begun_there(evidence.recording, begun, kerf);
    if (!counts) continue;
    if (found.value == 0.0) {
      found.first_tick = begun.frozen_tick;
      found.last_tick = begun.last_cutting_tick;
    }
    found.value += 1.0;
  }
  return found;
}

}  // namespace hallux::assessment

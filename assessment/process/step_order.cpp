#include "assessment/process/step_order.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "assessment/process/sample_spans.h"

namespace hallux::assessment {

namespace {

using scenarios::OperationStep;
using scenarios::StepKind;
using simulator::CutEvent;
using simulator::CutEventKind;

std::optional<std::int64_t> last_tick_of(const Evidence& evidence, CutEventKind kind,
                                         std::optional<std::int32_t> subject = {}) {
  std::optional<std::int64_t> tick;
  for (const CutEvent& event : evidence.recording.events) {
    if (event.kind == kind && (!subject || event.subject == *subject)) tick = event.tick;
  }
  return tick;
}

std::optional<std::int64_t> sawn_tick(const Evidence& evidence, const std::string& cut) {
  std::optional<std::int64_t> tick;
  for (const CutFace& face : evidence.faces[index_of_cut(evidence.plan, cut)]) {
    const RebuiltKerf& kerf = evidence.rebuilt.kerfs[static_cast<std::size_t>(face.kerf)];
    if (kerf.cutting_samples == 0) continue;
    tick = std::min(tick.value_or(kerf.first_cutting_tick), kerf.first_cutting_tick);
  }
  return tick;
}

std::optional<std::int64_t> tick_of(const Evidence& evidence, std::size_t index) {
  const OperationStep& step = evidence.scenario.steps[index];
  switch (step.kind) {
    case StepKind::Cut:
    case StepKind::Trim:
      return sawn_tick(evidence, step.cut);
    case StepKind::Remove:
      return last_tick_of(evidence, CutEventKind::PieceRemoved);
    case StepKind::Close:
      return last_tick_of(evidence, CutEventKind::HingeClosed);
    case StepKind::Finish:
      return last_tick_of(evidence, CutEventKind::Finished);
    default:
      return last_tick_of(evidence, CutEventKind::StepDone, static_cast<std::int32_t>(index));
  }
}

using StepTicks = std::vector<std::optional<std::int64_t>>;

/// How many of the steps up to each, itself included, can be kept so that their ticks rise: what
/// the longest common subsequence is where no step stands twice.
std::vector<std::size_t> longest_up_to(const StepTicks& ticks) {
  std::vector<std::size_t> longest(ticks.size(), 0);
  for (std::size_t step = 0; step < ticks.size(); ++step) {
    if (!ticks[step]) continue;
    longest[step] = 1;
    for (std::size_t before = 0; before < step; ++before) {
      if (ticks[before] && *ticks[before] <= *ticks[step])
        longest[step] = std::max(longest[step], longest[before] + 1);
    }
  }
  return longest;
}

/// Which steps the longest part keeps, found from its end.
std::vector<bool> kept_of(const StepTicks& ticks) {
  const std::vector<std::size_t> longest = longest_up_to(ticks);
  std::size_t wanted = *std::max_element(longest.begin(), longest.end());
  std::vector<bool> is_kept(ticks.size(), false);
  std::optional<std::int64_t> later;
  for (std::size_t step = ticks.size(); step-- > 0;) {
    if (wanted == 0 || longest[step] != wanted || (later && *ticks[step] > *later)) continue;
    is_kept[step] = true;
    later = ticks[step];
    --wanted;
  }
  return is_kept;
}

}  // namespace

Finding measure_step_order(const Evidence& evidence) {
  StepTicks ticks;
  for (std::size_t index = 0; index < evidence.scenario.steps.size(); ++index)
    ticks.push_back(tick_of(evidence, index));
  if (ticks.empty()) return {1.0, 0, 0};
  const std::vector<bool> is_kept = kept_of(ticks);
  const auto kept = std::count(is_kept.begin(), is_kept.end(), true);
  const auto left_out = static_cast<std::size_t>(
      std::distance(is_kept.begin(), std::find(is_kept.begin(), is_kept.end(), false)));
  const std::int64_t end_tick = last_tick_of(evidence.recording);
  const std::int64_t tick = left_out < ticks.size() ? ticks[left_out].value_or(end_tick) : end_tick;
  return {static_cast<double>(kept) / static_cast<double>(ticks.size()), tick, tick};
}

}  // namespace hallux::assessment

#include "assessment/process/sawn_after_done.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

namespace hallux::assessment {

namespace {

using simulator::CutEventKind;
using simulator::ToolSample;

std::optional<std::int32_t> step_of(const scenarios::Scenario& scenario, const std::string& cut) {
  for (std::size_t step = 0; step < scenario.steps.size(); ++step) {
    const scenarios::OperationStep& each = scenario.steps[step];
    if (is_sawn(each) && each.cut == cut) return static_cast<std::int32_t>(step);
  }
  return std::nullopt;
}

bool is_sawn_after(std::int32_t step, std::span<const CutFace> faces,
                   const simulator::Recording& recording) {
  const auto is_of_cut = [&](const ToolSample& sample) {
    return has(sample.status, simulator::ToolStatus::Cutting) &&
           std::ranges::any_of(faces,
                               [&](const CutFace& face) { return face.kerf == sample.kerf; });
  };
  bool is_done = false;
  auto event = recording.events.begin();
  for (const ToolSample& sample : recording.samples) {
    // An event of a tick acts before its sample.
    for (; event != recording.events.end() && event->tick <= sample.tick; ++event) {
      if (event->subject != step) continue;
      if (event->kind == CutEventKind::StepDone) is_done = true;
      if (event->kind == CutEventKind::StepReopened) is_done = false;
    }
    if (is_done && is_of_cut(sample)) return true;
  }
  return false;
}

}  // namespace

bool is_sawn_after_done(const scenarios::Scenario& scenario, const std::string& cut,
                        std::span<const CutFace> faces, const simulator::Recording& recording) {
  const std::optional<std::int32_t> step = step_of(scenario, cut);
  return step && is_sawn_after(*step, faces, recording);
}

}  // namespace hallux::assessment

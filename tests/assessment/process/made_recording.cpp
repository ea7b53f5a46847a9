#include "tests/assessment/process/made_recording.h"

#include <algorithm>

namespace hallux::assessment::testing {

using simulator::Recording;

namespace {

std::int64_t last_tick_of(const Recording& recording) {
  return recording.samples.empty() ? -1 : recording.samples.back().tick;
}

}  // namespace

void add_line(Recording& recording, const MadeLine& line, int ticks) {
  const std::int64_t last_tick = last_tick_of(recording) + line.missed;
  simulator::TapeLine tape;
  tape.tick = last_tick + 1;
  tape.ticks = static_cast<std::uint8_t>(ticks);
  tape.device.world_from_handle = simulator::quantise({line.rotation, line.tip_mm});
  simulator::ToolSample sample;
  sample.tick = last_tick + ticks;
  sample.world_from_tool = tape.device.world_from_handle;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sample.force_mn[axis] =
        millinewton_from_newton(line.force_newton[static_cast<glm::length_t>(axis)]);
  }
  sample.status = line.status;
  sample.kerf = line.kerf;
  recording.tape.push_back(tape);
  recording.samples.push_back(sample);
}

void add_lines(Recording& recording, const MadeLine& line, std::int64_t count) {
  for (std::int64_t index = 0; index < count; ++index) add_line(recording, line);
}

void add_event(Recording& recording, simulator::CutEventKind kind, std::int32_t subject) {
  simulator::CutEvent event;
  event.tick = std::max<std::int64_t>(0, last_tick_of(recording));
  event.kind = kind;
  event.subject = subject;
  recording.events.push_back(event);
}

}  // namespace hallux::assessment::testing

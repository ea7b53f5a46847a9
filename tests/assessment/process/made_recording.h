/// Recordings made line by line, for tests of what they tell of the work.
#pragma once

#include <cstdint>

#include "simulator/base/units.h"
#include "simulator/record/record.h"

namespace hallux::assessment::testing {

inline constexpr std::uint32_t running = bit(simulator::ToolStatus::Running);
inline constexpr std::uint32_t saw_on = bit(simulator::ToolStatus::SawOn);
inline constexpr std::uint32_t contact = bit(simulator::ToolStatus::InContact);
inline constexpr std::uint32_t cutting = bit(simulator::ToolStatus::Cutting);
inline constexpr std::uint32_t in_kerf = bit(simulator::ToolStatus::InKerf);
inline constexpr std::uint32_t irrigated = bit(simulator::ToolStatus::Irrigated);

/// The tool at the end of one line, in the world.
struct MadeLine {
  std::uint32_t status = 0;
  Vec3 tip_mm{0.0, 0.0, 0.0};
  Vec3 force_newton{0.0, 0.0, 0.0};
  std::int32_t kerf = -1;
  Quat rotation{1.0, 0.0, 0.0, 0.0};
  /// Ticks before this line that nothing tells of.
  std::int64_t missed = 0;
};

/// Adds a line of the tape that covers so many ticks after what is recorded already, with the
/// handle where the tool is, and the sample of its last tick.
void add_line(simulator::Recording& recording, const MadeLine& line, int ticks = 1);
/// The same line again and again.
void add_lines(simulator::Recording& recording, const MadeLine& line, std::int64_t count);
/// At the last tick that is recorded.
void add_event(simulator::Recording& recording, simulator::CutEventKind kind,
               std::int32_t subject = -1);

}  // namespace hallux::assessment::testing

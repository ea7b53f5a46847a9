/// What is recorded of a tool in one tick: of the saw, of what bores, or of the piece that is led
/// in its place.
/// Inside this corner only.
#pragma once

#include <cstdint>

#include "simulator/contact/bore/bore_motion.h"
#include "simulator/contact/gripped_body.h"
#include "simulator/contact/tool_motion.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

void mark(ToolSample& sample, ToolStatus status, bool is_so) noexcept;

/// A tick's end, and where the bone's frame lies.
struct RecordedTick {
  std::int64_t tick = 0;
  const RigidTransform& world_from_bone;
};

/// Rounded to the record's quanta.
/// kerf  that holds the blade; -1: none
ToolSample sample_of(const RecordedTick& at, const ToolState& tool, const ToolInput& input,
                     const ToolOutcome& outcome, std::int32_t kerf) noexcept;
ToolSample sample_of(const RecordedTick& at, const BoreToolState& tool, const BoreInput& input,
                     const BoreOutcome& outcome) noexcept;
ToolSample sample_of(const RecordedTick& at, const RigidTransform& bone_from_piece,
                     const GrippedOutcome& outcome) noexcept;

}  // namespace hallux::simulator

/// What the hand does with the tool in one tick, and what the tool may meet.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <span>

#include "simulator/contact/tool_motion.h"
#include "simulator/contact/wound.h"
#include "simulator/cutting/hole/capsule.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

struct ToolHand {
  RigidTransform bone_from_handle;
  /// Of the device.
  std::uint32_t switches = 0;
  double duration_s = 0.001;
  /// While it is worked out how a bone moves, nothing of it is cut.
  bool may_cut = true;
  /// Of the step at hand; null: none leads.
  const GuidePlane* guide = nullptr;

  bool runs() const noexcept { return may_cut && has(switches, Switch::SawRuns); }
};

/// Borrowed for the tick.
struct ToolSite {
  const Wound& wound;
  const ContactSettings& settings;
  const RigidTransform& world_from_bone;
  /// Implants that are there, in the wound's frame.
  std::span<const Capsule> metal;
};

}  // namespace hallux::simulator

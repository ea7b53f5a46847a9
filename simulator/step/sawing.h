/// The saw in the hand: how it is moved, the kerfs that it begins and enters, and what is told of
/// it. Inside this corner only.
#pragma once

#include <cstdint>

#include "simulator/step/piece_requests.h"
#include "simulator/step/step_output.h"
#include "simulator/step/tool_hand.h"

namespace hallux::simulator {

/// What a tick of sawing came to, for whoever asks for pieces and leads the hand.
struct SawPassage {
  BladePassage blade;
  /// A kerf was begun in the blade's own plane.
  bool has_begun_kerf = false;
};

class Sawing {
 public:
  /// The blade as it is in the hand.
  const ToolState& tool() const noexcept { return tool_; }
  /// The kerf that holds the blade, or -1.
  std::int32_t kerf() const noexcept { return tool_.stage == ToolStage::InKerf ? tool_.kerf : -1; }

  /// Comes into the hand there, free.
  void take_up(const RigidTransform& bone_from_handle) noexcept {
    tool_ = {};
    tool_.bone_from_tool = bone_from_handle;
  }
  void place(const RigidTransform& bone_from_handle) noexcept {
    tool_.bone_from_tool = bone_from_handle;
  }
  void leave_kerf() noexcept { simulator::leave_kerf(tool_); }
  /// The hand goes on meanwhile: it is led anew, softly.
  void rest() noexcept { tool_.guided_s = 0.0; }

  /// Moves the blade for one tick and writes its sample.
  SawPassage move(const Saw& saw, const ToolHand& hand, const ToolSite& site,
                  StepWriter& out) noexcept;
  /// A touch that the attempt's end ends.
  void end(StepWriter& out) const noexcept;

 private:
  void report(const ToolOutcome& outcome, StepWriter& out) const noexcept;
  bool freeze(const ToolSite& site, StepWriter& out) noexcept;
  void follow_cut(const ToolSite& site, StepWriter& out) noexcept;
  std::int32_t watch_metal(const ToolHand& hand, const ToolSite& site, StepWriter& out) noexcept;
  QuantisedPose pose() const noexcept { return quantise(tool_.bone_from_tool); }

  ToolState tool_;
  /// No kerf was left for a fragment that the blade's cut reached.
  bool is_cut_refused_ = false;
  /// That the teeth stood on in the tick before; -1: none.
  std::int32_t metal_ = -1;
};

}  // namespace hallux::simulator

/// Effects of the saw besides the cut: heat in the walls, danger zones touched, bend of the blade.
///
/// All of them follow from the recorded samples and change none. What happened comes out as events,
/// one by one, so that they wait where a step has no room for them.
#pragma once

#include <span>

#include "simulator/contact/blade_flex.h"
#include "simulator/contact/danger_zone.h"
#include "simulator/contact/heat.h"
#include "simulator/tool/tray.h"

namespace hallux::simulator {

/// A saw, and whether a guide leads the hand that holds it.
struct SawInHand {
  Saw saw = {};
  /// A guide pushes the hand, not the blade, and a record holds one force: outside a kerf that
  /// tells of no bend.
  bool is_guided = false;
};

/// For displays; not recorded.
struct BladeFlex {
  /// Out of the bone; 0 where no tooth touches any.
  double free_length_mm = 0.0;
  /// Along the blade's normal.
  double deflection_mm = 0.0;
};

class ToolEffects {
 public:
  /// Takes all its memory here.
  /// danger_zones  at most danger_zone_limit; the rest is not watched
  ToolEffects(const RigidTransform& world_from_bone, const SawInHand& hand,
              std::span<const DangerCapsule> danger_zones = {});

  /// Another tool is in the hand from now on: a saw, or one that bores.
  void hold(const Tool& tool) noexcept;
  /// needs   samples in their order; `bone` as it stands after the sample
  /// thread  haptic; allocates nothing
  void apply(const ToolSample& sample, const Wound& bone) noexcept;
  /// The next thing that happened; danger first.
  bool take_event(const KerfSet& kerfs, CutEvent& event) noexcept;

  const HeatField& heat() const noexcept { return heat_; }
  const DangerWatch& danger() const noexcept { return danger_; }
  const BladeFlex& flex() const noexcept { return flex_; }

 private:
  void bend(const ToolSample& sample, const Wound& bone) noexcept;

  RigidTransform bone_from_world_;
  Blade blade_;
  bool is_guided_;
  /// Of a tool that bores nothing bends that is shown.
  bool has_blade_ = true;
  HeatField heat_;
  DangerWatch danger_;
  BladeFlex flex_;
  QuantisedPose bone_from_tool_;
  std::int64_t tick_ = 0;
};

}  // namespace hallux::simulator

/// Where a hand sets wires and screws and to where it leads fragments: the plan with the errors of
/// the hand. Inside this corner only.
#pragma once

#include <cstdint>
#include <optional>

#include "scenarios/hands/hand_skill.h"
#include "scenarios/plan.h"

namespace hallux::scenarios {

/// A wire or a screw as the hand means to set it.
struct AimedImplant {
  /// Origin at the entry, x along the axis.
  RigidTransform bone_from_axis;
  /// From the entry, of the tip.
  double depth_mm = 0.0;
  /// On the tray; the drill that goes first, where a screw asks for one.
  std::int32_t tool = 0;
  std::optional<std::int32_t> drill;
};

/// implant  of Plan::fixation's
/// errors   ScenarioError where nothing that is laid out is of its size
AimedImplant aim_implant(const Scenario& scenario, const Plan& plan, std::size_t implant,
                         const HandSkill& skill, std::uint64_t seed);

/// Carries the fragment from where it lies to where the hand leads it.
/// shift  of Plan::fixation's
RigidTransform aim_shift(const Plan& plan, std::size_t shift, const HandSkill& skill,
                         std::uint64_t seed);

}  // namespace hallux::scenarios

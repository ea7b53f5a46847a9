#include "simulator/contact/tool_motion.h"

#include <algorithm>
#include <cmath>

#include "simulator/contact/blade_probe.h"
#include "simulator/contact/coupling.h"
#include "simulator/contact/tool_in_kerf.h"
#include "simulator/contact/tool_outside.h"

namespace hallux::simulator {

namespace {

/// How far the tool may go; it learns where the hand is.
double travel_of(ToolState& tool, const ToolInput& input, const Blade& blade,
                 const ContactSettings& settings) noexcept {
  const ProxyMotion hand = motion_between(tool.bone_from_handle, input.bone_from_handle);
  const bool is_free = tool.stage == ToolStage::Free && !tool.is_held;
  const bool is_gentle = tool.knows_handle && !is_free;
  tool.bone_from_handle = input.bone_from_handle;
  tool.knows_handle = true;
  return travel_limit_mm(reach_of(hand, blade), input.duration_s, is_gentle, settings);
}

/// What the stretched coupling does to the hand.
void pull_hand(const ToolState& tool, const ToolInput& input, const ContactSettings& settings,
               ToolOutcome& outcome) noexcept {
  const CouplingPull pull =
      coupling_pull(motion_between(input.bone_from_handle, tool.bone_from_tool), settings);
  outcome.force_in_bone_newton = pull.force_newton;
  outcome.torque_in_bone_newton_mm = pull.torque_newton_mm;
  outcome.is_force_limited = pull.is_force_limited;
}

/// Adds to what the hand feels; all of it together stays within the limit.
void push_hand(const Vec3& force_newton, const ContactSettings& settings,
               ToolOutcome& outcome) noexcept {
  const Vec3 sum_newton = outcome.force_in_bone_newton + force_newton;
  const double share = share_within(sum_newton, settings.force_limit_newton);
  outcome.force_in_bone_newton = share * sum_newton;
  outcome.is_force_limited = outcome.is_force_limited || share < 1.0;
}

/// The guide leads the hand where no kerf does.
void guide_hand(ToolState& tool, const ToolInput& input, const ContactSettings& settings,
                ToolOutcome& outcome) noexcept {
  // Not in the tick of a freeze either: its sample lies in the kerf, and there the record's force
  // is the blade's alone.
  if (input.guide == nullptr || tool.stage == ToolStage::InKerf || outcome.wants_freeze) {
    tool.guided_s = 0.0;
    return;
  }
  tool.guided_s = std::min(guide_comes_in_s, tool.guided_s + input.duration_s);
  const GuideStrength full{settings.coupling_newton_per_mm, settings.force_limit_newton,
                           settings.torsion_newton_mm_per_rad, settings.torque_limit_newton_mm};
  const GuidePush push =
      guide_push(tool.bone_from_tool, *input.guide, settings.guide.guidance, full);
  const double share = tool.guided_s / guide_comes_in_s;
  push_hand(share * push.force_newton, settings, outcome);
  const Vec3 torque_newton_mm = outcome.torque_in_bone_newton_mm + share * push.torque_newton_mm;
  outcome.torque_in_bone_newton_mm =
      share_within(torque_newton_mm, settings.torque_limit_newton_mm) * torque_newton_mm;
}

/// Why the saw kicks in this tick; `side` becomes the one to which it does.
KickCause cause_of_kick(ToolState& tool, const ToolInput& input, const Wound& bone,
                        const ContactSettings& settings, const ToolOutcome& outcome,
                        double& side) noexcept {
  if (!input.saw_runs) return KickCause::None;
  if (!tool.kick.saw_ran && outcome.engaged.width_mm() > 0.0) {
    side = side_away_from(tissue_at_teeth(tool.bone_from_tool, bone, probe_ahead_mm, tool.teeth));
    return KickCause::StartedInBone;
  }
  if (!outcome.began_contact || tool.stage != ToolStage::Touching) return KickCause::None;
  // Within a touch's depth: teeth laid on almost flat are no corner.
  const auto teeth =
      tissue_at_teeth(tool.bone_from_tool, bone, settings.freeze_depth_mm, tool.teeth);
  side = side_away_from(teeth);
  const double tooth_mm = bone.blade().width_mm / static_cast<double>(tooth_count);
  return is_corner(teeth, tooth_mm) ? KickCause::Corner : KickCause::None;
}

/// What the teeth's reaction adds to it.
void kick_hand(ToolState& tool, const ToolInput& input, const Wound& bone,
               const ContactSettings& settings, ToolOutcome& outcome) noexcept {
  double side = 1.0;
  const KickCause cause = cause_of_kick(tool, input, bone, settings, outcome, side);
  if (cause != KickCause::None && begin_kick(tool.kick, side)) outcome.kicked = cause;
  tool.kick.saw_ran = input.saw_runs;
  const double newton = kick_newton(tool.kick, input.duration_s);
  if (!(std::abs(newton) > 0.0)) return;
  push_hand(newton * axis_y(tool.bone_from_tool), settings, outcome);
}

}  // namespace

ToolOutcome move_tool(ToolState& tool, const ToolInput& input, const Wound& bone,
                      const ContactSettings& settings) noexcept {
  ToolOutcome outcome;
  const double limit_mm = travel_of(tool, input, bone.blade(), settings);
  if (tool.stage == ToolStage::InKerf) {
    move_in_kerf(tool, input, bone, settings, limit_mm, outcome);
  } else {
    move_outside(tool, input, bone, settings, limit_mm, outcome);
    if (outcome.began_contact) {
      const std::int32_t kerf = find_kerf_to_join(tool.bone_from_tool, bone, settings);
      if (kerf >= 0) enter_kerf(tool, kerf);
    }
  }
  if (tool.stage != ToolStage::Free || tool.is_held) pull_hand(tool, input, settings, outcome);
  guide_hand(tool, input, settings, outcome);
  kick_hand(tool, input, bone, settings, outcome);
  return outcome;
}

}  // namespace hallux::simulator

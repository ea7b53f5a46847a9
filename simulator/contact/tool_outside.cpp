/// Outside a kerf the tool is a proxy (proxy.h), and a tick's way is gone in parts
/// (contact_walk.h). Teeth that run advance by the feed law of what they alone bear, and a touch
/// that goes deep enough asks for a kerf.
#include "simulator/contact/tool_outside.h"

#include <algorithm>
#include <cmath>

#include "simulator/contact/blade_probe.h"
#include "simulator/contact/contact_walk.h"

namespace hallux::simulator {

namespace {

/// A spring stretched by less is slack.
constexpr double slack_mm = 0.001;

Walk walk(ToolState& tool, const ToolInput& input, const Wound& bone,
          const ContactSettings& settings, double travel_limit_mm) noexcept {
  const double grip_mm =
      std::sqrt(settings.torsion_newton_mm_per_rad / settings.coupling_newton_per_mm);
  const ProxyFriction friction{settings.friction, settings.kinetic_ratio,
                               input.saw_runs ? settings.tooth_friction : settings.friction};
  return walk_towards(
      tool.bone_from_tool, input.bone_from_handle, bone.blade().depth_mm, travel_limit_mm,
      [&](const RigidTransform& pose, double look_mm) {
        return find_contacts(pose, bone, look_mm, tool.points);
      },
      [&](const ProxyMotion& wanted, const BladeContacts& contacts) {
        return solve_proxy(wanted, contacts.all(), grip_mm, friction, tool.load);
      });
}

/// What presses on teeth beside their middles: an edge of the bone at a corner of the blade, or a
/// rim between two teeth. What is no cortex feeds as cancellous bone.
Engagement pressed_teeth(const ToolState& tool, const Walk& walked, const Wound& bone) noexcept {
  const double share_mm = bone.blade().width_mm / static_cast<double>(tooth_count);
  Engagement pressed;
  for (const BladeContact& contact : walked.contacts.all()) {
    if (!contact.is_tooth || !(tool.load.normal_mm[contact.point] > 0.0)) continue;
    const Vec3 inside_mm = tool.bone_from_tool.translation_mm + contact.arm_mm -
                           (contact.gap_mm + probe_ahead_mm) * contact.normal;
    const bool is_cortex = tissue_at(inside_mm, bone) == Tissue::Cortical;
    (is_cortex ? pressed.cortical_mm : pressed.cancellous_mm) += share_mm;
  }
  return pressed;
}

/// Running teeth advance by the feed law of what they alone bear.
double feed_touch(ToolState& tool, const ToolInput& input, const Walk& walked,
                  const ContactSettings& settings, ToolOutcome& outcome) noexcept {
  if (!input.cuts() || tool.is_refused) return 0.0;
  const Vec3 ahead = axis_x(tool.bone_from_tool);
  const double force_newton =
      std::min(settings.force_limit_newton,
               -settings.coupling_newton_per_mm * glm::dot(walked.proxy.tooth_mm, ahead));
  const double rate_mm_s =
      feed_rate_mm_s(outcome.engaged, force_newton, input.saw, settings.bone_quality);
  const double fed_mm = room_ahead_mm(walked.contacts, ahead, rate_mm_s * input.duration_s);
  tool.bone_from_tool.translation_mm += fed_mm * ahead;
  outcome.advance_mm = fed_mm;
  return fed_mm;
}

void begin_touch(ToolState& tool, ToolOutcome& outcome) noexcept {
  tool.stage = ToolStage::Touching;
  tool.touch_depth_mm = tool.scratch_mm = 0.0;
  tool.is_refused = false;
  outcome.began_contact = true;
}

/// A touch is as deep as teeth went whose middles stand in bone; those that bone only presses on
/// bite until they do.
void go_on_touching(ToolState& tool, const ToolInput& input, const Walk& walked, bool is_in_bone,
                    const ContactSettings& settings, ToolOutcome& outcome) noexcept {
  tool.touch_depth_mm = std::max(0.0, tool.touch_depth_mm - walked.lifted_mm);
  if (outcome.engaged.width_mm() > 0.0) {
    const double fed_mm = feed_touch(tool, input, walked, settings, outcome);
    if (!is_in_bone) return;
    tool.touch_depth_mm += fed_mm;
    tool.scratch_mm = std::max(tool.scratch_mm, tool.touch_depth_mm);
    outcome.wants_freeze = !tool.is_refused && tool.touch_depth_mm >= settings.freeze_depth_mm;
    return;
  }
  if (!teeth_are_clear(walked.contacts)) return;
  outcome.scratch_mm = tool.scratch_mm;
  tool.stage = ToolStage::Free;
}

}  // namespace

double reach_of(const ProxyMotion& motion, const Blade& blade) noexcept {
  return reach_of(motion, blade.depth_mm);
}

void move_outside(ToolState& tool, const ToolInput& input, const Wound& bone,
                  const ContactSettings& settings, double travel_limit_mm,
                  ToolOutcome& outcome) noexcept {
  const Walk walked = walk(tool, input, bone, settings, travel_limit_mm);
  outcome.engaged = engagement(tool.bone_from_tool, bone, probe_ahead_mm, tool.teeth);
  const bool is_in_bone = outcome.engaged.width_mm() > 0.0;
  if (!is_in_bone && input.cuts()) outcome.engaged = pressed_teeth(tool, walked, bone);
  const bool is_pushed = walked.proxy.normal_mm > 0.0 || tool.stage == ToolStage::Touching;
  const ProxyMotion left = motion_between(tool.bone_from_tool, input.bone_from_handle);
  tool.is_held = is_pushed || (tool.is_held && reach_of(left, bone.blade()) > slack_mm);
  if (tool.stage == ToolStage::Touching) {
    go_on_touching(tool, input, walked, is_in_bone, settings, outcome);
  } else if (outcome.engaged.width_mm() > 0.0) {
    begin_touch(tool, outcome);
    tool.is_held = true;
  }
}

}  // namespace hallux::simulator

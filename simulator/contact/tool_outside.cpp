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

/// What presses on teeth beside their middles, an edge of the bone at a corner of the blade or a
/// rim between two teeth: of the tooth that bears most. What is no cortex feeds as cancellous bone.
Engagement pressed_teeth(const ToolState& tool, const Walk& walked, const Wound& bone) noexcept {
  const BladeContact* pressed = nullptr;
  double most_mm = 0.0;
  for (const BladeContact& contact : walked.contacts.all()) {
    const double load_mm = tool.load.normal_mm[contact.point];
    if (!contact.is_tooth || !(load_mm > most_mm)) continue;
    pressed = &contact;
    most_mm = load_mm;
  }
  if (pressed == nullptr) return {};
  const Vec3 inside_mm = tool.bone_from_tool.translation_mm + pressed->arm_mm -
                         (pressed->gap_mm + probe_ahead_mm) * pressed->normal;
  const double share_mm = bone.blade().width_mm / static_cast<double>(tooth_count);
  if (tissue_at(inside_mm, bone) == Tissue::Cortical) return {.cortical_mm = share_mm};
  return {.cancellous_mm = share_mm};
}

/// Running teeth advance by the feed law of what they alone bear, through what stands before them.
double feed_teeth(ToolState& tool, const ToolInput& input, const Walk& walked,
                  const Engagement& before, const ContactSettings& settings) noexcept {
  if (!input.cuts() || tool.is_refused) return 0.0;
  const Vec3 ahead = axis_x(tool.bone_from_tool);
  const double force_newton =
      std::min(settings.force_limit_newton,
               -settings.coupling_newton_per_mm * glm::dot(walked.proxy.tooth_mm, ahead));
  const double rate_mm_s = feed_rate_mm_s(before, force_newton, input.saw, settings.bone_quality);
  const double fed_mm = room_ahead_mm(walked.contacts, ahead, rate_mm_s * input.duration_s);
  tool.bone_from_tool.translation_mm += fed_mm * ahead;
  return fed_mm;
}

/// Teeth that bone only presses on bite until their middles stand in it; that is no touch yet.
void bite(ToolState& tool, const ToolInput& input, const Walk& walked, const Wound& bone,
          const ContactSettings& settings) noexcept {
  const Engagement pressed = pressed_teeth(tool, walked, bone);
  if (pressed.width_mm() > 0.0) feed_teeth(tool, input, walked, pressed, settings);
}

void begin_touch(ToolState& tool, ToolOutcome& outcome) noexcept {
  tool.stage = ToolStage::Touching;
  tool.touch_depth_mm = tool.scratch_mm = 0.0;
  tool.is_refused = false;
  outcome.began_contact = true;
}

void go_on_touching(ToolState& tool, const ToolInput& input, const Walk& walked,
                    const ContactSettings& settings, ToolOutcome& outcome) noexcept {
  tool.touch_depth_mm = std::max(0.0, tool.touch_depth_mm - walked.lifted_mm);
  if (outcome.engaged.width_mm() > 0.0) {
    outcome.advance_mm = feed_teeth(tool, input, walked, outcome.engaged, settings);
    tool.touch_depth_mm += outcome.advance_mm;
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
  if (!is_in_bone && input.cuts()) bite(tool, input, walked, bone, settings);
  const bool is_pushed = walked.proxy.normal_mm > 0.0 || tool.stage == ToolStage::Touching;
  const ProxyMotion left = motion_between(tool.bone_from_tool, input.bone_from_handle);
  tool.is_held = is_pushed || (tool.is_held && reach_of(left, bone.blade()) > slack_mm);
  if (tool.stage == ToolStage::Touching) {
    go_on_touching(tool, input, walked, settings, outcome);
  } else if (is_in_bone) {
    begin_touch(tool, outcome);
    tool.is_held = true;
  }
}

}  // namespace hallux::simulator

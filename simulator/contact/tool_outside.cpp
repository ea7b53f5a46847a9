/// Outside a kerf the tool is a proxy (proxy.h). A tick's way is gone in parts of a quarter of a
/// millimetre near bone, with contacts looked for anew in each; in one part a fast hand would slide
/// around an edge that it should have met. Teeth that run advance by the feed law of what they
/// alone bear, and a touch that goes deep enough asks for a kerf.
#include "simulator/contact/tool_outside.h"

#include <algorithm>
#include <cmath>

#include "simulator/contact/blade_probe.h"

namespace hallux::simulator {

namespace {

/// Near bone a tick's way is gone in parts of this, and contacts are looked for anew.
constexpr double part_mm = 0.25;
constexpr int part_limit = 6;
/// Teeth further away than this end a touch.
constexpr double leave_mm = 0.1;
/// A tooth nearer than this to the surface is on it.
constexpr double on_surface_mm = 0.01;
/// A spring stretched by less is slack.
constexpr double slack_mm = 0.001;

ProxyMotion scaled(const ProxyMotion& motion, double share) noexcept {
  return {share * motion.translation_mm, share * motion.rotation_rad};
}

Vec3 motion_at(const ProxyMotion& motion, const BladeContact& contact) noexcept {
  return motion.translation_mm + glm::cross(motion.rotation_rad, contact.arm_mm);
}

/// What a tick's way came to: the contacts at its end, and how the teeth stood to the bone.
struct Walk {
  BladeContacts contacts;  ///< gaps as they are at the end of the way
  ProxyResult proxy;
  double lifted_mm = 0.0;  ///< by which teeth that stood on bone came away from it
};

/// How far the teeth that stand on bone come away from it, all of them.
double lifted_mm(const BladeContacts& contacts, const ProxyMotion& motion) noexcept {
  double least_mm = 1.0e6;
  for (const BladeContact& contact : contacts.all()) {
    if (!contact.is_tooth || contact.gap_mm > on_surface_mm) continue;
    least_mm = std::min(least_mm, glm::dot(contact.normal, motion_at(motion, contact)));
  }
  return least_mm < 1.0e6 ? std::max(0.0, least_mm) : 0.0;
}

void move_contacts(BladeContacts& contacts, const ProxyMotion& motion) noexcept {
  for (std::size_t i = 0; i < contacts.count; ++i) {
    BladeContact& contact = contacts.list[i];
    contact.gap_mm += glm::dot(contact.normal, motion_at(motion, contact));
  }
}

Walk walk(ToolState& tool, const ToolInput& input, const Wound& bone,
          const ContactSettings& settings, double travel_limit_mm) noexcept {
  const double grip_mm =
      std::sqrt(settings.torsion_newton_mm_per_rad / settings.coupling_newton_per_mm);
  const ProxyFriction friction{settings.friction, settings.kinetic_ratio,
                               input.saw_runs ? settings.tooth_friction : settings.friction};
  const Blade& blade = bone.blade();
  Walk walked;
  double left_mm = travel_limit_mm;
  for (int part = 0; part < part_limit; ++part) {
    const ProxyMotion wanted = motion_between(tool.bone_from_tool, input.bone_from_handle);
    const double look_mm = std::max(part_mm, std::min(left_mm, reach_of(wanted, blade)));
    walked.contacts = find_contacts(tool.bone_from_tool, bone, look_mm, tool.points);
    walked.proxy = solve_proxy(wanted, walked.contacts.all(), grip_mm, friction, tool.load);
    const double way_mm = reach_of(walked.proxy.motion, blade);
    const double most_mm = walked.contacts.count == 0 ? left_mm : std::min(left_mm, part_mm);
    if (walked.contacts.count == 0 && way_mm <= most_mm) {
      tool.bone_from_tool = input.bone_from_handle;
      break;
    }
    const ProxyMotion motion =
        scaled(walked.proxy.motion, way_mm > most_mm ? most_mm / way_mm : 1.0);
    walked.lifted_mm += lifted_mm(walked.contacts, motion);
    tool.bone_from_tool = moved_by(tool.bone_from_tool, motion);
    move_contacts(walked.contacts, motion);
    left_mm -= std::min(way_mm, most_mm);
    if (way_mm <= most_mm || !(left_mm > 0.0)) break;
  }
  return walked;
}

/// How far the blade may go ahead before a face would be in bone.
double room_ahead_mm(const BladeContacts& contacts, const Vec3& ahead, double wanted_mm) noexcept {
  double room_mm = wanted_mm;
  for (const BladeContact& contact : contacts.all()) {
    const double toward = -glm::dot(contact.normal, ahead);
    if (contact.is_tooth || !(toward > 0.0)) continue;
    room_mm = std::min(room_mm, std::max(0.0, contact.gap_mm) / toward);
  }
  return room_mm;
}

/// Running teeth advance by the feed law of what they alone bear.
double feed_touch(ToolState& tool, const ToolInput& input, const Walk& walked,
                  const ContactSettings& settings, ToolOutcome& outcome) noexcept {
  if (!input.saw_runs || tool.is_refused) return 0.0;
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

bool teeth_are_clear(const BladeContacts& contacts) noexcept {
  return std::none_of(
      contacts.all().begin(), contacts.all().end(),
      [](const BladeContact& contact) { return contact.is_tooth && contact.gap_mm <= leave_mm; });
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
    tool.touch_depth_mm += feed_touch(tool, input, walked, settings, outcome);
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
  return length_of(motion.translation_mm) + blade.depth_mm * length_of(motion.rotation_rad);
}

void move_outside(ToolState& tool, const ToolInput& input, const Wound& bone,
                  const ContactSettings& settings, double travel_limit_mm,
                  ToolOutcome& outcome) noexcept {
  const Walk walked = walk(tool, input, bone, settings, travel_limit_mm);
  outcome.engaged = engagement(tool.bone_from_tool, bone, probe_ahead_mm, tool.teeth);
  const bool is_pushed = walked.proxy.normal_mm > 0.0 || tool.stage == ToolStage::Touching;
  const ProxyMotion left = motion_between(tool.bone_from_tool, input.bone_from_handle);
  tool.is_held = is_pushed || (tool.is_held && reach_of(left, bone.blade()) > slack_mm);
  if (tool.stage == ToolStage::Touching) {
    go_on_touching(tool, input, walked, settings, outcome);
  } else if (outcome.engaged.width_mm() > 0.0) {
    begin_touch(tool, outcome);
    tool.is_held = true;
  }
}

}  // namespace hallux::simulator

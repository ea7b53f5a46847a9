/// The tool is a row of balls, a small one at the tip and the shaft's behind it. The tip stands for
/// a saw's teeth in the proxy: it digs in where it runs, and is led no deeper. Flat on the surface
/// it has nothing to hold by and skids. What a steep one bears along its axis feeds it.
#include "simulator/contact/bore/bore_outside.h"

#include <algorithm>
#include <cmath>

#include "simulator/contact/contact_walk.h"
#include "simulator/contact/metal.h"

namespace hallux::simulator {

namespace {

/// Of the tip's ball. It has a radius so that a tip on the surface still knows which way is out.
constexpr double tip_radius_mm = 0.05;
/// The shaft is asked for bone up to here.
constexpr double shaft_end_mm = 40.0;
/// Behind the tip by this and its diameter the shaft begins: a touch of 0.3 mm at 30 degrees must
/// not bring it into the bone.
constexpr double shaft_begin_mm = 1.0;
/// A tip nearer than this to the surface stands on it.
constexpr double on_surface_mm = 0.01;
/// Behind the surface that a tip stands on, to ask for its tissue.
constexpr double probe_mm = 0.02;
/// A spring stretched by less is slack.
constexpr double slack_mm = 0.001;
/// A tip may be deeper than it bored by this: curved bone is met by its planes.
constexpr double bored_slack_mm = 0.02;

struct BackBall {
  double back_mm = 0.0;
  double radius_mm = 0.0;
};

BackBall ball_of(std::size_t index, const BoreTool& tool) noexcept {
  if (index == 0) return {tip_radius_mm, tip_radius_mm};
  const double first_mm = std::min(shaft_begin_mm + 2.0 * tool.radius_mm, tool.shaft_mm);
  const double share = static_cast<double>(index - 1) / static_cast<double>(bore_shaft_points - 1);
  return {first_mm + share * (shaft_reach_mm(tool) - first_mm), tool.radius_mm};
}

/// The tip is a tooth of the proxy's, shaft balls are faces.
constexpr std::size_t contact_point(std::size_t index) noexcept {
  return index == 0 ? 0 : contact_tooth_count + index - 1;
}

BladeContacts find_ball_contacts(const RigidTransform& wound_from_tool, const BoreTool& tool,
                                 const DrilledWound& bone, double margin_mm,
                                 BallMemories& memory) noexcept {
  BladeContacts contacts;
  const Vec3 ahead = axis_x(wound_from_tool);
  for (std::size_t i = 0; i < memory.size(); ++i) {
    const BackBall ball = ball_of(i, tool);
    const Vec3 arm_mm = -ball.back_mm * ahead;
    const double within_mm = ball.radius_mm + margin_mm;
    const auto near = bone.near_ball({wound_from_tool.translation_mm + arm_mm, tool.radius_mm},
                                     within_mm, memory[i]);
    if (!near || near->height_mm > within_mm) continue;
    contacts.list[contacts.count++] = {contact_point(i), arm_mm - ball.radius_mm * near->normal,
                                       near->normal, near->height_mm - ball.radius_mm, i == 0};
  }
  return contacts;
}

const BladeContact* tip_contact(const BladeContacts& contacts) noexcept {
  const auto all = contacts.all();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [](const BladeContact& contact) { return contact.is_tooth; });
  return found == all.end() || found->gap_mm > on_surface_mm ? nullptr : &*found;
}

bool is_flat(const BladeContact& tip, const Vec3& ahead) noexcept {
  return -glm::dot(tip.normal, ahead) < skid_sine;
}

ProxyFriction friction_of(const BladeContacts& contacts, const BoreInput& input, const Vec3& ahead,
                          const ContactSettings& settings) noexcept {
  ProxyFriction friction{settings.friction, settings.kinetic_ratio, settings.friction};
  if (!input.drive_runs) return friction;
  const BladeContact* tip = tip_contact(contacts);
  friction.tooth_friction = tip != nullptr && is_flat(*tip, ahead) ? skid_friction : point_grip;
  return friction;
}

/// How deep the tip may be: as it has bored, and the rounding of curved bone.
double bored_mm(const BoreToolState& tool) noexcept {
  return bored_slack_mm + (tool.stage == BoreStage::OnBone ? tool.touch_depth_mm : 0.0);
}

/// A tip that has bored is held as by the surface that it met: an edge beside it may be nearer, and
/// is no way for it. What it stands on otherwise is remembered.
void keep_touched_surface(BoreToolState& tool, BladeContacts& contacts) noexcept {
  if (contacts.count == 0 || !contacts.list[0].is_tooth) return;
  BladeContact& tip = contacts.list[0];
  const bool has_bored = tool.stage == BoreStage::OnBone && tool.touch_depth_mm > tip_radius_mm;
  if (!has_bored || tip.gap_mm >= -tip_radius_mm || tip.gap_mm < -bored_mm(tool)) {
    tool.touch_normal = tip.normal;
    return;
  }
  tip.arm_mm += tip_radius_mm * (tip.normal - tool.touch_normal);
  tip.normal = tool.touch_normal;
}

/// A tip that came into bone without boring, around an edge that it slid over, is led out again.
void lead_out(BoreToolState& tool, const BladeContacts& contacts) noexcept {
  if (contacts.count == 0 || !contacts.list[0].is_tooth) return;
  const BladeContact& tip = contacts.list[0];
  const double excess_mm = -tip.gap_mm - bored_mm(tool);
  if (excess_mm > 0.0)
    tool.wound_from_tool.translation_mm += std::min(walk_part_mm, excess_mm) * tip.normal;
}

Walk walk(BoreToolState& tool, const BoreInput& input, const DrilledWound& bone,
          const ContactSettings& settings, double travel_limit_mm) noexcept {
  const double grip_mm =
      std::sqrt(settings.torsion_newton_mm_per_rad / settings.coupling_newton_per_mm);
  return walk_towards(
      tool.wound_from_tool, input.wound_from_handle, shaft_reach_mm(input.tool), travel_limit_mm,
      [&](const RigidTransform& pose, double look_mm) {
        BladeContacts contacts = find_ball_contacts(pose, input.tool, bone, look_mm, tool.balls);
        keep_touched_surface(tool, contacts);
        return contacts;
      },
      [&](const ProxyMotion& wanted, const BladeContacts& contacts) {
        const Vec3 ahead = axis_x(tool.wound_from_tool);
        return solve_proxy(wanted, contacts.all(), grip_mm,
                           friction_of(contacts, input, ahead, settings), tool.load);
      });
}

/// What the tip stands on: below its own place, or right behind the surface that it touches.
Engagement engaged_at(const BladeContact& tip, BoreToolState& tool, const BoreInput& input,
                      const DrilledWound& bone) noexcept {
  const Vec3 tip_mm = tool.wound_from_tool.translation_mm;
  const Vec3 touched_mm = tip_mm + tip.arm_mm - (std::max(0.0, tip.gap_mm) + probe_mm) * tip.normal;
  const HolesOfFragments none;
  // As if there were no holes: a narrower one bears the tool on its rim.
  const Tissue tissue = std::max(DrilledWound{bone.wound, none}.at(touched_mm, tool.touch),
                                 bone.at(tip_mm + probe_mm * axis_x(tool.wound_from_tool)));
  Engagement engaged;
  const double width_mm = 2.0 * input.tool.radius_mm;
  if (tissue == Tissue::Cortical) engaged.cortical_mm = width_mm;
  if (tissue == Tissue::Cancellous) engaged.cancellous_mm = width_mm;
  return engaged;
}

/// A running point advances by the feed law of what it alone bears along its axis.
double feed_touch(BoreToolState& tool, const BoreInput& input, const Walk& walked,
                  const ContactSettings& settings, BoreOutcome& outcome) noexcept {
  const Vec3 ahead = axis_x(tool.wound_from_tool);
  const Vec3 tip_mm = tool.wound_from_tool.translation_mm + probe_mm * ahead;
  outcome.metal = metal_at({&tip_mm, 1}, input.metal);
  if (outcome.metal >= 0) return 0.0;
  const double force_newton =
      std::min(settings.force_limit_newton,
               -settings.coupling_newton_per_mm * glm::dot(walked.proxy.tooth_mm, ahead));
  const double rate_mm_s = feed_rate_mm_s(outcome.engaged, force_newton,
                                          input.tool.law_cycles_per_minute, settings.bone_quality);
  double most_mm = rate_mm_s * input.duration_s;
  if (input.tool.is_screw())
    most_mm = std::min(most_mm, input.tool.pitch_mm * input.tool.turns_per_s * input.duration_s);
  const double fed_mm = room_ahead_mm(walked.contacts, ahead, most_mm);
  tool.wound_from_tool.translation_mm += fed_mm * ahead;
  outcome.advance_mm = fed_mm;
  return fed_mm;
}

void begin_touch(BoreToolState& tool, BoreOutcome& outcome) noexcept {
  tool.stage = BoreStage::OnBone;
  tool.touch_depth_mm = tool.scratch_mm = 0.0;
  tool.is_refused = false;
  outcome.began_contact = true;
}

void go_on_touching(BoreToolState& tool, const BoreInput& input, const Walk& walked,
                    const BladeContact* tip, const ContactSettings& settings,
                    BoreOutcome& outcome) noexcept {
  tool.touch_depth_mm = std::max(0.0, tool.touch_depth_mm - walked.lifted_mm);
  if (tip == nullptr) {
    if (!teeth_are_clear(walked.contacts)) return;
    outcome.scratch_mm = tool.scratch_mm;
    tool.stage = BoreStage::Free;
    return;
  }
  const bool cuts = input.drive_runs && input.tool.bores && !tool.is_refused && !outcome.skids;
  if (!cuts || !(outcome.engaged.width_mm() > 0.0)) return;
  tool.touch_depth_mm += feed_touch(tool, input, walked, settings, outcome);
  tool.scratch_mm = std::max(tool.scratch_mm, tool.touch_depth_mm);
  outcome.wants_bore = tool.touch_depth_mm >= settings.freeze_depth_mm;
}

}  // namespace

double shaft_reach_mm(const BoreTool& tool) noexcept {
  return std::min(shaft_end_mm, tool.shaft_mm);
}

void move_outside_bore(BoreToolState& tool, const BoreInput& input, const DrilledWound& bone,
                       const ContactSettings& settings, double travel_limit_mm,
                       BoreOutcome& outcome) noexcept {
  const Walk walked = walk(tool, input, bone, settings, travel_limit_mm);
  lead_out(tool, walked.contacts);
  const BladeContact* tip = tip_contact(walked.contacts);
  if (tip != nullptr) {
    outcome.engaged = engaged_at(*tip, tool, input, bone);
    outcome.skids = input.drive_runs && is_flat(*tip, axis_x(tool.wound_from_tool));
  }
  const bool is_pushed = walked.proxy.normal_mm > 0.0 || tool.stage == BoreStage::OnBone;
  const ProxyMotion left = motion_between(tool.wound_from_tool, input.wound_from_handle);
  const bool is_stretched = reach_of(left, shaft_reach_mm(input.tool)) > slack_mm;
  tool.is_held = is_pushed || (tool.is_held && is_stretched);
  if (tool.stage == BoreStage::OnBone) {
    go_on_touching(tool, input, walked, tip, settings, outcome);
  } else if (tip != nullptr && outcome.engaged.width_mm() > 0.0) {
    begin_touch(tool, outcome);
    tool.is_held = true;
  }
}

}  // namespace hallux::simulator

/// In its bore the tool has one freedom: the way along the axis. It is walked in small steps from
/// the way before, so that no wall is jumped however fast the hand is: freely as deep as the bore
/// is open and where there is no bone, by the feed law where the tip's disc stands in some. What is
/// left aside of the axis from before the bore was entered goes gently. A screw is led by its
/// thread: in each turn at most its pitch, in a hole that is open as well, and back likewise.
#include "simulator/contact/bore/bore_inside.h"

#include <algorithm>
#include <cmath>

#include "simulator/contact/bore/bore_outside.h"
#include "simulator/contact/metal.h"

namespace hallux::simulator {

namespace {

/// Ways are walked in steps of this, at most `walk_steps` a tick.
constexpr double walk_step_mm = 0.1;
constexpr int walk_steps = 10;
/// How far in front of the tip bone and metal are asked for: it stands on bone, not in it.
constexpr double probe_ahead_mm = 0.02;
/// The ring of the disc's points, as a share of its radius: as much of the disc within as beyond.
constexpr double ring_share = 0.7071067811865476;
/// In front of a tip that came out there is no bone within this: a gap between fragments is none.
constexpr double beyond_mm = 1.0;
constexpr double beyond_step_mm = 0.25;
/// A tip drawn back by more than this since it was in bone is on its way out, not through.
constexpr double drawn_back_limit_mm = 1.0;
/// Drawn out: the tip is so far before the skin.
constexpr double leave_mm = 0.1;
/// A bore that is narrower than the tool by less than this is as wide.
constexpr double as_wide_mm = 1.0e-6;
/// A hand whose y lies nearer than this to the bore's axis says no turn about it.
constexpr double along_axis = 0.05;

/// Directions to the points of a ring, by square roots alone.
constexpr std::array<Vec2, 8> ring{Vec2{1.0, 0.0},  Vec2{ring_share, ring_share},
                                   Vec2{0.0, 1.0},  Vec2{-ring_share, ring_share},
                                   Vec2{-1.0, 0.0}, Vec2{-ring_share, -ring_share},
                                   Vec2{0.0, -1.0}, Vec2{ring_share, -ring_share}};
static_assert(bore_disc_points == 1 + ring.size() && bore_shoulder_points == ring.size());

/// The bore's axis and the way of points along it.
struct Axis {
  const RigidTransform& body_from_bore;

  Vec3 at(double way_mm, const Vec2& aside_mm = Vec2{0.0, 0.0}) const noexcept {
    return transform_point(body_from_bore, Vec3{way_mm, aside_mm.x, aside_mm.y});
  }
};

std::array<Vec3, bore_disc_points> disc_at(const Axis& axis, double way_mm,
                                           double radius_mm) noexcept {
  std::array<Vec3, bore_disc_points> points{};
  points[0] = axis.at(way_mm);
  for (std::size_t i = 0; i < ring.size(); ++i)
    points[i + 1] = axis.at(way_mm, ring_share * radius_mm * ring[i]);
  return points;
}

/// The tip's disc in mixed tissue: each point carries its share of the diameter.
Engagement disc_engagement(const std::array<Vec3, bore_disc_points>& disc, double radius_mm,
                           const DrilledWound& bone, DiscMemories& memory) noexcept {
  const double share_mm = 2.0 * radius_mm / static_cast<double>(bore_disc_points);
  Engagement engaged;
  for (std::size_t i = 0; i < disc.size(); ++i) {
    const Tissue tissue = bone.at(disc[i], memory[i]);
    if (tissue == Tissue::Cortical) engaged.cortical_mm += share_mm;
    if (tissue == Tissue::Cancellous) engaged.cancellous_mm += share_mm;
  }
  return engaged;
}

/// One tick's way along the axis.
class BoreWalk {
 public:
  BoreWalk(BoreToolState& state, const BoreInput& input, const DrilledWound& bone,
           const ContactSettings& settings, BoreOutcome& outcome) noexcept
      : state_(state),
        tool_(input.tool),
        input_(input),
        bone_(bone),
        settings_(settings),
        bore_(input.bores[static_cast<std::size_t>(state.bore)]),
        axis_{bore_.body_from_bore},
        open_mm_(bore_.radius_mm >= tool_.radius_mm - as_wide_mm ? bore_.depth_mm : 0.0),
        outcome_(outcome) {}

  /// From `way_mm` towards `wanted_mm` ahead; how far it came.
  double forward(double way_mm, double wanted_mm, double travel_limit_mm) noexcept {
    const double free_mm = std::min(wanted_mm, travel_limit_mm);
    double done_mm = 0.0, thread_mm = thread_way_mm(wanted_mm);
    for (int i = 0; i == 0 || (i < walk_steps && done_mm < free_mm); ++i) {
      const double at_mm = way_mm + done_mm;
      double step_mm = std::min(walk_step_mm, free_mm - done_mm);
      const bool is_open = at_mm < open_mm_;
      if (is_open) step_mm = std::min(step_mm, open_mm_ - at_mm);
      const bool is_held = !is_open && stands_in_bone(at_mm);
      if (is_held) step_mm = std::min(wanted_mm - done_mm, fed_mm(wanted_mm - done_mm));
      const bool is_led = tool_.is_screw() && at_mm >= 0.0;
      if (is_led) {
        step_mm = std::min(step_mm, thread_mm);
        thread_mm -= step_mm;
      } else if (tool_.is_screw()) {
        step_mm = std::min(step_mm, -at_mm);  // to where its thread takes hold
      }
      if (is_stopped(at_mm, step_mm)) step_mm = 0.0;
      done_mm += step_mm;
      if (is_held || is_led) outcome_.advance_mm += step_mm;
      if (is_held || !(step_mm > 0.0)) break;
    }
    return done_mm;
  }

  /// Back by up to `wanted_mm`; how far it came. A screw is turned out by a driver that is pulled.
  double backward(double wanted_mm, double travel_limit_mm) const noexcept {
    const double most_mm = state_.is_threaded ? thread_way_mm(wanted_mm) : wanted_mm;
    return std::min({wanted_mm, most_mm, travel_limit_mm});
  }

  /// Whether the tip comes out at the far side by having gone `done_mm` to `way_mm`.
  bool breaks_through(double way_mm, double done_mm) noexcept {
    if (outcome_.engaged.width_mm() > 0.0) {
      state_.may_break_through = true;
      state_.drawn_back_mm = 0.0;
      return false;
    }
    if (!state_.may_break_through) return false;
    state_.drawn_back_mm = std::max(0.0, state_.drawn_back_mm - done_mm);
    const bool is_out = done_mm > 0.0 && way_mm > open_mm_ && is_clear_beyond(way_mm);
    state_.may_break_through = !is_out && state_.drawn_back_mm <= drawn_back_limit_mm;
    return is_out;
  }

 private:
  /// What a thread allows in this tick: nothing without a running driver that is pushed or pulled.
  double thread_way_mm(double wanted_mm) const noexcept {
    const double push_newton = settings_.coupling_newton_per_mm * wanted_mm;
    const bool is_driven = input_.drive_runs && push_newton >= screw_push_newton;
    return is_driven ? tool_.pitch_mm * tool_.turns_per_s * input_.duration_s : 0.0;
  }

  bool stands_in_bone(double at_mm) noexcept {
    const auto disc = disc_at(axis_, at_mm + probe_ahead_mm, tool_.radius_mm);
    outcome_.engaged = disc_engagement(disc, tool_.radius_mm, bone_, state_.disc);
    return outcome_.engaged.width_mm() > 0.0;
  }

  /// By the feed law under what is left of the spring's stretch.
  double fed_mm(double left_mm) noexcept {
    const double force_newton =
        std::min(settings_.force_limit_newton, settings_.coupling_newton_per_mm * left_mm);
    state_.bone_force_newton = force_newton;
    if (!input_.drive_runs || !tool_.bores) return 0.0;
    return input_.duration_s * feed_rate_mm_s(outcome_.engaged, force_newton,
                                              tool_.law_cycles_per_minute, settings_.bone_quality);
  }

  /// Metal before a running tip, and bone before the shoulder.
  bool is_stopped(double at_mm, double step_mm) noexcept {
    if (input_.drive_runs && !input_.metal.empty()) {
      const auto tip = disc_at(axis_, at_mm + step_mm + probe_ahead_mm, tool_.radius_mm);
      outcome_.metal = metal_at(tip, input_.metal);
      if (outcome_.metal >= 0) return true;
    }
    if (!shoulder_stands(at_mm + step_mm - tool_.shaft_mm)) return false;
    outcome_.head_seated = tool_.is_screw();
    outcome_.chuck_stopped = !tool_.is_screw();
    return true;
  }

  bool shoulder_stands(double way_mm) noexcept {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 point = axis_.at(way_mm, tool_.shoulder_radius_mm * ring[i]);
      if (bone_.at(point, state_.shoulder[i]) != Tissue::None) return true;
    }
    return false;
  }

  /// Asked as if there were no holes: an old one is no far side.
  bool is_clear_beyond(double way_mm) const noexcept {
    for (const Vec3& point : disc_at(axis_, way_mm, tool_.radius_mm)) {
      if (bone_.undrilled_at(point) != Tissue::None) return false;
    }
    for (double ahead_mm = beyond_step_mm; ahead_mm <= beyond_mm; ahead_mm += beyond_step_mm) {
      if (bone_.undrilled_at(axis_.at(way_mm + ahead_mm)) != Tissue::None) return false;
    }
    return true;
  }

  BoreToolState& state_;
  const BoreTool& tool_;
  const BoreInput& input_;
  const DrilledWound& bone_;
  const ContactSettings& settings_;
  const Bore& bore_;
  Axis axis_;
  /// As deep as this tool goes freely.
  double open_mm_;
  BoreOutcome& outcome_;
};

/// The tool's rotation along the bore's axis, turned about it as the hand is.
Quat rotation_in_bore(const Bore& bore, const RigidTransform& wound_from_handle,
                      const RigidTransform& wound_from_tool) noexcept {
  const Vec3 axis = axis_x(bore.body_from_bore);
  for (const RigidTransform* hint : {&wound_from_handle, &wound_from_tool}) {
    const Vec3 y = axis_y(*hint);
    const double along = glm::dot(y, axis);
    if (1.0 - along * along > along_axis * along_axis) return rotation_from_axes(axis, y);
  }
  return bore.body_from_bore.rotation;
}

/// The pose at a way along the axis; what the tool lies aside or aslant from before is lessened by
/// the limit.
RigidTransform pose_in_bore(const Bore& bore, const BoreToolState& tool, const BoreInput& input,
                            double way_mm, double travel_limit_mm) noexcept {
  const Vec3 axis = axis_x(bore.body_from_bore), origin_mm = bore.body_from_bore.translation_mm;
  const Vec3 arm_mm = tool.wound_from_tool.translation_mm - origin_mm;
  const Vec3 aside_mm = arm_mm - glm::dot(arm_mm, axis) * axis;
  const double apart_mm = length_of(aside_mm);
  const double kept = apart_mm > travel_limit_mm ? 1.0 - travel_limit_mm / apart_mm : 0.0;
  const RigidTransform wanted{rotation_in_bore(bore, input.wound_from_handle, tool.wound_from_tool),
                              origin_mm + way_mm * axis + kept * aside_mm};
  const ProxyMotion turn = motion_between(tool.wound_from_tool, wanted);
  const double turn_mm = shaft_reach_mm(input.tool) * length_of(turn.rotation_rad);
  const double share = turn_mm > travel_limit_mm ? travel_limit_mm / turn_mm : 1.0;
  return {interpolate(tool.wound_from_tool, wanted, share).rotation, wanted.translation_mm};
}

}  // namespace

std::array<Vec3, bore_disc_points> tip_disc(const RigidTransform& wound_from_tool,
                                            double radius_mm) noexcept {
  return disc_at(Axis{wound_from_tool}, probe_ahead_mm, radius_mm);
}

void move_in_bore(BoreToolState& tool, const BoreInput& input, const DrilledWound& bone,
                  const ContactSettings& settings, double travel_limit_mm,
                  BoreOutcome& outcome) noexcept {
  const Bore& bore = input.bores[static_cast<std::size_t>(tool.bore)];
  const double way_mm = way_along(bore, tool.wound_from_tool.translation_mm);
  const double wanted_mm = way_along(bore, input.wound_from_handle.translation_mm) - way_mm;
  BoreWalk walk(tool, input, bone, settings, outcome);
  const double done_mm = wanted_mm >= 0.0 ? walk.forward(way_mm, wanted_mm, travel_limit_mm)
                                          : -walk.backward(-wanted_mm, travel_limit_mm);
  const double reached_mm = way_mm + done_mm;
  tool.wound_from_tool = pose_in_bore(bore, tool, input, reached_mm, travel_limit_mm);

  outcome.broke_through = walk.breaks_through(reached_mm, done_mm);
  if (outcome.broke_through) outcome.broke_at_newton = tool.bone_force_newton;
  if (input.tool.is_screw()) {
    tool.is_threaded = reached_mm > 0.0;
    const bool is_pushed = settings.coupling_newton_per_mm * wanted_mm >= screw_push_newton;
    outcome.spins = input.drive_runs && is_pushed && !(done_mm > 0.0);
  }
  if (wanted_mm < 0.0 && reached_mm <= -leave_mm) {
    tool.stage = BoreStage::Free;
    tool.is_held = true;
    tool.bore = -1;
  }
}

}  // namespace hallux::simulator

#include "scenarios/hands/scripted_hand.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/hands/stroke_plan.h"
#include "scenarios/hands/stroke_timing.h"
#include "simulator/base/elementary.h"
#include "simulator/base/random.h"
#include "simulator/base/units.h"
#include "simulator/contact/tool_motion.h"
#include "simulator/cutting/section.h"

namespace hallux::scenarios {

namespace {

using simulator::Bone;
using simulator::CommandKind;
using simulator::CutSolid;
using simulator::KerfPlane;
using simulator::Section;
using simulator::SectionRegion;

constexpr double overlap_mm = 3.0;
constexpr double hover_mm = 15.0;        ///< in front of the bone between strokes
constexpr double settle_mm = 2.0;        ///< in front of the bone before sawing
constexpr double lean_mm_s = 6.0;        ///< how fast a hand builds up its push
constexpr double beyond_mm = 1.5;        ///< on after the last bone that was expected
constexpr std::int64_t key_ticks = 20;   ///< a key every 20 ms carries the wander
constexpr double tilt_spread_rad = 0.5;  ///< of the axis of a tilt about the blade's tooth line
constexpr double smallest_angle_deg = 0.3;
constexpr double smallest_location_mm = 0.05;

Vec3 side_direction(std::string_view side) {
  if (side == "dorsal") return {0.0, 1.0, 0.0};
  if (side == "plantar") return {0.0, -1.0, 0.0};
  if (side == "medial") return {0.0, 0.0, -1.0};
  if (side == "lateral") return {0.0, 0.0, 1.0};
  throw ScenarioError("a hand cannot approach from \"" + std::string(side) +
                      "\"; use dorsal, plantar, medial or lateral");
}

/// The blade's frame for a face: z towards the waste, x along the feed, half a kerf off the finished face.
RigidTransform blade_frame(const ReferenceFace& face, const Vec3& feed_hint, const Vec3& near_mm,
                           double kerf_mm) {
  const Vec3& z = face.normal;
  const Vec3 x = feed_hint - glm::dot(feed_hint, z) * z;
  const Vec3 origin = near_mm + (face.offset_mm + 0.5 * kerf_mm - glm::dot(near_mm, z)) * z;
  return {rotation_from_axes(x, glm::cross(z, x)), origin};
}

/// The part of the section that holds the waste side's most prominent point.
const SectionRegion* region_near(const Section& section, const Vec3& point_in_bone_mm) {
  const Vec3 local = transform_point(inverse(section.plane.bone_from_kerf), point_in_bone_mm);
  const SectionRegion* best = nullptr;
  double best_mm = std::numeric_limits<double>::infinity();
  for (const SectionRegion& region : section.regions) {
    const double dx = std::max({region.min_mm.x - local.x, 0.0, local.x - region.max_mm.x});
    const double dy = std::max({region.min_mm.y - local.y, 0.0, local.y - region.max_mm.y});
    const double distance_mm = std::sqrt(dx * dx + dy * dy);
    if (distance_mm < best_mm) {
      best_mm = distance_mm;
      best = &region;
    }
  }
  return best;
}

/// The wander of a hand: three slow waves with phases of their own, within +-1.
class Wander {
 public:
  explicit Wander(Random random) {
    for (Wave& wave : waves_) {
      wave.rate_rad_s = 2.0 * pi * random.uniform(0.15, 0.9);
      wave.phase_rad = 2.0 * pi * random.uniform();
    }
  }
  double at(double time_s) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) {
      const double angle_rad = wave.rate_rad_s * time_s + wave.phase_rad;
      sum += elementary::sin(angle_rad);
    }
    return sum / 3.0;
  }

 private:
  struct Wave {
    double rate_rad_s = 0.0, phase_rad = 0.0;
  };
  std::array<Wave, 3> waves_{};
};

/// Writes keys at a steady rhythm along straight ways in the blade's plane.
class MotionWriter {
 public:
  MotionWriter(const RigidTransform& world_from_blade, const HandSkill& skill, std::uint64_t seed)
      : world_from_blade_(world_from_blade),
        skill_(skill),
        out_(Random(seed, "wander.out")),
        tilt_x_(Random(seed, "wander.tilt_x")),
        tilt_y_(Random(seed, "wander.tilt_y")) {}

  void place(double feed_mm, double along_mm) {
    feed_mm_ = feed_mm;
    along_mm_ = along_mm;
    write_key();
  }
  void go_to(double feed_mm, double along_mm, double speed_mm_s, double wander_from = 0.0,
             double wander_to = 0.0) {
    const double way_mm = std::max(std::abs(feed_mm - feed_mm_), std::abs(along_mm - along_mm_));
    const auto keys = std::max<std::int64_t>(
        1, static_cast<std::int64_t>(
               std::ceil(way_mm / speed_mm_s / step_s / static_cast<double>(key_ticks))));
    const double from_feed_mm = feed_mm_, from_along_mm = along_mm_;
    for (std::int64_t i = 1; i <= keys; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(keys);
      feed_mm_ = from_feed_mm + share * (feed_mm - from_feed_mm);
      along_mm_ = from_along_mm + share * (along_mm - from_along_mm);
      wander_ = wander_from + share * (wander_to - wander_from);
      tick_ += key_ticks;
      write_key();
    }
  }
  /// Leads the teeth through their expected feed by the way that stretches the coupling to the push.
  void push_through(const std::vector<FeedMoment>& moments, double coupling_newton_per_mm) {
    const double duration_s = moments.back().time_s;
    const auto keys = static_cast<std::int64_t>(duration_s / step_s) / key_ticks + 1;
    std::size_t next = 0;
    double lead_mm = 0.0;
    for (std::int64_t i = 1; i <= keys; ++i) {
      const double time_s = second_from_tick(i * key_ticks);
      while (next + 1 < moments.size() && moments[next + 1].time_s <= time_s) ++next;
      const double wanted_mm = moments[next].push_newton / coupling_newton_per_mm;
      const double most_mm = lean_mm_s * second_from_tick(key_ticks);
      lead_mm += std::clamp(wanted_mm - lead_mm, -most_mm, most_mm);
      feed_mm_ = moments[next].feed_mm + lead_mm;
      // A hand starts its kerf with care: it wanders once the blade is held by the bone.
      wander_ =
          std::clamp(0.4 * (time_s - 2.0), 0.0, std::min(1.0, 0.3 + 0.5 * (duration_s - time_s)));
      tick_ += key_ticks;
      write_key();
    }
  }
  void wait(double time_s) {
    const auto keys = static_cast<std::int64_t>(time_s / step_s) / key_ticks;
    for (std::int64_t i = 0; i < keys; ++i) {
      tick_ += key_ticks;
      write_key();
    }
  }
  void set_saw(bool runs) { saw_runs_ = runs; }
  void set_jitter(double out_mm, double tilt_rad) {
    jitter_mm_ = out_mm;
    jitter_rad_ = tilt_rad;
  }
  void say(CommandKind kind, std::int32_t argument = 0) {
    motion_.commands.push_back({tick_, {kind, argument, 0}});
  }
  simulator::HandMotion finish() { return std::move(motion_); }

 private:
  void write_key() {
    const double time_s = second_from_tick(tick_);
    const double tilt_x = jitter_rad_ + wander_ * skill_.wander_rad * tilt_x_.at(time_s);
    const double tilt_y = wander_ * skill_.wander_rad * tilt_y_.at(time_s);
    const double out_mm = jitter_mm_ + wander_ * skill_.wander_mm * out_.at(time_s);
    const RigidTransform blade_from_handle{normalised(Quat{1.0, 0.5 * tilt_x, 0.5 * tilt_y, 0.0}),
                                           Vec3{feed_mm_, along_mm_, out_mm}};
    const std::uint32_t saw =
        saw_runs_ ? static_cast<std::uint32_t>(simulator::Switch::SawRuns) : 0U;
    motion_.keys.push_back({tick_, world_from_blade_ * blade_from_handle, saw});
  }

  RigidTransform world_from_blade_;
  HandSkill skill_;
  Wander out_, tilt_x_, tilt_y_;
  simulator::HandMotion motion_;
  std::int64_t tick_ = 0;
  double feed_mm_ = 0.0, along_mm_ = 0.0, wander_ = 0.0;
  double jitter_mm_ = 0.0, jitter_rad_ = 0.0;
  bool saw_runs_ = false;
};

struct AimedFace {
  ReferenceFace face;
  double angle_rad = 0.0;
  double location_mm = 0.0;
};

/// Tilts the planned face about the middle of its section, then shifts it until the largest distance over the
/// section is the drawn location error, or the tilt alone reaches farther.
AimedFace draw_face(const PlannedCut& cut, const KerfPlane& plan_plane, const SectionRegion& region,
                    const HandSkill& skill, std::uint64_t seed) {
  Random random(seed, "hand.aim");
  const double angle_rad = radian_from_degree(
      std::max(smallest_angle_deg,
               random.truncated_normal(skill.angle_mean_deg, skill.angle_deviation_deg, 2.0)));
  const double location_mm =
      std::max(smallest_location_mm,
               random.truncated_normal(skill.location_mean_mm, skill.location_deviation_mm, 2.0));
  // A hand sees the direction along the bone better than its blade's tilt about that direction.
  const double turn_rad =
      0.5 * pi + random.uniform(-1.0, 1.0) * tilt_spread_rad + (random.uniform() < 0.5 ? 0.0 : pi);
  const double side = random.uniform() < 0.5 ? -1.0 : 1.0;

  const RigidTransform& bone_from_plan = plan_plane.bone_from_kerf;
  const Vec3 tilt_axis = transform_direction(
      bone_from_plan, Vec3{elementary::cos(turn_rad), elementary::sin(turn_rad), 0.0});
  const Vec2 middle = 0.5 * (region.min_mm + region.max_mm);
  const Vec3 pivot = transform_point(bone_from_plan, Vec3{middle.x, middle.y, 0.0}) -
                     0.5 * plan_plane.thickness_mm * cut.face.normal;
  AimedFace aimed;
  aimed.face.normal =
      transform_direction({rotation_about(tilt_axis, angle_rad), {}}, cut.face.normal);
  double reach_low_mm = 0.0, reach_high_mm = 0.0;
  for (const simulator::Contour& contour : region.contours) {
    for (const Vec2& point : contour) {
      const Vec3 offset = transform_direction(bone_from_plan, Vec3{point - middle, 0.0});
      // How far the tilted face stands off the plan above this point of the section.
      const double stand_off_mm =
          -glm::dot(offset, aimed.face.normal) / glm::dot(cut.face.normal, aimed.face.normal);
      reach_low_mm = std::min(reach_low_mm, stand_off_mm);
      reach_high_mm = std::max(reach_high_mm, stand_off_mm);
    }
  }
  const double reach_mm = side > 0.0 ? reach_high_mm : -reach_low_mm;
  const double shift_mm = side * std::max(0.0, location_mm - reach_mm);
  aimed.face.offset_mm = glm::dot(aimed.face.normal, pivot + shift_mm * cut.face.normal);
  aimed.angle_rad = angle_rad;
  aimed.location_mm = std::max({location_mm, reach_high_mm, -reach_low_mm});
  return aimed;
}

void write_stroke(MotionWriter& writer, const Stroke& stroke,
                  const std::vector<FeedMoment>& moments, const HandSkill& skill) {
  const double coupling_newton_per_mm = simulator::ContactSettings{}.coupling_newton_per_mm;
  writer.go_to(stroke.first_mm - hover_mm, stroke.along_mm, skill.approach_mm_s);
  writer.set_saw(true);
  writer.go_to(stroke.first_mm - settle_mm, stroke.along_mm, skill.approach_mm_s);
  writer.wait(0.2);
  writer.go_to(stroke.first_mm, stroke.along_mm, lean_mm_s);
  writer.push_through(moments, coupling_newton_per_mm);
  writer.go_to(stroke.last_mm + beyond_mm + skill.push.exit_newton / coupling_newton_per_mm,
               stroke.along_mm, lean_mm_s, 0.3, 0.3);
  writer.wait(1.0);
  writer.go_to(stroke.first_mm - hover_mm, stroke.along_mm, skill.approach_mm_s, 0.3, 0.0);
  writer.set_saw(false);
}

/// What a cut is carried out with.
struct Sawing {
  const std::vector<Stroke>& strokes;
  const KerfPlane& plane;
  const simulator::TissueMap& tissue;
  const SawBlade& blade;
};

void write_cut(MotionWriter& writer, const Sawing& sawing, const HandSkill& skill,
               std::uint64_t seed) {
  Random jitter(seed, "hand.strokes");
  for (std::size_t i = 0; i < sawing.strokes.size(); ++i) {
    // The first stroke makes the plane; later ones come back to it as well as the hand can.
    if (i > 0) {
      writer.set_jitter(jitter.truncated_normal(0.0, skill.stroke_jitter_mm),
                        jitter.truncated_normal(0.0, skill.stroke_jitter_rad));
    }
    const std::vector<FeedMoment> moments = predict_feed(
        sawing.strokes[i], std::span(sawing.strokes).first(i), sawing.plane, sawing.tissue,
        sawing.blade.size.width_mm, sawing.blade.cycles_per_minute, skill.push);
    write_stroke(writer, sawing.strokes[i], moments, skill);
  }
}

}  // namespace

HandSkill hand_skill(std::string_view name) {
  if (name == "expert") return {};
  if (name == "novice") {
    HandSkill novice;
    novice.angle_mean_deg = 9.0;
    novice.angle_deviation_deg = 5.0;
    novice.location_mean_mm = 3.0;
    novice.location_deviation_mm = 1.5;
    novice.wander_mm = 4.0;
    novice.wander_rad = 0.06;
    novice.stroke_jitter_mm = 0.25;
    novice.stroke_jitter_rad = 0.015;
    novice.approach_mm_s = 60.0;
    novice.push = {26.0, 26.0, 2.5};
    return novice;
  }
  throw ScenarioError("there is no hand \"" + std::string(name) +
                      "\"; use expert, novice, or a file with a motion");
}

ScriptedHand make_hand(const Scenario& scenario, const Bone& bone, const Plan& plan,
                       const HandSkill& skill, std::uint64_t seed) {
  if (plan.cuts.size() != 1) {
    throw ScenarioError(scenario.name + ": cuts: the scripted hands carry out one cut, this has " +
                        std::to_string(plan.cuts.size()) +
                        "; give a motion of your own with a file");
  }
  const PlannedCut& cut = plan.cuts.front();
  const Vec3 feed_hint = -side_direction(scenario.cuts.at(0).approach);
  const double kerf_mm = scenario.blade.size.kerf_mm;
  const Vec3 near = find_landmark(bone, "eminence_apex").value_or(cut.depth_point_in_bone_mm);
  const CutSolid solid = simulator::uncut_solid(solid_of(bone));
  const simulator::Bvh bvh(solid.mesh);
  const auto section_of = [&](const ReferenceFace& face) {
    return slice_section(solid, bvh, {blade_frame(face, feed_hint, near, kerf_mm), kerf_mm});
  };
  const auto region_of = [&](const Section& section) -> const SectionRegion& {
    const SectionRegion* region = region_near(section, near);
    if (region != nullptr && !region->contours.empty()) return *region;
    throw ScenarioError("the hand's plane misses the bone for seed " + std::to_string(seed) +
                        "; choose another seed");
  };

  const Section planned = section_of(cut.face);
  const AimedFace aimed = draw_face(cut, planned.plane, region_of(planned), skill, seed);
  const Section section = section_of(aimed.face);
  const std::vector<Stroke> strokes =
      plan_strokes(region_of(section), scenario.blade.size.width_mm, overlap_mm);

  MotionWriter writer(bone.world_from_bone * section.plane.bone_from_kerf, skill, seed);
  writer.place(strokes.front().first_mm - 3.0 * hover_mm, strokes.front().along_mm);
  writer.say(CommandKind::Start);
  const simulator::TissueMap tissue(bone);
  const Sawing sawing{strokes, section.plane, tissue, scenario.blade};
  for (std::size_t step = 0; step < scenario.steps.size(); ++step) {
    const StepKind kind = scenario.steps[step].kind;
    if (kind == StepKind::Cut) write_cut(writer, sawing, skill, seed);
    if (kind == StepKind::Remove) writer.say(CommandKind::PickUp, 1);
    writer.wait(kind == StepKind::Verify ? 1.0 : 0.5);
    writer.say(CommandKind::StepDone, static_cast<std::int32_t>(step));
  }
  writer.say(CommandKind::Finish);
  return {writer.finish(), aimed.face, aimed.angle_rad, aimed.location_mm};
}

}  // namespace hallux::scenarios

/// A first cut is tilted about the middle of its planned section and then shifted until the largest
/// distance over the section is the drawn one: angle and place are what a rubric measures, so they
/// are what is drawn. A second cut of a wedge is measured off from the first, as a surgeon does who
/// sees it. Each cut draws from random streams of its own, named by cut, so that another cut in the
/// scenario changes none of the others.
#include "scenarios/hands/hand_aim.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "scenarios/faces/windowed_region.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/elementary.h"
#include "simulator/base/random.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {

namespace {

using simulator::KerfPlane;
using simulator::Section;
using simulator::SectionRegion;

constexpr double tilt_spread_rad = 0.5;  ///< of the axis of a tilt about the blade's tooth line

/// One cut to aim at.
struct Target {
  const PlannedCut& cut;
  Vec3 feed_hint;
  Vec3 near_mm;  ///< a point of the part that is cut, near the face
  double kerf_mm;
  std::uint64_t seed;
  std::string stream;  ///< name of its random numbers
};

/// The blade's frame for a face: x along the feed, half a kerf off the finished face. z points
/// towards the waste; across the bone it points distal in every cut, so that nobody turns the saw
/// over between two of them.
RigidTransform blade_frame(const ReferenceFace& face, const Target& target) {
  const Vec3& normal = face.normal;
  const bool is_turned = !target.cut.is_along_bone && normal.x < 0.0;
  const Vec3 z = is_turned ? -normal : normal;
  const Vec3 x = target.feed_hint - glm::dot(target.feed_hint, z) * z;
  const Vec3 origin =
      target.near_mm +
      (face.offset_mm + 0.5 * target.kerf_mm - glm::dot(target.near_mm, normal)) * normal;
  return {rotation_from_axes(x, glm::cross(z, x)), origin};
}

/// The part of the section that holds the point, or lies nearest to it.
const SectionRegion* region_near(const Section& section, const Vec3& point_in_bone_mm) {
  const Vec3 local = transform_point(inverse(section.plane.bone_from_kerf), point_in_bone_mm);
  const SectionRegion* best = nullptr;
  double best_mm = std::numeric_limits<double>::infinity();
  for (const SectionRegion& region : section.regions) {
    const double dx = std::max({region.min_mm.x - local.x, 0.0, local.x - region.max_mm.x});
    const double dy = std::max({region.min_mm.y - local.y, 0.0, local.y - region.max_mm.y});
    const double distance_mm = length_of(Vec2{dx, dy});
    if (distance_mm < best_mm) {
      best_mm = distance_mm;
      best = &region;
    }
  }
  return best;
}

/// The blade's plane for a face, and the bone in it.
struct Sight {
  KerfPlane plane;
  SectionRegion region;
};

/// Nothing where the plane misses the bone.
std::optional<Sight> look_along(const ReferenceFace& face, const Target& target,
                                const KnownBone& known) {
  const KerfPlane plane{blade_frame(face, target), target.kerf_mm};
  const Section section = slice_section(known.solid, known.bvh, plane);
  const SectionRegion* region = region_near(section, target.near_mm);
  if (region == nullptr || region->contours.empty()) return std::nullopt;
  if (!target.cut.window) return Sight{plane, *region};
  SectionRegion within = within_window(*region, plane, *target.cut.window);
  if (within.contours.empty()) return std::nullopt;
  return Sight{plane, std::move(within)};
}

/// Of a face that lies in the bone; `else_why` ends the refusal.
Sight must_see(std::optional<Sight> seen, const Target& target, const std::string& else_why) {
  if (seen) return *std::move(seen);
  throw ScenarioError("cut \"" + target.cut.name + "\": " + else_why);
}

/// A hand that sees its plane miss the bone aims again, so often at most.
constexpr int aims_most = 100;
/// Of the planned section: a plane that meets less of the bone grazes it, and a blade laid on it
/// slides off.
constexpr double grazing_share = 0.2;

bool grazes(const Sight& seen, const Sight& planned) noexcept {
  return seen.region.area_mm2 < grazing_share * planned.region.area_mm2;
}

/// Each aim draws from streams of its own; the first ones have no number.
Target aimed_again(Target target, int times) {
  if (times > 0) target.stream += ".again" + std::to_string(times);
  return target;
}

/// What a hand gets wrong in one cut.
struct AimErrors {
  double angle_rad, location_mm;
  double turn_rad;  ///< of the axis of the tilt, from the feed
  double side;      ///< of the shift: +1 or -1
};

AimErrors draw_errors(const Target& target, const HandSkill& skill) {
  Random random(target.seed, "hand.aim" + target.stream);
  const double angle_rad = radian_from_degree(
      std::max(skill.least_angle_deg,
               random.truncated_normal(skill.angle_mean_deg, skill.angle_deviation_deg, 2.0)));
  const double location_mm =
      std::max(skill.least_location_mm,
               random.truncated_normal(skill.location_mean_mm, skill.location_deviation_mm, 2.0));
  // Along a bone a hand sees the direction better than its blade's tilt about it; across it sees
  // neither.
  const double spread_rad = target.cut.is_along_bone ? tilt_spread_rad : 0.5 * pi;
  const double turn_rad =
      0.5 * pi + random.uniform(-1.0, 1.0) * spread_rad + (random.uniform() < 0.5 ? 0.0 : pi);
  const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
  return {angle_rad, location_mm, turn_rad, side};
}

/// The normal, tilted about a line in the blade's plane.
Vec3 tilted(const Vec3& normal, const KerfPlane& plane, const AimErrors& errors) {
  const Vec3 axis = transform_direction(
      plane.bone_from_kerf,
      Vec3{elementary::cos(errors.turn_rad), elementary::sin(errors.turn_rad), 0.0});
  return transform_direction({rotation_about(axis, errors.angle_rad), {}}, normal);
}

/// The middle of the planned section, on the finished face.
Vec3 middle_in_bone_mm(const Target& target, const Sight& planned) {
  const Vec2 middle = 0.5 * (planned.region.min_mm + planned.region.max_mm);
  return transform_point(planned.plane.bone_from_kerf, Vec3{middle.x, middle.y, 0.0}) -
         0.5 * target.kerf_mm * target.cut.face.normal;
}

/// Largest distance of a face from the plan over the planned section, along the plan's normal.
double largest_stand_off_mm(const Target& target, const Sight& planned, const ReferenceFace& face) {
  const Vec3& normal = target.cut.face.normal;
  double largest_mm = 0.0;
  for (const simulator::Contour& contour : planned.region.contours) {
    for (const Vec2& point : contour) {
      const Vec3 on_plan = transform_point(planned.plane.bone_from_kerf, Vec3{point, 0.0}) -
                           0.5 * target.kerf_mm * normal;
      const double stand_off_mm =
          (face.offset_mm - glm::dot(face.normal, on_plan)) / glm::dot(normal, face.normal);
      largest_mm = std::max(largest_mm, std::abs(stand_off_mm));
    }
  }
  return largest_mm;
}

/// Tilts the planned face about the middle of its section, then shifts it until the largest
/// distance over the section is the drawn location error, or the tilt alone reaches farther.
void aim_at_plan(const Target& target, const Sight& planned, const AimErrors& errors,
                 AimedCut& aimed) {
  const PlannedCut& cut = target.cut;
  const RigidTransform& bone_from_plan = planned.plane.bone_from_kerf;
  const Vec2 middle = 0.5 * (planned.region.min_mm + planned.region.max_mm);
  const Vec3 pivot = middle_in_bone_mm(target, planned);
  aimed.face.normal = tilted(cut.face.normal, planned.plane, errors);
  double least_off_mm = 0.0, greatest_off_mm = 0.0;
  for (const simulator::Contour& contour : planned.region.contours) {
    for (const Vec2& point : contour) {
      const Vec3 offset = transform_direction(bone_from_plan, Vec3{point - middle, 0.0});
      // How far the tilted face stands off the plan above this point of the section.
      const double stand_off_mm =
          -glm::dot(offset, aimed.face.normal) / glm::dot(cut.face.normal, aimed.face.normal);
      least_off_mm = std::min(least_off_mm, stand_off_mm);
      greatest_off_mm = std::max(greatest_off_mm, stand_off_mm);
    }
  }
  const double tilt_off_mm = errors.side > 0.0 ? greatest_off_mm : -least_off_mm;
  const double shift_mm = errors.side * std::max(0.0, errors.location_mm - tilt_off_mm);
  aimed.face.offset_mm = glm::dot(aimed.face.normal, pivot + shift_mm * cut.face.normal);
  aimed.location_error_mm = std::max({errors.location_mm, greatest_off_mm, -least_off_mm});
}

/// Where the bone of a section reaches furthest along the feed.
Vec2 far_point(const SectionRegion& region) {
  Vec2 far = region.contours.front().front();
  for (const simulator::Contour& contour : region.contours) {
    for (const Vec2& point : contour) {
      if (point.x > far.x) far = point;
    }
  }
  return far;
}

/// A point of the line at which a first cut is to stop, on its finished face.
Vec3 line_point(const AimedCut& first, double thickness_mm) {
  const Vec2 far = far_point(first.region);
  return transform_point(first.plane.bone_from_kerf, Vec3{far.x - thickness_mm, far.y, 0.0}) -
         0.5 * first.plane.thickness_mm * first.face.normal;
}

/// The first cut as it was planned and as it was aimed, and a point of the line at which it is to
/// stop.
struct FirstCut {
  const PlannedCut& planned;
  const AimedCut& aimed;
  Vec3 line_in_bone_mm;
};

/// What the turn from the planned first face to the aimed one makes of a direction.
Vec3 turned_like(const FirstCut& first, const Vec3& direction) {
  const Vec3 axis = glm::cross(first.planned.face.normal, first.aimed.face.normal);
  const double sine = length_of(axis);
  if (sine == 0.0) return direction;
  const double angle_rad =
      elementary::atan2(sine, glm::dot(first.planned.face.normal, first.aimed.face.normal));
  return transform_direction({rotation_about(axis / sine, angle_rad), {}}, direction);
}

/// A second cut is measured off from the first, which can be seen: the planned wedge is laid to the
/// face that the hand aimed at, tilted, and led to the first cut's line as well as the hand meets
/// it.
void aim_at_line(const Target& target, const Sight& planned, const FirstCut& first,
                 const AimErrors& errors, const HandSkill& skill, AimedCut& aimed) {
  const PlannedCut& cut = target.cut;
  Random random(target.seed, "hand.meet" + target.stream);
  aimed.face.normal = tilted(turned_like(first, cut.face.normal), planned.plane, errors);
  aimed.face.offset_mm = glm::dot(aimed.face.normal, first.line_in_bone_mm) +
                         random.truncated_normal(0.0, skill.meet_deviation_mm, 2.0);
  aimed.location_error_mm = largest_stand_off_mm(target, planned, aimed.face);
}

/// Turns and shifts the aimed face on purpose, about the middle of the planned section.
void add_faults(const Target& target, const Sight& planned, const HandSkill& skill,
                AimedCut& aimed) {
  const PlannedCut& cut = target.cut;
  const auto size_of = [&](FaultKind kind) { return fault_size(skill.faults, kind, cut.name); };
  aimed.run_on_mm = size_of(FaultKind::OverCut) - size_of(FaultKind::StopShort);
  const double tilt_rad = radian_from_degree(size_of(FaultKind::Tilt));
  const double roll_rad = radian_from_degree(size_of(FaultKind::Roll));
  const double shift_mm = size_of(FaultKind::Offset);
  if (tilt_rad == 0.0 && roll_rad == 0.0 && shift_mm == 0.0) return;
  const Vec3& plan_normal = cut.face.normal;
  const Vec3 pivot = middle_in_bone_mm(target, planned);
  const double off_pivot_mm = aimed.face.offset_mm - glm::dot(aimed.face.normal, pivot);
  const Vec3& contained = cut.contained_in_bone;
  const Quat tilt = rotation_about(contained, tilt_rad);
  const Quat roll = rotation_about(glm::cross(plan_normal, contained), roll_rad);
  aimed.face.normal =
      transform_direction(RigidTransform{tilt, {}} * RigidTransform{roll, {}}, aimed.face.normal);
  aimed.face.offset_mm = glm::dot(aimed.face.normal, pivot) + off_pivot_mm +
                         shift_mm * glm::dot(aimed.face.normal, plan_normal);
  aimed.angle_error_rad = elementary::atan2(length_of(glm::cross(plan_normal, aimed.face.normal)),
                                            glm::dot(plan_normal, aimed.face.normal));
  aimed.location_error_mm = largest_stand_off_mm(target, planned, aimed.face);
}

/// How far beyond the hinge's line the cuts stop: a second cut follows the end of the first.
double stop_error_mm(const PlannedHinge& hinge, const PlannedCut& cut, const HandSkill& skill,
                     std::uint64_t seed) {
  Random random(seed, "hand.stop." + hinge.name);
  const double first_mm = random.truncated_normal(skill.stop_mean_mm, skill.stop_deviation_mm, 2.0);
  const double second_mm = first_mm + random.truncated_normal(0.0, skill.meet_deviation_mm, 2.0);
  return cut.name == hinge.first_cut ? first_mm : second_mm;
}

Target target_of(const Scenario& scenario, const Plan& plan, std::size_t index,
                 const KnownBone& known, std::uint64_t seed) {
  const PlannedCut& cut = plan.cuts[index];
  const Vec3 near =
      cut.is_along_bone
          ? find_landmark(known.bone, "eminence_apex").value_or(cut.depth_point_in_bone_mm)
          : cut.entry_point_in_bone_mm;
  return {cut,  -cut.approach_in_bone,
          near, blade_of(scenario, cut).kerf_mm,
          seed, index == 0 ? std::string() : "." + cut.name};
}

/// Where the hinge's line is in the blade's plane: as planned, or as far inside the bone that is
/// seen.
double line_mm(const PlannedHinge& hinge, const HandSkill& skill, const AimedCut& aimed) {
  const simulator::HingeLine& line = hinge.bridge.line;
  if (!skill.keeps_to_plan) return far_point(aimed.region).x - line.thickness_mm;
  return transform_point(inverse(aimed.plane.bone_from_kerf), line.point_in_bone_mm).x;
}

void plan_stop(const Plan& plan, const HandSkill& skill, const Target& target, AimedCut& aimed) {
  const PlannedHinge* hinge = find_hinge(plan, target.cut.hinge);
  if (hinge == nullptr) return;
  const double error_mm = stop_error_mm(*hinge, target.cut, skill, target.seed) + aimed.run_on_mm;
  aimed.stop_mm = line_mm(*hinge, skill, aimed) + error_mm;
  aimed.loses_hinge = error_mm >= hinge->bridge.line.thickness_mm;
}

}  // namespace

KnownBone::KnownBone(const simulator::Bone& known)
    : bone(known), solid(simulator::uncut_solid(solid_of(known))), bvh(solid.mesh) {}

std::vector<AimedCut> aim(const Scenario& scenario, const Plan& plan, const KnownBones& known,
                          const HandSkill& skill, std::uint64_t seed) {
  std::vector<AimedCut> aims(plan.cuts.size());
  const auto aim_at = [&](const Target& target, const Sight& planned, AimedCut& aimed) {
    const AimErrors errors = draw_errors(target, skill);
    aimed = {};
    aimed.angle_error_rad = errors.angle_rad;
    if (target.cut.is_turned_about_hinge && !skill.keeps_to_plan) {
      const PlannedHinge& hinge = *find_hinge(plan, target.cut.hinge);
      const std::size_t first = index_of_cut(plan, hinge.first_cut);
      const AimedCut& made = aims[first];
      aim_at_line(target, planned,
                  {plan.cuts[first], made, line_point(made, hinge.bridge.line.thickness_mm)},
                  errors, skill, aimed);
    } else {
      aim_at_plan(target, planned, errors, aimed);
    }
    add_faults(target, planned, skill, aimed);
    std::optional<Sight> seen = look_along(aimed.face, target, known[target.cut.bone]);
    // Who lays it so on purpose does.
    if (seen && skill.faults.empty() && grazes(*seen, planned)) seen.reset();
    return seen;
  };
  const auto aim_one = [&](std::size_t index) {
    const KnownBone& bone = known[plan.cuts[index].bone];
    const Target target = target_of(scenario, plan, index, bone, seed);
    const Sight planned = must_see(look_along(target.cut.face, target, bone), target,
                                   "its planned face misses the bone; mend the plan");
    AimedCut& aimed = aims[index];
    std::optional<Sight> seen;
    for (int times = 0; !seen && times < aims_most; ++times)
      seen = aim_at(aimed_again(target, times), planned, aimed);
    const Sight met =
        must_see(std::move(seen), target,
                 "a hand that errs so far never meets the bone with seed " + std::to_string(seed) +
                     "; choose another seed" + (skill.faults.empty() ? "" : ", or smaller faults"));
    aimed.plane = met.plane;
    aimed.region = met.region;
    aimed.bone = target.cut.bone;
    plan_stop(plan, skill, target, aimed);
  };
  // A face through a hinge is aimed at the end of another cut.
  for (const bool is_through_hinge : {false, true}) {
    for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
      if (plan.cuts[i].is_turned_about_hinge == is_through_hinge) aim_one(i);
    }
  }
  return aims;
}

}  // namespace hallux::scenarios

#include "assessment/rebuild/implants.h"

#include <algorithm>
#include <memory>

#include "assessment/rebuild/bone_surfaces.h"
#include "assessment/rebuild/planned_implants.h"
#include "assessment/rebuild/recording_begin.h"
#include "scenarios/site/plan_in_first.h"
#include "simulator/cutting/hole/axis_clearance.h"
#include "simulator/cutting/hole/bore_set.h"
#include "simulator/cutting/hole/hole_volume.h"
#include "simulator/cutting/hole/skin_crossings.h"
#include "simulator/jobs/lying_bones.h"
#include "simulator/mesh/bvh.h"

namespace hallux::assessment {

namespace {

using simulator::Bvh;
using simulator::Capsule;
using simulator::CutEvent;
using simulator::CutSolid;
using simulator::engaged_least_mm;
using simulator::parallel_sine;

/// A crossing further from the bone's outer skin is one of a sawn face or of the canal.
constexpr double on_skin_mm = 1.0e-3;

/// When an implant was left, and how fragments lay then.
struct Leaving {
  std::int64_t tick = 0;
  simulator::FragmentPoses fragments;
};

/// Bores, implants and fragments at the end, and of each implant how it was left.
struct Left {
  Left(const simulator::Recording& recording, const RebuiltBone& rebuilt,
       const simulator::Bones& bones)
      : bores(rebuilt.fields.tray()), implants(rebuilt.fields.tray()) {
    simulator::FragmentPoses fragments = poses_of(bones);
    auto event = recording.events.begin();
    for (const simulator::ToolSample& sample : recording.samples) {
      for (; event != recording.events.end() && event->tick <= sample.tick; ++event)
        apply(*event, fragments);
      bores.apply(sample, fragments);
    }
  }

  simulator::BoreSet bores;
  simulator::ImplantSet implants;
  std::vector<Leaving> leavings;

 private:
  void apply(const CutEvent& event, simulator::FragmentPoses& fragments) {
    if (!fragments.apply(event)) return;
    bores.apply(event, fragments);
    if (!implants.apply(event, fragments)) return;
    if (event.kind == simulator::CutEventKind::ImplantLeft)
      leavings.push_back({event.tick, fragments});
  }
};

/// Where a fragment lay, in the frame of the first bone; before it was parted, with the one that it
/// was a part of.
RigidTransform pose_of(std::int32_t fragment, const simulator::FragmentPoses& then,
                       const simulator::FragmentPoses& last, const simulator::Bones& bones) {
  while (fragment >= then.count()) fragment = last[fragment].parent;
  const auto bone = static_cast<std::size_t>(then[fragment].bone);
  const RigidTransform& bone_from_fragment = then[fragment].bone_from_fragment;
  return bone == 0 ? bone_from_fragment : first_from(bones, bone) * bone_from_fragment;
}

/// An implant's axis as it lies.
struct Axis {
  Vec3 head_mm, tip_mm;
};

Axis axis_in_first(const simulator::Implant& implant, const RigidTransform& first_from_fragment) {
  const RigidTransform pose = first_from_fragment * implant.fragment_from_tool;
  return {pose.translation_mm - implant.size.length_mm * axis_x(pose), pose.translation_mm};
}

/// A body that is there, and how it lies in the frame of the first bone.
struct LyingBody {
  const Body& body;
  RigidTransform first_from_piece;
};

std::vector<LyingBody> lying(const std::vector<Body>& bodies, const RebuiltBone& rebuilt,
                             const simulator::FragmentPoses& then, const simulator::Bones& bones) {
  std::vector<LyingBody> lie;
  for (const Body& body : bodies) {
    if (body.fragment >= 0)
      lie.push_back({body, pose_of(body.fragment, then, rebuilt.fields.fragments(), bones)});
  }
  return lie;
}

/// One body as an axis meets it; ways are from the head.
struct MetBody {
  double engaged_mm = 0.0;
  /// To where the axis first goes in; nothing where it meets none of it.
  std::optional<double> entry_mm;
  /// To where it is in the body for the last time, be it the tip.
  std::optional<double> last_mm;
  /// There it comes out of the body altogether, not into its canal.
  bool comes_out = false;
  std::int32_t cortices = 0;
};

MetBody meet(const Axis& axis, const LyingBody& lies, const CutSolid& solid, const Bvh& skin) {
  const Body& body = lies.body;
  const RigidTransform piece_from_first = inverse(lies.first_from_piece);
  const Vec3 head_mm = transform_point(piece_from_first, axis.head_mm);
  const Vec3 tip_mm = transform_point(piece_from_first, axis.tip_mm);
  const double length_mm = length_of(tip_mm - head_mm);
  MetBody met;
  for (const auto& inside : inside_intervals(*body.tree, head_mm, tip_mm)) {
    const double from_mm = std::max(inside.from_mm, 0.0);
    const double to_mm = std::min(inside.to_mm, length_mm);
    if (!(to_mm > from_mm)) continue;
    met.engaged_mm += to_mm - from_mm;
    if (!met.entry_mm) met.entry_mm = from_mm;
    met.last_mm = to_mm;
  }
  for (const auto& crossing : skin_crossings(*body.tree, head_mm, tip_mm)) {
    const bool is_of_skin = skin.nearest(crossing.point_mm, on_skin_mm).has_value();
    if (is_of_skin) ++met.cortices;
    met.comes_out = !crossing.goes_in && (is_of_skin || solid.sources[crossing.triangle].kerf >= 0);
  }
  return met;
}

/// Joint surfaces go along with the bodies that they are on.
std::optional<double> joint_clearance_mm(const PlacedImplant& placed,
                                         const std::vector<LyingBody>& bodies,
                                         const simulator::Bones& bones,
                                         const scenarios::Plan& plan) {
  std::optional<double> least_mm;
  for (const scenarios::PlannedJointSurface& joint : plan.joint_surfaces) {
    const simulator::Bone& bone = bones[joint.bone];
    for (const auto& [body, first_from_piece] : bodies) {
      if (body.bone != joint.bone) continue;
      std::vector<std::uint32_t> on_body;
      for (const std::uint32_t triangle : joint.triangles) {
        const auto& corners = bone.outer.triangles[triangle];
        const Vec3 middle_mm =
            (bone.outer.points_mm[corners[0]] + bone.outer.points_mm[corners[1]] +
             bone.outer.points_mm[corners[2]]) /
            3.0;
        if (body.tree->nearest(middle_mm, on_skin_mm)) on_body.push_back(triangle);
      }
      const RigidTransform piece_from_first = inverse(first_from_piece);
      const auto away_mm =
          simulator::axis_clearance_mm({transform_point(piece_from_first, placed.entry_in_bone_mm),
                                        transform_point(piece_from_first, placed.tip_in_bone_mm)},
                                       bone.outer, on_body);
      if (away_mm && (!least_mm || *away_mm < *least_mm)) least_mm = away_mm;
    }
  }
  return least_mm;
}

void measure_holes(const simulator::BoreSet& bores, const std::vector<Body>& bodies,
                   Fixation& fixation) {
  for (const Body& body : bodies) {
    std::vector<Capsule> holes;
    for (const simulator::BorePlace& place : bores.places()) {
      if (place.fragment == body.fragment) holes.push_back(capsule_of(place.bore));
    }
    if (holes.empty()) continue;
    const simulator::BoundedVolume volume = simulator::drilled_volume(*body.tree, holes);
    fixation.holes_mm3 += volume.volume_mm3;
    fixation.holes_bound_mm3 += volume.bound_mm3;
  }
}

PlacedImplant place(const simulator::Implant& implant, const Axis& axis,
                    const std::vector<LyingBody>& bodies, const RebuiltBone& rebuilt,
                    const BoneSurfaces& skins) {
  PlacedImplant placed;
  placed.is_screw = implant.size.is_screw;
  placed.tip_in_bone_mm = axis.tip_mm;
  placed.diameter_mm = 2.0 * implant.size.radius_mm;
  placed.length_mm = implant.size.length_mm;
  placed.is_taken = implant.is_taken;
  std::optional<double> entry_mm, last_mm;
  for (const LyingBody& body : bodies) {
    const MetBody met = meet(axis, body, rebuilt.pieces[body.body.piece], skins[body.body.bone]);
    placed.cortices += met.cortices;
    if (met.entry_mm && (!entry_mm || *met.entry_mm < *entry_mm)) entry_mm = met.entry_mm;
    if (met.last_mm && (!last_mm || *met.last_mm > *last_mm)) {
      last_mm = met.last_mm;
      placed.protrusion_mm = met.comes_out ? placed.length_mm - *last_mm : 0.0;
    }
    if (met.engaged_mm >= engaged_least_mm) placed.engages.push_back(body.body.name);
  }
  const double share = entry_mm.value_or(0.0) / implant.size.length_mm;
  placed.entry_in_bone_mm = axis.head_mm + share * (axis.tip_mm - axis.head_mm);
  return placed;
}

Vec3 direction_of(const PlacedImplant& implant) {
  const Vec3 way = implant.tip_in_bone_mm - implant.entry_in_bone_mm;
  const double length_mm = length_of(way);
  return length_mm > 0.0 ? way / length_mm : Vec3{1.0, 0.0, 0.0};
}

bool engages(const PlacedImplant& implant, const std::string& body) {
  return std::find(implant.engages.begin(), implant.engages.end(), body) != implant.engages.end();
}

/// The bone that stood when something was left that was taken out again: later kerfs may run where
/// it lay.
class EarlierBone {
 public:
  EarlierBone(const simulator::Recording& recording, const RebuiltBone& last,
              const std::vector<Body>& last_bodies, const simulator::Bones& bones,
              const scenarios::Plan& plan)
      : recording_(recording), last_(last), last_bodies_(last_bodies), bones_(bones), plan_(plan) {}

  /// Makes `rebuilt` and `bodies` those of then: of the last tick where nothing was sawn since.
  void go_to(const Leaving& leaving) {
    if (!is_sawn_between(recording_, leaving.tick, last_tick())) {
      at_tick_ = last_tick();
    } else if (!is_same_bone(leaving)) {
      then_ = rebuild(bones_, last_.fields.tray(), begin_of(recording_, leaving.tick), {}, nullptr,
                      {}, hinges_of(plan_));
      then_bodies_ = bodies_of(*then_, plan_, bones_);
      at_tick_ = leaving.tick;
    }
  }
  const RebuiltBone& rebuilt() const noexcept { return at_tick_ == last_tick() ? last_ : *then_; }
  const std::vector<Body>& bodies() const noexcept {
    return at_tick_ == last_tick() ? last_bodies_ : then_bodies_;
  }

 private:
  std::int64_t last_tick() const noexcept { return recording_.samples.back().tick; }
  /// As when it was rebuilt for the leaving before.
  bool is_same_bone(const Leaving& leaving) const noexcept {
    return at_tick_ < last_tick() && !is_sawn_between(recording_, at_tick_, leaving.tick) &&
           then_->fields.fragments().count() == leaving.fragments.count();
  }

  const simulator::Recording& recording_;
  const RebuiltBone& last_;
  const std::vector<Body>& last_bodies_;
  const simulator::Bones& bones_;
  const scenarios::Plan& plan_;
  std::int64_t at_tick_ = last_tick();
  std::optional<RebuiltBone> then_;
  std::vector<Body> then_bodies_;
};

}  // namespace

Fixation fixation_of(const simulator::Recording& recording, const RebuiltBone& rebuilt,
                     const std::vector<Body>& bodies, const simulator::Bones& bones,
                     const scenarios::Plan& plan) {
  Fixation fixation;
  const Left left(recording, rebuilt, bones);
  if (left.bores.count() == 0) return fixation;
  const BoneSurfaces skins(bones);
  EarlierBone earlier(recording, rebuilt, bodies, bones, plan);
  for (std::int32_t number = 0; number < left.implants.count(); ++number) {
    const simulator::Implant& implant = left.implants[number];
    const Leaving& leaving = left.leavings[static_cast<std::size_t>(number)];
    if (implant.is_taken) earlier.go_to(leaving);
    const RebuiltBone& then = implant.is_taken ? earlier.rebuilt() : rebuilt;
    const simulator::FragmentPoses& last = then.fields.fragments();
    const simulator::FragmentPoses& fragments = implant.is_taken ? leaving.fragments : last;
    const std::vector<LyingBody> lie =
        lying(implant.is_taken ? earlier.bodies() : bodies, then, fragments, bones);
    const Axis axis = axis_in_first(implant, pose_of(implant.fragment, fragments, last, bones));
    PlacedImplant placed = place(implant, axis, lie, then, skins);
    placed.tip_to_joint_mm = joint_clearance_mm(placed, lie, bones, plan);
    placed.left_tick = leaving.tick;
    (implant.is_taken ? fixation.taken : fixation.implants).push_back(std::move(placed));
  }
  assign_planned(fixation, plan_in_first(plan, bones).fixation);
  measure_holes(left.bores, bodies, fixation);
  return fixation;
}

std::vector<bool> held_by(const Fixation& fixation, const std::vector<Body>& bodies) {
  std::vector<bool> held;
  for (const Body& body : bodies) {
    bool is_held = false;
    std::vector<Vec3> wires;
    for (const PlacedImplant& implant : fixation.implants) {
      if (implant.engages.size() < 2 || !engages(implant, body.name)) continue;
      const Vec3 direction = direction_of(implant);
      is_held = is_held || implant.is_screw ||
                std::any_of(wires.begin(), wires.end(), [&](const Vec3& other) {
                  return length_of(glm::cross(direction, other)) > parallel_sine;
                });
      wires.push_back(direction);
    }
    held.push_back(is_held);
  }
  return held;
}

}  // namespace hallux::assessment

// The strokes of a plan without errors, each at a few depths, with what they have opened by then:
// each such moment is measured on a picture of ids. Bones are as coarse as a picture needs and have
// no look: nobody sees them. What the blade opened is left in the bone, since a slot of half a
// millimetre uncovers nothing.
#include "ui/sight/view_judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "scenarios/hands/planned_strokes.h"
#include "scenarios/neighbour.h"
#include "simulator/base/units.h"
#include "simulator/cutting/field/kerf.h"
#include "ui/render/scene/tool_model.h"
#include "ui/sight/sight_samples.h"

namespace hallux::ui {

namespace {

/// Before the bone, at first touch, and at shares of the way through it.
constexpr std::array<double, 4> stroke_shares{0.02, 0.35, 0.7, 1.0};
constexpr double approach_mm = 6.0;
/// Of the picture: a rim at the sides, and what panels take above and below in the smallest window.
constexpr double side_share = 0.04, top_share = 0.13, bottom_share = 0.20;
constexpr double hub_mm = 9.0;

/// A bone that is all skin.
BoneLook plain_look() {
  BoneLook look;
  look.id = 1;
  look.depth.x_count = look.depth.y_count = look.depth.z_count = 2;
  look.depth.nodes.assign(8, 32768);
  return look;
}

/// What the strokes up to one of them have opened of their cut.
class OpenedByStrokes {
 public:
  explicit OpenedByStrokes(const simulator::Blade& blade) : blade_(blade) {}

  simulator::KerfOpening after(const scenarios::PlannedStroke& stroke, double feed_mm) {
    if (stroke.cut != cut_ || field_ == nullptr) {
      field_ = std::make_unique<simulator::KerfField>(
          simulator::FieldGrid{.spacing_mm = 0.2, .u_count = 401, .v_count = 401});
      cut_ = stroke.cut;
    }
    simulator::FieldWindow changed;
    const simulator::PlanarPose from{Vec2(stroke.first_mm - approach_mm, stroke.along_mm),
                                     Vec2(1.0, 0.0)};
    const simulator::PlanarPose to{Vec2(feed_mm, stroke.along_mm), Vec2(1.0, 0.0)};
    field_->stamp(blade_, from, to, changed);
    return opening_of(stroke.plane, *field_);
  }

 private:
  simulator::Blade blade_;
  std::size_t cut_ = 0;
  std::unique_ptr<simulator::KerfField> field_;
};

std::vector<WorkMoment> moments_of(const std::vector<scenarios::PlannedStroke>& strokes,
                                   const simulator::Blade& blade,
                                   const RigidTransform& world_from_bone) {
  std::vector<WorkMoment> moments;
  OpenedByStrokes opened(blade);
  for (const scenarios::PlannedStroke& stroke : strokes) {
    for (const double share : stroke_shares) {
      const double feed_mm = stroke.first_mm + share * (stroke.last_mm - stroke.first_mm);
      moments.push_back(
          {world_from_bone * stroke.bone_from_tool(feed_mm), opened.after(stroke, feed_mm)});
    }
  }
  return moments;
}

/// Corners of blade and hub.
std::array<Vec3, 8> saw_corners(const simulator::Blade& blade) {
  const double half_mm = 0.5 * blade.width_mm, back_mm = pivot_x_mm(blade) - 0.5 * hub_mm;
  const double hub_half_mm = 0.5 * hub_mm;
  return {Vec3(0.0, half_mm, 0.0),
          Vec3(0.0, -half_mm, 0.0),
          Vec3(-blade.depth_mm, half_mm, 0.0),
          Vec3(-blade.depth_mm, -half_mm, 0.0),
          Vec3(back_mm, hub_half_mm, hub_half_mm),
          Vec3(back_mm, -hub_half_mm, hub_half_mm),
          Vec3(back_mm, hub_half_mm, -hub_half_mm),
          Vec3(back_mm, -hub_half_mm, -hub_half_mm)};
}

bool is_inside(const EyeView& view, const RigidTransform& world_from_tool,
               const simulator::Blade& blade) {
  return std::ranges::all_of(saw_corners(blade), [&](const Vec3& corner_mm) {
    const Vec3 place = place_in_picture(view, transform_point(world_from_tool, corner_mm));
    return place.x > side_share && place.x < 1.0 - side_share && place.y > top_share &&
           place.y < 1.0 - bottom_share && std::abs(place.z) < 1.0;
  });
}

/// From level, downwards on the picture.
double handle_down_rad(const EyeView& view, const RigidTransform& world_from_tool,
                       const simulator::Blade& blade) {
  const Vec3 teeth = place_in_picture(view, world_from_tool.translation_mm);
  const Vec3 hub =
      place_in_picture(view, transform_point(world_from_tool, Vec3(pivot_x_mm(blade), 0.0, 0.0)));
  return std::atan2(hub.y - teeth.y, std::abs(hub.x - teeth.x) * view.width_over_height);
}

double plane_angle_rad(const EyeView& view, const RigidTransform& world_from_tool) {
  const Vec3 sight = glm::normalize(world_from_tool.translation_mm - view.eye_in_world_mm);
  return std::asin(std::abs(glm::dot(sight, world_from_tool.rotation * Vec3(0.0, 0.0, 1.0))));
}

BoneInScene bone_in_scene(const BoneMesh& mesh, const BoneLook& look,
                          const RigidTransform& world_from_bone) {
  BoneInScene bone;
  bone.mesh = &mesh;
  bone.look = &look;
  bone.world_from_bone = world_from_bone;
  return bone;
}

void add(Hiders& sum, const Hiders& more) {
  sum.bone += more.bone;
  sum.blade += more.blade;
  sum.handpiece += more.handpiece;
  sum.outside_picture += more.outside_picture;
}

}  // namespace

bool holds_start(const ViewJudgement& judgement, const ViewLimits& limits) noexcept {
  return judgement.blade_angle_rad >= limits.blade_angle_low_rad &&
         judgement.blade_angle_rad <= limits.blade_angle_high_rad && judgement.is_saw_inside &&
         judgement.is_from_lower_corner;
}

bool shows_cut(const ViewJudgement& judgement, const ViewLimits& limits) noexcept {
  return judgement.mean.tooth_line_share >= limits.least_share &&
         judgement.mean.kerf_share >= limits.least_share;
}

bool is_good(const ViewJudgement& judgement, const ViewLimits& limits) noexcept {
  return holds_start(judgement, limits) && shows_cut(judgement, limits);
}

struct ViewJudge::Parts {
  simulator::Blade blade;
  RigidTransform world_from_bone;
  BoneLook look = plain_look();
  BoneMesh bone;
  /// What lies around it: further bones of the patient, and the one beside.
  struct Around {
    BoneMesh mesh;
    RigidTransform world_from_bone;
  };
  std::deque<Around> around;
  std::unique_ptr<const simulator::Bvh> tree;
  std::vector<WorkMoment> moments;
  SightMeter meter;

  Parts(const scenarios::Scenario& scenario, const simulator::Bones& patient,
        const scenarios::Plan& plan, PixelSize size);
  void lay_around(const simulator::Bone& bone);
  EyeView view_from(const Camera& camera) const;
  SightSamples samples_of(const WorkMoment& moment) const;
};

/// What is seen of the cuts is measured on the bone of the first.
ViewJudge::Parts::Parts(const scenarios::Scenario& scenario, const simulator::Bones& patient,
                        const scenarios::Plan& plan, PixelSize size)
    : blade(scenario.saw.blade), meter(size) {
  std::vector<scenarios::PlannedStroke> strokes = planned_strokes(scenario, patient, plan);
  const std::size_t sawn = strokes.empty() ? 0 : plan.cuts[strokes.front().cut].bone;
  std::erase_if(strokes, [&](const scenarios::PlannedStroke& stroke) {
    return plan.cuts[stroke.cut].bone != sawn;
  });
  world_from_bone = patient[sawn].world_from_bone;
  bone = mesh_of(1, simulator::uncut_solid(solid_of(patient[sawn])), look);
  tree = std::make_unique<const simulator::Bvh>(bone.solid.mesh);
  for (std::size_t i = 0; i < patient.size(); ++i) {
    if (i != sawn) lay_around(patient[i]);
  }
  if (const auto beside = scenarios::neighbour_of(scenario)) lay_around(*beside);
  moments = moments_of(strokes, blade, world_from_bone);
}

void ViewJudge::Parts::lay_around(const simulator::Bone& lying) {
  const auto id = static_cast<std::uint64_t>(2 + around.size());
  around.push_back(
      {mesh_of(id, simulator::uncut_solid(solid_of(lying)), look), lying.world_from_bone});
}

EyeView ViewJudge::Parts::view_from(const Camera& camera) const {
  const PixelSize size = meter.size();
  return view_of(camera, Viewer{}, Eye::Middle,
                 static_cast<double>(size.width) / static_cast<double>(size.height));
}

SightSamples ViewJudge::Parts::samples_of(const WorkMoment& moment) const {
  const WholeBone whole{bone.solid, *tree, world_from_bone};
  return {tooth_places(whole, moment.world_from_tool, blade), mouth_places(whole, moment.kerf)};
}

ViewJudge::ViewJudge(const scenarios::Scenario& scenario, simulator::Bones bones,
                     const scenarios::Plan& plan, PixelSize size)
    : parts_(std::make_unique<Parts>(scenario, bones, plan, size)) {}
ViewJudge::~ViewJudge() = default;

ViewJudgement ViewJudge::judge_start(const Camera& camera,
                                     const RigidTransform& world_from_start) const {
  const EyeView view = parts_->view_from(camera);
  ViewJudgement judgement;
  judgement.blade_angle_rad = plane_angle_rad(view, world_from_start);
  judgement.is_saw_inside = is_inside(view, world_from_start, parts_->blade);
  const double down_rad = handle_down_rad(view, world_from_start, parts_->blade);
  judgement.is_from_lower_corner =
      down_rad > radian_from_degree(20.0) && down_rad < radian_from_degree(70.0);
  return judgement;
}

ViewJudgement ViewJudge::judge(const Camera& camera, const RigidTransform& world_from_start) {
  ViewJudgement judgement = judge_start(camera, world_from_start);
  const SeenOver seen = seen_over(camera, moments());
  judgement.mean = seen.mean;
  judgement.hiders = seen.hiders;
  return judgement;
}

SeenOver ViewJudge::seen_over(const Camera& camera, const std::vector<WorkMoment>& over) {
  SeenOver all;
  if (over.empty()) return all;
  const EyeView view = parts_->view_from(camera);
  Visibility sum{0.0, 0.0};
  Scene scene;
  scene.bones = {bone_in_scene(parts_->bone, parts_->look, parts_->world_from_bone)};
  for (const Parts::Around& around : parts_->around)
    scene.bones.push_back(bone_in_scene(around.mesh, parts_->look, around.world_from_bone));
  for (const WorkMoment& moment : over) {
    SawInScene saw;
    saw.world_from_tool = moment.world_from_tool;
    saw.blade = parts_->blade;
    scene.saw = saw;
    const Visibility seen = parts_->meter.measure(scene, view, parts_->samples_of(moment));
    sum.tooth_line_share += seen.tooth_line_share;
    sum.kerf_share += seen.kerf_share;
    add(all.hiders, parts_->meter.hiders());
  }
  const auto count = static_cast<double>(over.size());
  all.mean = {sum.tooth_line_share / count, sum.kerf_share / count};
  return all;
}

const std::vector<WorkMoment>& ViewJudge::moments() const noexcept { return parts_->moments; }

}  // namespace hallux::ui

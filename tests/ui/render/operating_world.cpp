#include "tests/ui/render/operating_world.h"

#include <algorithm>

#include "scenarios/foot/first_metatarsal.h"
#include "scenarios/foot/first_proximal_phalanx.h"
#include "scenarios/scenario.h"
#include "simulator/base/check.h"
#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/cutting/slice/section.h"
#include "simulator/cutting/solid/commit_patch.h"
#include "simulator/mesh/bvh.h"

namespace hallux::tests {

namespace {

using namespace simulator;

constexpr Blade blade{.width_mm = 12.0, .depth_mm = 25.0, .kerf_mm = 0.5};
constexpr const char* first_cut = "proximal_face";
constexpr const char* second_cut = "distal_face";

FieldGrid grid_of_kerf() {
  return {.origin_mm = Vec2(-30.0, -20.0), .spacing_mm = 0.05, .u_count = 1001, .v_count = 801};
}

/// One kerf being sawn.
struct Sawing {
  KerfPlane plane;
  KerfField field{grid_of_kerf()};
  OutlineTracker tracker{grid_of_kerf()};
  SlabSlice contact;
  PatchBuilder builder;

  Sawing(const CutSolid& solid, const Bvh& bvh, const KerfPlane& at, int kerf)
      : plane(at), contact(slice_slab(solid, bvh, at, kerf, grid_of_kerf())), builder(contact) {}
  bool saw(const Vec2& from_mm, const Vec2& to_mm, SolidPatch& patch) {
    FieldWindow changed;
    field.stamp(blade, {from_mm, Vec2(1.0, 0.0)}, {to_mm, Vec2(1.0, 0.0)}, changed);
    tracker.update(field);
    return builder.build(tracker.outline(), patch);
  }
};

}  // namespace

struct OperatingWorld::Parts {
  scenarios::Scenario scenario = scenarios::load_shipped_scenario("akin");
  Bone phalanx, metatarsal;
  scenarios::Plan plan;
  ui::BoneLook phalanx_look, metatarsal_look;
  ui::BoneMesh phalanx_mesh, metatarsal_mesh;
  std::unique_ptr<Bvh> bvh;
  std::unique_ptr<Sawing> sawing;
  SolidPatch patch;
  std::uint64_t patch_revision = 0;
  double reach_mm = -16.0;
  bool is_open = false;

  RigidTransform bone_from_face(std::string_view name) const;
  void commit_cut(const char* name, int kerf);
};

OperatingWorld::OperatingWorld(double edge_mm) : parts_(std::make_unique<Parts>()) {
  Parts& parts = *parts_;
  parts.phalanx = scenarios::make_first_proximal_phalanx(scenarios::first_proximal_phalanx_table(),
                                                         {.length_mm = 33.0, .edge_mm = edge_mm});
  parts.metatarsal = scenarios::make_first_metatarsal(scenarios::first_metatarsal_table(),
                                                      {.edge_mm = std::min(1.5, 2.0 * edge_mm)});
  parts.plan = scenarios::plan_on(parts.scenario, parts.phalanx);
  parts.phalanx_look = ui::look_of(1, parts.phalanx);
  parts.metatarsal_look = ui::look_of(2, parts.metatarsal);
  parts.phalanx_mesh = ui::mesh_of(1, uncut_solid(solid_of(parts.phalanx)), parts.phalanx_look);
  parts.metatarsal_mesh =
      ui::mesh_of(2, uncut_solid(solid_of(parts.metatarsal)), parts.metatarsal_look);
  parts.bvh = std::make_unique<Bvh>(parts.phalanx_mesh.solid.mesh);
}

OperatingWorld::~OperatingWorld() = default;

RigidTransform OperatingWorld::Parts::bone_from_face(std::string_view name) const {
  const scenarios::PlannedCut& cut = *scenarios::find_cut(plan, name);
  const Vec3 normal = cut.face.normal, lateral(0.0, 0.0, 1.0);
  const Vec3 feed = glm::normalize(lateral - glm::dot(lateral, normal) * normal);
  const Vec3 middle_mm = 0.5 * (cut.entry_point_in_bone_mm + cut.exit_point_in_bone_mm);
  const double off = cut.face.offset_mm - glm::dot(normal, middle_mm);
  return {rotation_from_axes(feed, glm::cross(normal, feed)), middle_mm + off * normal};
}

void OperatingWorld::saw_to(double reach_mm) {
  Parts& parts = *parts_;
  if (!parts.sawing) {
    parts.sawing = std::make_unique<Sawing>(parts.phalanx_mesh.solid, *parts.bvh,
                                            KerfPlane{parts.bone_from_face(first_cut), 0.5}, 0);
  }
  CHECK(parts.sawing->saw(Vec2(parts.reach_mm, 1.5), Vec2(reach_mm, 1.5), parts.patch));
  parts.reach_mm = reach_mm;
  ++parts.patch_revision;
}

void OperatingWorld::Parts::commit_cut(const char* name, int kerf) {
  const Vec3 side = scenarios::find_cut(plan, name)->face.normal;
  RigidTransform plane = bone_from_face(name);
  plane.translation_mm += 0.25 * side;  // the kerf lies in the waste
  const scenarios::PlannedHinge& hinge = plan.hinges.front();
  const double reach = transform_point(inverse(plane), hinge.bridge.line.point_in_bone_mm).x;
  const CutSolid& solid = phalanx_mesh.solid;
  Sawing cut(solid, *bvh, {plane, 0.5}, kerf);
  for (const double height_mm : {-7.0, 0.0, 7.0}) {
    CHECK(cut.saw(Vec2(-20.0, height_mm), Vec2(reach, height_mm), patch));
  }
  phalanx_mesh =
      ui::mesh_of(10 + static_cast<std::uint64_t>(kerf), commit_patch(solid, patch), phalanx_look);
  bvh = std::make_unique<Bvh>(phalanx_mesh.solid.mesh);
}

void OperatingWorld::take_wedge_out() {
  Parts& parts = *parts_;
  parts.sawing.reset();
  parts.commit_cut(first_cut, 0);
  parts.commit_cut(second_cut, 1);
  const std::vector<CutSolid> pieces = split_pieces(parts.phalanx_mesh.solid);
  parts.phalanx_mesh = ui::mesh_of(20, pieces.front(), parts.phalanx_look);
  parts.bvh = std::make_unique<Bvh>(parts.phalanx_mesh.solid.mesh);
  const ui::Occluder self{parts.bvh.get(), {}};
  ui::light_cut_faces(parts.phalanx_mesh, std::span(&self, 1));
  parts.is_open = true;
  parts.patch = {};
}

RigidTransform OperatingWorld::world_from_face(std::string_view name) const {
  return parts_->phalanx.world_from_bone * parts_->bone_from_face(name);
}

RigidTransform OperatingWorld::world_from_tool() const {
  const RigidTransform face = world_from_face(first_cut);
  return face * RigidTransform{Quat(1.0, 0.0, 0.0, 0.0), Vec3(parts_->reach_mm, 1.5, 0.0)};
}

ui::Scene OperatingWorld::scene() const {
  const Parts& parts = *parts_;
  ui::Scene scene;
  ui::BoneInScene phalanx;
  phalanx.mesh = &parts.phalanx_mesh;
  phalanx.look = &parts.phalanx_look;
  phalanx.world_from_bone = parts.phalanx.world_from_bone;
  if (parts.sawing) {
    phalanx.patch = &parts.patch;
    phalanx.patch_revision = parts.patch_revision;
  }
  ui::BoneInScene metatarsal;
  metatarsal.mesh = &parts.metatarsal_mesh;
  metatarsal.look = &parts.metatarsal_look;
  metatarsal.world_from_bone = parts.metatarsal.world_from_bone;
  metatarsal.presence = 0.55;
  scene.bones = {phalanx, metatarsal};
  if (parts.is_open) return scene;
  ui::SawInScene saw;
  saw.world_from_tool = world_from_tool();
  saw.blade = blade;
  scene.saw = saw;
  scene.planes = {{world_from_face(first_cut), Vec2(16.0, 13.0)}};
  scene.lines = {{world_from_face(first_cut)}, {world_from_face(second_cut)}};
  return scene;
}

ui::HeldBone OperatingWorld::held() const {
  const Parts& parts = *parts_;
  CHECK(parts.sawing != nullptr);
  const Sawing& sawing = *parts.sawing;
  ui::HeldBone held;
  held.world_from_kerf = parts.phalanx.world_from_bone * sawing.plane.bone_from_kerf;
  const Section section = slice_section(parts.phalanx_mesh.solid, *parts.bvh, sawing.plane);
  for (const SectionRegion& region : section.regions) {
    for (const Contour& contour : region.contours) held.bone_mm.push_back(contour);
  }
  const RegionOutline& opened = sawing.tracker.outline();
  std::size_t first = 0;
  for (const std::uint32_t end : opened.loop_ends) {
    held.opened_mm.emplace_back(opened.corners_mm.begin() + static_cast<std::ptrdiff_t>(first),
                                opened.corners_mm.begin() + static_cast<std::ptrdiff_t>(end));
    first = end;
  }
  return held;
}

std::vector<ui::ZoneInScene> OperatingWorld::zones() const {
  std::vector<ui::ZoneInScene> zones;
  for (const scenarios::PlannedZone& zone : parts_->plan.danger_zones) {
    const auto in_world = [&](const Vec3& point_mm) {
      return transform_point(parts_->phalanx.world_from_bone, point_mm);
    };
    zones.push_back({.from_mm = in_world(zone.capsule.from_in_bone_mm),
                     .to_mm = in_world(zone.capsule.to_in_bone_mm),
                     .radius_mm = zone.capsule.radius_mm});
  }
  return zones;
}

ui::Camera OperatingWorld::camera() const {
  ui::Camera camera;
  camera.target_mm = transform_point(parts_->phalanx.world_from_bone, Vec3(10.0, 0.0, -4.0));
  camera.magnification = 7.6;
  return ui::standard_view(camera, ui::StandardView::Operator);
}

const Bone& OperatingWorld::phalanx() const noexcept { return parts_->phalanx; }
const scenarios::PlannedCut& OperatingWorld::cut() const {
  return *scenarios::find_cut(parts_->plan, first_cut);
}
const SolidPatch& OperatingWorld::patch() const noexcept { return parts_->patch; }
const ui::BoneMesh& OperatingWorld::mesh() const noexcept { return parts_->phalanx_mesh; }

}  // namespace hallux::tests

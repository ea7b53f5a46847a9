// The picture of an operation.
//
// It shows what the loop said last, never what is on its way: the saw stands where the step has put
// it, not where the hand leads it. Before the loop's first step it stands where it will begin.
#include "ui/screens/operating/operating_viewport.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulator/record/sample_force.h"
#include "ui/render/scene/tool_model.h"
#include "ui/screens/operating/tools_in_sight.h"
#include "ui/screens/pictures/contact_halo.h"
#include "ui/screens/pictures/planned_frame.h"
#include "ui/screens/pictures/sight_along_blade.h"
#include "ui/screens/pictures/zones_in_scene.h"

namespace hallux::ui {

namespace {

using simulator::ToolStatus;

/// The blade's line on the bone: a little wider than the teeth, and faintly on.
constexpr double beside_teeth_mm = 1.0, faint_line_mm = 8.0;

/// Of a 3D mouse: shares of the window's width, and how much nearer.
constexpr double share_per_mm = 0.004, zoom_per_mm = 0.008;

/// A handpiece that is less there lets a panel be read over it.
constexpr double hiding_presence = 0.5;

/// As it is kept.
constexpr simulator::ShownStereo shown_stereo(StereoMode mode) noexcept {
  switch (mode) {
    case StereoMode::SideBySide:
      return simulator::ShownStereo::SideBySide;
    case StereoMode::Anaglyph:
      return simulator::ShownStereo::Anaglyph;
    case StereoMode::Mono:
      break;
  }
  return simulator::ShownStereo::Mono;
}

constexpr std::array<const char*, standard_view_count> view_names{
    "operate.key.view.1", "operate.key.view.2", "operate.key.view.3", "operate.key.view.4",
    "operate.key.view.5", "operate.key.view.6", "operate.key.view.7", "operate.key.view.8"};

/// A ball around a part of the saw, on its axis.
struct BulkOfSaw {
  double x_mm = 0.0, radius_mm = 0.0;
  bool is_handpiece = false;
};

/// Blade, hub and grip; beyond, it is a cable.
std::vector<BulkOfSaw> bulks_of_saw(const simulator::Blade& blade) {
  constexpr double grip_length_mm = 118.0, grip_radius_mm = 9.0;
  std::vector<BulkOfSaw> bulks;
  for (double x_mm = 0.0; x_mm > -blade.depth_mm; x_mm -= 0.5 * blade.width_mm)
    bulks.push_back({x_mm, 0.5 * blade.width_mm});
  for (double along_mm = 0.0; along_mm < grip_length_mm; along_mm += grip_radius_mm)
    bulks.push_back({pivot_x_mm(blade) - along_mm, grip_radius_mm, true});
  return bulks;
}

/// The teeth at work; nothing where they cut nothing.
std::optional<SwarfSource> swarf_of(const OperationInSight& shown) {
  const simulator::LoopView& loop = *shown.loop;
  if (!has(loop.sample.status, ToolStatus::Cutting)) return std::nullopt;
  const scenarios::Scenario& scenario = shown.prepared_case.scenario;
  const simulator::Saw* const chosen = shown.tools == nullptr ? nullptr : shown.tools->saw();
  const simulator::Saw& saw = chosen == nullptr ? scenario.saw : *chosen;
  SwarfSource source;
  source.world_from_tool = transform_from(loop.sample.world_from_tool);
  source.width_mm = saw.blade.width_mm;
  const double rate_mm_s = simulator::feed_rate_mm_s(
      loop.engaged, simulator::force_size_newton(loop.sample), saw, scenario.patient.bone_quality);
  source.removed_mm3_s = rate_mm_s * loop.engaged.width_mm() * saw.blade.kerf_mm;
  source.is_irrigated = shown.is_irrigated;
  return source;
}

bool has_neighbour(const OperationInSight& shown) {
  return shown.is_neighbour_shown && shown.site != nullptr && shown.site->neighbour_tree != nullptr;
}

void add_bones(Scene& scene, const OperationInSight& shown) {
  if (shown.bone != nullptr) {
    shown.bone->add_to(scene);
  } else {
    for (std::size_t bone = 0; bone < shown.wholes.size(); ++bone) {
      BoneInScene& whole = scene.bones.emplace_back();
      whole.mesh = shown.wholes[bone].mesh.get();
      whole.look = &shown.wholes[bone].look;
      whole.world_from_bone = shown.prepared_case.bones[bone].world_from_bone;
    }
  }
  if (!has_neighbour(shown)) return;
  BoneInScene& neighbour = scene.bones.emplace_back();
  neighbour.mesh = &shown.site->neighbour->mesh;
  neighbour.look = &shown.site->neighbour->look;
  neighbour.world_from_bone = shown.site->neighbour->world_from_bone;
  neighbour.presence = neighbour_presence;
}

/// needs   the bones are in the scene
std::vector<BoneSurface> surfaces_of(const OperationInSight& shown) {
  if (shown.bone != nullptr) return shown.bone->surfaces();
  std::vector<BoneSurface> surfaces;
  for (std::size_t bone = 0; bone < shown.wholes.size(); ++bone)
    surfaces.push_back({*shown.wholes[bone].tree, shown.prepared_case.bones[bone].world_from_bone});
  return surfaces;
}

std::array<double, blade_sight_count> hidden_from(const OperationInSight& shown,
                                                  const SawInScene& saw) {
  std::vector<BoneSurface> bones = surfaces_of(shown);
  if (has_neighbour(shown))
    bones.push_back({*shown.site->neighbour_tree, shown.site->neighbour->world_from_bone});
  return hidden_along_blade(bones, saw.world_from_tool, saw.blade);
}

PlaneGhost plane_of(const OperationInSight& shown) {
  const RigidTransform& world_from_bone = shown.prepared_case.bone().world_from_bone;
  const scenarios::Plan& plan = shown.prepared_case.plan_in_first;
  if (shown.site == nullptr) return {world_from_bone * bone_from_planned(*shown.cut)};
  const PlannedFace& face = shown.site->faces[index_of_cut(plan, shown.cut->name)];
  return {world_from_bone * face.bone_from_face, face.half_mm};
}

/// Without guidance only that the teeth touch: a way to the bone, and teeth that bone hides, nobody
/// sees who stands before a patient.
std::optional<ContactHalo> halo_of(const OperationInSight& shown, const SawInScene& saw,
                                   const Vec3& eye_in_world_mm) {
  std::optional<ContactHalo> halo = contact_halo(surfaces_of(shown), saw, eye_in_world_mm);
  if (shown.is_guided || !halo) return halo;
  if (halo->kind != HaloKind::On) return std::nullopt;
  halo->distance_mm = 0.0;
  return halo;
}

/// What helps in practice alone.
void add_guidance(Scene& scene, const OperationInSight& shown, const SawInScene& saw) {
  if (scene.saw) {
    scene.lines.push_back({.world_from_plane = saw.world_from_tool,
                           .half_mm = Vec2(0.0, 0.5 * saw.blade.width_mm + beside_teeth_mm),
                           .faint_mm = faint_line_mm});
  }
  scene.zones =
      zones_in_scene(shown.prepared_case.plan_in_first, shown.prepared_case.bone().world_from_bone,
                     saw.world_from_tool, saw.blade);
  add_planned_fixation(scene, shown);
  if (shown.bone != nullptr) shown.bone->add_free_pieces(scene);
}

void add_held(Scene& scene, const OperationInSight& shown) {
  const RigidTransform& world_from_bone = shown.prepared_case.bone().world_from_bone;
  scene.held = shown.facts->held;
  for (const scenarios::HeldCut& cut : shown.facts->cuts) {
    if (!cut.is_begun() || cut.is_through()) continue;
    scene.marks.push_back({transform_point(world_from_bone, cut.deepest_in_bone_mm), 7.0, Ink::Warn,
                           MarkShape::Diamond});
  }
}

}  // namespace

Steered OperatingViewport::hear(Ui& ui, const AreaResponse& area, const PreparedCase& prepared_case,
                                bool may_lead, const Vec3& tip_in_world_mm) {
  const Steered steered = steering_.hear(ui, area, sight_, may_lead, tip_in_world_mm);
  sight_.camera = steered.camera;
  hear_views(ui, prepared_case);
  hear_eyes(ui);
  return steered;
}

void OperatingViewport::release_pointer() noexcept {
  steering_.release_pointer();
  steering_.set_down();
}

void OperatingViewport::turn(const simulator::PointerMotion& motion) noexcept {
  Camera camera = orbited(sight_.camera, motion.turned_rad.x, -motion.turned_rad.y);
  camera = panned(camera, sight_.viewer, share_per_mm * motion.across_mm);
  sight_.camera = zoomed(camera, std::exp(-zoom_per_mm * motion.deeper_mm));
}

void OperatingViewport::hear_eyes(Ui& ui) {
  if (ui.shortcut({Key::F9}, ui.text("operate.key.stereo"))) {
    stereo_.mode = static_cast<StereoMode>((static_cast<int>(stereo_.mode) + 1) % 3);
  }
  if (ui.shortcut(with_shift(Key::F9), ui.text("operate.key.swap"))) {
    stereo_.is_swapped = !stereo_.is_swapped;
  }
}

void OperatingViewport::hear_views(Ui& ui, const PreparedCase& prepared_case) {
  for (int view = 0; view < standard_view_count; ++view) {
    const Key key = static_cast<Key>(static_cast<int>(Key::Digit1) + view);
    if (!ui.shortcut({key}, ui.text(view_names[static_cast<std::size_t>(view)]))) continue;
    const auto asked = static_cast<StandardView>(view);
    sight_.camera = asked == StandardView::AlongBlade ? sight_along_blade()
                                                      : standard_view(sight_.camera, asked);
  }
  if (ui.shortcut({Key::R}, ui.text("operate.key.reset"))) face(prepared_case);
}

/// From where the saw was drawn last.
Camera OperatingViewport::sight_along_blade() const {
  return seen_along_blade(sight_.camera, drawn_saw_.world_from_tool, hidden_along_blade_);
}

/// What is mostly seen through is not there. The grip hides behind a panel without loss, but to two
/// eyes it stands before it.
std::vector<ToolPlace> OperatingViewport::tool_places() const {
  std::vector<ToolPlace> places;
  const Vec3 right = sight_.camera.world_from_view * Vec3(1.0, 0.0, 0.0);
  const bool has_handpiece = drawn_saw_.handpiece_presence >= hiding_presence;
  for (const BulkOfSaw& bulk : bulks_of_saw(drawn_saw_.blade)) {
    if (bulk.is_handpiece && !has_handpiece) continue;
    const Vec3 middle_mm = transform_point(drawn_saw_.world_from_tool, Vec3(bulk.x_mm, 0.0, 0.0));
    const std::optional<Point> at = place_of(middle_mm),
                               edge = place_of(middle_mm + bulk.radius_mm * right);
    if (!at || !edge) continue;
    places.push_back({*at, std::hypot(edge->x - at->x, edge->y - at->y),
                      !bulk.is_handpiece || stereo_.mode != StereoMode::Mono});
  }
  return places;
}

void OperatingViewport::draw(Ui& ui, ScenePainter& painter, const OperationInSight& shown) {
  const double now_s = ui.time_s();
  const double step_s = now_s - std::exchange(last_s_, now_s);
  frame_ms_ = std::max(1000.0 * step_s, 0.9 * frame_ms_);
  if (shown.bone != nullptr && !shown.is_paused) let_chips_fly(step_s, shown);
  drawn_saw_ = saw_in_sight(shown);
  // Faster than pictures follow each other: each shows the blade somewhere else in its swing.
  const double swings = 2.4 * static_cast<double>(pictures_);
  if (drawn_saw_.is_running) drawn_saw_.swing = std::sin(swings);
  drawn_saw_.handpiece_presence =
      handpiece_presence_from(drawn_saw_.world_from_tool, sight_.eye().eye_in_world_mm);
  const Scene scene = this->scene(ui, shown, swings);
  hidden_along_blade_ = hidden_from(shown, drawn_saw_);
  painter.draw_behind(scene, sight_.camera, stereo_);
  if (stereo_.mode == StereoMode::SideBySide) ui.carry_pointer();
  ++pictures_;
}

simulator::ShownView OperatingViewport::shown_view() const noexcept {
  simulator::ShownView view =
      ui::shown_view(sight_.camera, static_cast<double>(sight_.display.w / sight_.display.h));
  view.stereo = shown_stereo(stereo_.mode);
  return view;
}

void OperatingViewport::let_chips_fly(double step_s, const OperationInSight& shown) {
  swarf_.advance(step_s, shown.loop == nullptr ? std::nullopt : swarf_of(shown));
}

Scene OperatingViewport::scene(const Ui& ui, const OperationInSight& shown, double swings) const {
  Scene scene;
  scene.ground = ui.theme().is_dark() ? Ground::Dark : Ground::Light;
  add_bones(scene, shown);
  add_tool(scene, shown, drawn_saw_, swings);
  scene.chips = swarf_.chips();
  if (!scene.forceps) scene.halo = halo_of(shown, drawn_saw_, sight_.eye().eye_in_world_mm);
  if (shown.cut != nullptr) scene.planes.push_back(plane_of(shown));
  if (shown.is_guided) add_guidance(scene, shown, drawn_saw_);
  if (shown.facts != nullptr) add_held(scene, shown);
  scene.marks.insert(scene.marks.end(), shown.goals.begin(), shown.goals.end());
  return scene;
}

}  // namespace hallux::ui

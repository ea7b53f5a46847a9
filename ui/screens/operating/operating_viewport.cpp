// The picture of an operation.
//
// It shows what the loop said last, never what is on its way: the saw stands where the step has put
// it, not where the hand leads it. Before the loop's first step it stands where it will begin.
#include "ui/screens/operating/operating_viewport.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulator/record/sample_force.h"
#include "ui/screens/operating/plan_reading.h"

namespace hallux::ui {

namespace {

using simulator::ToolStatus;

constexpr Vec2 plane_half_mm{16.0, 13.0};

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

/// The teeth at work; nothing where they cut nothing.
std::optional<SwarfSource> swarf_of(const OperationInSight& shown) {
  const simulator::LoopView& loop = *shown.loop;
  if (!has(loop.sample.status, ToolStatus::Cutting)) return std::nullopt;
  const scenarios::Scenario& scenario = shown.prepared_case.scenario;
  SwarfSource source;
  source.world_from_tool = transform_from(loop.sample.world_from_tool);
  source.width_mm = scenario.saw.blade.width_mm;
  const double rate_mm_s =
      simulator::feed_rate_mm_s(loop.engaged, simulator::force_size_newton(loop.sample),
                                scenario.saw, scenario.patient.bone_quality);
  source.removed_mm3_s = rate_mm_s * loop.engaged.width_mm() * scenario.saw.blade.kerf_mm;
  source.is_irrigated = shown.is_irrigated;
  return source;
}

SawInScene saw_of(const OperationInSight& shown) {
  SawInScene saw;
  saw.world_from_tool = shown.loop == nullptr ? shown.world_from_target
                                              : transform_from(shown.loop->sample.world_from_tool);
  saw.blade = shown.prepared_case.scenario.saw.blade;
  saw.is_running = shown.loop != nullptr && !shown.is_paused &&
                   has(shown.loop->sample.status, ToolStatus::SawOn);
  return saw;
}

}  // namespace

void OperatingViewport::look(Ui& ui, const AreaResponse& area, const PreparedCase& prepared_case) {
  sight_.camera = steering_.looked(area, ui.modifiers(), sight_);
  hear_views(ui, prepared_case);
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
    if (ui.shortcut({key}, ui.text(view_names[static_cast<std::size_t>(view)]))) {
      sight_.camera = standard_view(sight_.camera, static_cast<StandardView>(view));
    }
  }
  if (ui.shortcut({Key::R}, ui.text("operate.key.reset"))) face(prepared_case);
}

std::array<simulator::PointerMotion, 2> OperatingViewport::motions(Ui& ui, const AreaResponse& area,
                                                                   const Vec3& tip_in_world_mm) {
  return {steering_.motion(area, ui.modifiers(), sight_, tip_in_world_mm),
          steering_.motion_by_keys(ui)};
}

void OperatingViewport::draw(Ui& ui, ScenePainter& painter, const OperationInSight& shown) {
  const double now_s = ui.time_s();
  const double step_s = now_s - std::exchange(last_s_, now_s);
  frame_ms_ = std::max(1000.0 * step_s, 0.9 * frame_ms_);
  if (shown.bone != nullptr && !shown.is_paused) let_chips_fly(step_s, shown);
  painter.draw_behind(scene(ui, shown), sight_.camera, stereo_);
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

Scene OperatingViewport::scene(const Ui& ui, const OperationInSight& shown) const {
  const RigidTransform& world_from_bone = shown.prepared_case.bone.world_from_bone;
  Scene scene;
  scene.ground = ui.theme().is_dark() ? Ground::Dark : Ground::Light;
  if (shown.bone != nullptr) {
    shown.bone->add_to(scene);
  } else {
    BoneInScene whole;
    whole.mesh = shown.whole.mesh.get();
    whole.look = &shown.whole.look;
    whole.world_from_bone = world_from_bone;
    scene.bones.push_back(whole);
  }
  SawInScene saw = saw_of(shown);
  // Faster than pictures follow each other: each shows the blade somewhere else in its swing.
  saw.swing = std::sin(2.4 * static_cast<double>(pictures_));
  scene.saw = saw;
  scene.lines.push_back({saw.world_from_tool, 0.5 * saw.blade.width_mm + 1.0});
  scene.chips = swarf_.chips();
  if (shown.cut != nullptr) {
    scene.planes.push_back(
        {world_from_bone * bone_from_face(*shown.cut), plane_half_mm, Ink::Reference});
  }
  return scene;
}

}  // namespace hallux::ui

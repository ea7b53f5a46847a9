// A kerf that meets an earlier one: its contact follows the walls that are there, and a wedge comes
// free; and a canal that lies within the section.
#include <algorithm>

#include "simulator/base/check.h"
#include "simulator/cutting/hinge/hinge.h"
#include "simulator/cutting/solid/commit_patch.h"
#include "tests/screenshots/kernel_pictures.h"
#include "tests/screenshots/plane_view.h"
#include "tests/screenshots/sawn_bones.h"
#include "tests/simulator/cutting/worlds/cut_through.h"

namespace hallux::tests {

using namespace simulator;

namespace {

const Vec2 straight(1.0, 0.0);

/// Two strokes side by side up to the hinge's line.
KerfField opened_to_hinge(const Blade& blade) {
  KerfField field(wide_grid());
  saw(field, blade, {{Vec2(-24.0, 5.0), straight}, {Vec2(0.0, 5.0), straight}});
  saw(field, blade, {{Vec2(-24.0, -5.0), straight}, {Vec2(0.0, -5.0), straight}});
  return field;
}

void draw_wedge(SvgPage& page, const CutSolid& cut) {
  const std::vector<CutSolid> pieces = split_pieces(cut);
  CHECK(pieces.size() == 2);
  Scene scene;
  scene.add(pieces[0].mesh, paints_of(pieces[0], true));
  scene.add(pieces[1].mesh, paints_of(pieces[1], true), Vec3(0.0, 0.0, -9.0));
  Camera camera = camera_from(Vec3(0.5, 0.72, -0.5), Vec3(0.0, 1.0, 0.0));
  camera.target_mm = Vec3(14.0, 0.0, -4.0);
  camera.middle_px = Vec2(250.0, 225.0);
  camera.px_per_mm = 10.2;
  draw(scene, camera, page);
  page.label(Vec2(165.0, 62.0), Vec2(233.0, 117.0), "wall of the first kerf");
  page.label(Vec2(385.0, 340.0), Vec2(338.0, 276.0), "wedge, its wall");
  page.text(Vec2(385.0, 356.0), "of the second");
  page.text(Vec2(235.0, 442.0), "two kerfs that meet, and the wedge between them", "small",
            "middle");
}

void draw_meeting(SvgPage& page, const SlabSlice& contact, const RegionOutline& region) {
  const PlaneView view{Vec2(-8.5, 0.0), Vec2(670.0, 115.0), 9.0};
  page.begin_window(Vec2(480.0, 15.0), Vec2(385.0, 190.0));
  page.path(section_path(view, contact, 1), "bonefill");
  page.path(region_path(view, region), "open");
  page.path(region_path(view, region), "dash");
  page.path(contour_path(view, contact, 1, -1), "bone");
  page.path(contour_path(view, contact, 1, 0), "wall");
  page.end_window();
  page.text(Vec2(670.0, 222.0), "the second kerf's plane: bone ends at the first one's wall",
            "small", "middle");
}

void draw_canal(SvgPage& page, const PlannedBone& bone) {
  const KerfPlane plane =
      plane_through(Vec3(16.0, 0.0, 0.0), Vec3(1.0, 0.1, 0.0), 1.0, Vec3(0.0, 0.0, 1.0));
  KerfField field(wide_grid());
  saw(field, {12.0, 25.0, 1.0}, {{Vec2(-24.0, 3.5), straight}, {Vec2(0.5, 3.5), straight}});
  const SawnFrame frame = frame_of(bone.solid, plane, field, 1);
  const CutSolid cut = commit_patch(bone.solid, frame.patch);
  const CutSolid lower = divide_at_hinge(cut, Bvh(cut.mesh), plane).below;
  Scene scene;
  scene.add(lower.mesh, paints_of(lower, false));
  Camera camera = camera_from(Vec3(0.8, 0.3, -0.52), Vec3(0.0, 1.0, 0.0));
  camera.target_mm = Vec3(10.0, 0.0, 0.0);
  camera.middle_px = Vec2(680.0, 345.0);
  camera.px_per_mm = 11.0;
  draw(scene, camera, page);
  page.text(Vec2(670.0, 442.0), "a kerf half way through the shaft, the near half taken off",
            "small", "middle");
}

}  // namespace

std::string draw_earlier_kerfs() {
  const PlannedBone bone = akin_phalanx(0.9);
  const Blade& blade = bone.scenario.saw.blade;
  const KerfPlane first = planned_kerf(bone, 0, blade.kerf_mm);
  const KerfPlane second = planned_kerf(bone, 1, blade.kerf_mm);
  const KerfField field = opened_to_hinge(blade);
  const CutSolid once = commit_patch(bone.solid, frame_of(bone.solid, first, field, 0).patch);
  const SawnFrame frame = frame_of(once, second, field, 1);
  SvgPage page(Vec2(880.0, 460.0), "A kerf that meets an earlier one");
  draw_wedge(page, commit_patch(once, frame.patch));
  draw_meeting(page, frame.contact, frame.region);
  draw_canal(page, bone);
  return page.take();
}

}  // namespace hallux::tests

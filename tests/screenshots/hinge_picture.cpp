// The hinge of the Akin plan: how its bridge is measured in the first kerf's plane, and the bone
// before and after closing.
#include <algorithm>
#include <cmath>

#include "assessment/number_text.h"
#include "simulator/base/check.h"
#include "simulator/cutting/hinge/hinge.h"
#include "simulator/cutting/solid/commit_patch.h"
#include "tests/screenshots/kernel_pictures.h"
#include "tests/screenshots/plane_view.h"
#include "tests/screenshots/sawn_bones.h"

namespace hallux::tests {

using namespace simulator;

namespace {

constexpr std::size_t rows_a_drawn_one = 12;  // of 0.05 mm

struct Osteotomy {
  CutSolid bone;  ///< without the wedge
  Section section;
  RegionOutline region;
  HingeRequest request;
};

/// The two strokes end unevenly, as a hand leaves them.
KerfField opened_by_hand(const Blade& blade) {
  KerfField field(wide_grid());
  const Vec2 leaning(0.9992009587217894, 0.03996803834887158);
  saw(field, blade, {{Vec2(-24.0, 4.6), Vec2(1.0, 0.0)}, {Vec2(-0.2, 4.6), Vec2(1.0, 0.0)}});
  saw(field, blade, {{Vec2(-24.0, -5.0), leaning}, {Vec2(-0.35, -4.3), leaning}});
  return field;
}

Osteotomy make_osteotomy() {
  const PlannedBone bone = akin_phalanx(1.0);
  const Blade& blade = bone.scenario.saw.blade;
  const Bvh bvh(bone.solid.mesh);
  Osteotomy made;
  made.request.bridge.line = planned_hinge_line(bone);
  made.request.first = planned_kerf(bone, 0, blade.kerf_mm);
  made.request.second = planned_kerf(bone, 1, blade.kerf_mm);
  const KerfField field = opened_by_hand(blade);
  made.region = outline_of(field);
  made.section = slice_section(bone.solid, bvh, made.request.first);
  const Section other = slice_section(bone.solid, bvh, made.request.second);
  made.request.first_gap =
      measure_hinge_gap(made.section, made.region, made.request.bridge.line).value();
  made.request.second_gap = measure_hinge_gap(other, made.region, made.request.bridge.line).value();
  const CutSolid once =
      commit_patch(bone.solid, frame_of(bone.solid, made.request.first, field, 0).patch);
  const CutSolid twice = commit_patch(once, frame_of(once, made.request.second, field, 1).patch);
  made.bone = split_pieces(twice).front();
  return made;
}

/// Kerf 0's frame has its origin over the hinge's point: x is outward, y along the line.
void draw_rows(SvgPage& page, const PlaneView& view, const HingeGap& gap) {
  for (std::size_t i = rows_a_drawn_one / 2; i < gap.rows.size(); i += rows_a_drawn_one) {
    const HingeRow& row = gap.rows[i];
    const Vec2 tip = view.page(Vec2(row.tip_mm, row.along_mm));
    const Vec2 far = view.page(Vec2(row.far_mm, row.along_mm));
    if (row.is_apex) page.line(tip, far, "apex");
    page.dot(tip, 2.6, row.is_apex ? "tip" : "node");
  }
}

void draw_thickness(SvgPage& page, const PlaneView& view, const Osteotomy& made) {
  const HingeGap& gap = made.request.first_gap;
  const RigidTransform kerf_from_bone = inverse(made.request.first.bone_from_kerf);
  const Vec3 tip = transform_point(kerf_from_bone, gap.tip_in_bone_mm);
  const Vec3 far = transform_point(kerf_from_bone, gap.far_in_bone_mm);
  const double above_mm = 10.4;
  page.line(view.page(Vec2(far.x, far.y)), view.page(Vec2(far.x, -above_mm)), "thin");
  page.line(view.page(Vec2(tip.x, tip.y)), view.page(Vec2(tip.x, -above_mm)), "thin");
  page.measure(view.page(Vec2(tip.x, -above_mm)), view.page(Vec2(far.x, -above_mm)));
  page.text(view.page(Vec2(far.x, -above_mm)) + Vec2(12.0, 4.0),
            "thickness " + assessment::number_text(gap.thickness_mm, 2) + " mm", "head");
}

void draw_section(SvgPage& page, const Osteotomy& made) {
  const PlaneView view{Vec2(-3.6, 0.0), Vec2(150.0, 205.0), 18.5};
  std::string bone;
  for (const SectionRegion& region : made.section.regions) {
    for (const Contour& contour : region.contours) bone += path_through(view.pages(contour), true);
  }
  page.begin_window(Vec2(15.0, 15.0), Vec2(400.0, 430.0));
  page.path(bone, "bonefill");
  page.path(bone, "bone");
  page.path(region_path(view, made.region), "open");
  page.path(region_path(view, made.region), "dash");
  page.line(view.page(Vec2(0.0, -12.0)), view.page(Vec2(0.0, 10.4)), "plan");
  draw_rows(page, view, made.request.first_gap);
  draw_thickness(page, view, made);
  page.end_window();
  page.label(Vec2(275.0, 40.0), view.page(Vec2(0.0, 9.0)), "planned line");
  page.label(Vec2(275.0, 95.0), view.page(Vec2(0.3, 4.6)), "rows, from tip");
  page.text(Vec2(275.0, 111.0), "to far cortex");
  page.text(view.page(Vec2(-8.3, 0.0)), "canal", "words", "middle");
  page.text(view.page(Vec2(-6.4, -8.6)), "opened by the blade", "words", "middle");
}

CutSolid turned(CutSolid solid, const RigidTransform& bone_from_moved) {
  for (Vec3& point : solid.mesh.points_mm) point = transform_point(bone_from_moved, point);
  return solid;
}

/// Seen from dorsal; medial, where the blade comes from, is up.
Camera dorsal_camera(const Vec2& middle_px) {
  Camera camera = camera_from(Vec3(0.0, 1.0, -0.12), Vec3(0.0, 0.0, -1.0));
  camera.target_mm = Vec3(16.5, 0.0, 0.0);
  camera.middle_px = middle_px;
  camera.px_per_mm = 9.4;
  return camera;
}

void draw_closing(SvgPage& page, const Osteotomy& made) {
  Scene before, after;
  before.add(made.bone.mesh, paints_of(made.bone, true));
  const Camera upper = dorsal_camera(Vec2(610.0, 118.0));
  draw(before, upper, page);
  const ClosedHinge hinge = close_hinge(made.bone, Bvh(made.bone.mesh), made.request);
  CHECK(hinge.outcome == HingeOutcome::Closed);
  const CutSolid moved = turned(hinge.moved, hinge.bone_from_moved);
  after.add(hinge.fixed.mesh, paints_of(hinge.fixed, true));
  after.add(moved.mesh, paints_of(moved, true));
  const Camera lower = dorsal_camera(Vec2(610.0, 345.0));
  draw(after, lower, page);
  for (const Camera& camera : {upper, lower}) {
    page.dot(camera.page(hinge.joint.point_mm), 3.5, "corner");
  }
  const Vec2 joint = lower.page(hinge.joint.point_mm);
  page.label(joint + Vec2(60.0, 22.0), joint + Vec2(5.0, 2.0), "joint");
  page.text(Vec2(835.0, 40.0), "wedge taken out", "head", "end");
  page.text(
      Vec2(835.0, 432.0),
      "closed by " + assessment::number_text(degree_from_radian(hinge.angle_rad), 1) + " degrees",
      "head", "end");
}

}  // namespace

std::string draw_hinge() {
  const Osteotomy made = make_osteotomy();
  SvgPage page(Vec2(880.0, 460.0), "The bridge in the kerf's plane, and the wedge closed on it");
  page.add_style("apex", "fill:none;stroke:#d55e00;stroke-width:1.1");
  draw_section(page, made);
  draw_closing(page, made);
  return page.take();
}

}  // namespace hallux::tests

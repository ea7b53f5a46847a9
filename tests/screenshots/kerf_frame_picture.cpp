// The bone at the moment in which a plane is frozen: blade, slab and the kerf's axes.
//
// The slab is a glass box, so the bone is divided on its two planes and painted in five layers:
// what lies behind the far plane, that plane, what lies between, the near plane, what lies before
// it.
#include <cmath>

#include "simulator/cutting/hinge/hinge.h"
#include "tests/screenshots/kernel_pictures.h"
#include "tests/screenshots/sawn_bones.h"

namespace hallux::tests {

using namespace simulator;

namespace {

constexpr double kerf_mm = 2.0;  // four times a real one, so that it is seen
constexpr double steel_mm = 1.3;

/// A prism over a polygon of the kerf's plane; caps as fans around corner 0, which must see all
/// others.
void add_prism(IndexedMesh& mesh, const KerfPlane& plane, const std::vector<Vec2>& outline_mm,
               double thickness_mm) {
  const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
  const auto count = static_cast<std::uint32_t>(outline_mm.size());
  for (const double side : {-0.5, 0.5}) {
    for (const Vec2& place : outline_mm) {
      mesh.points_mm.push_back(point_in_bone_mm(plane, place, side * thickness_mm));
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = first + i, b = first + (i + 1) % count;
    mesh.triangles.push_back({a, b, b + count});
    mesh.triangles.push_back({a, b + count, a + count});
    if (i == 0 || i + 1 == count) continue;
    mesh.triangles.push_back({first, b, a});
    mesh.triangles.push_back({first + count, a + count, b + count});
  }
}

/// A blade with its tooth line at x = 0; its teeth are drawn much coarser than steel has them.
IndexedMesh blade_mesh(const KerfPlane& plane, const Blade& blade) {
  constexpr int teeth = 10;
  constexpr double tooth_mm = 1.0;
  IndexedMesh mesh;
  const double half_mm = 0.5 * blade.width_mm, pitch_mm = blade.width_mm / teeth;
  add_prism(mesh, plane,
            {{-blade.depth_mm, -half_mm},
             {-tooth_mm, -half_mm},
             {-tooth_mm, half_mm},
             {-blade.depth_mm, half_mm}},
            steel_mm);
  for (int i = 0; i < teeth; ++i) {
    const double low_mm = -half_mm + i * pitch_mm;
    add_prism(mesh, plane,
              {{-tooth_mm, low_mm}, {0.0, low_mm + 0.5 * pitch_mm}, {-tooth_mm, low_mm + pitch_mm}},
              steel_mm);
  }
  return mesh;
}

/// The bone's skin; the faces of the two divisions are left out, since the bone is not cut yet.
Scene undivided_scene(const CutSolid& solid) {
  Scene scene;
  for (std::size_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    if (solid.sources[i].kerf != -1) continue;
    const auto& [a, b, c] = solid.mesh.triangles[i];
    scene.add({solid.mesh.points_mm[a], solid.mesh.points_mm[b], solid.mesh.points_mm[c]},
              Paint::Skin);
  }
  return scene;
}

struct SlabParts {
  CutSolid above, between, below;
};

SlabParts divide(const CutSolid& solid, const KerfPlane& plane) {
  KerfPlane upper = plane, lower = plane;
  upper.bone_from_kerf.translation_mm = point_in_bone_mm(plane, Vec2(0.0), 0.5 * kerf_mm);
  lower.bone_from_kerf.translation_mm = point_in_bone_mm(plane, Vec2(0.0), -0.5 * kerf_mm);
  DividedBone first = divide_at_hinge(solid, Bvh(solid.mesh), upper);
  DividedBone second = divide_at_hinge(first.below, Bvh(first.below.mesh), lower);
  return {std::move(first.above), std::move(second.above), std::move(second.below)};
}

std::vector<Vec2> pane(const Camera& camera, const KerfPlane& plane, double height_mm) {
  std::vector<Vec2> places;
  for (const Vec2& corner :
       {Vec2(-13.0, -13.0), Vec2(24.0, -13.0), Vec2(24.0, 12.0), Vec2(-13.0, 12.0)}) {
    places.push_back(camera.page(point_in_bone_mm(plane, corner, height_mm)));
  }
  return places;
}

void draw_axes(SvgPage& page, const Camera& camera, const KerfPlane& plane) {
  const Vec2 origin = camera.page(point_in_bone_mm(plane, Vec2(0.0)));
  const Vec2 x = camera.page(point_in_bone_mm(plane, Vec2(10.0, 0.0)));
  const Vec2 y = camera.page(point_in_bone_mm(plane, Vec2(0.0, 9.5)));
  const Vec2 z = camera.page(point_in_bone_mm(plane, Vec2(0.0), 9.0));
  page.arrow(origin, x, "axis");
  page.arrow(origin, y, "axis");
  page.arrow(origin, z, "axis");
  page.dot(origin, 3.5, "corner");
  page.text(x + Vec2(8.0, 4.0), "x  feed", "head");
  page.text(y + Vec2(-6.0, -8.0), "y  along the tooth line", "head", "middle");
  page.text(z + Vec2(-6.0, 16.0), "z  blade normal", "head", "middle");
}

}  // namespace

std::string draw_kerf_frame() {
  const PlannedBone bone = akin_phalanx(0.8);
  const KerfPlane planned = planned_kerf(bone, 0, kerf_mm);
  // The origin: the middle of the tooth line where it meets the skin, 0.3 mm deep.
  const Vec3 entry =
      transform_point(inverse(planned.bone_from_kerf), bone.plan.cuts[0].entry_point_in_bone_mm);
  const KerfPlane plane = moved_in_plane(planned, Vec2(entry.x + 0.3, entry.y));
  const SlabParts parts = divide(bone.solid, plane);

  SvgPage page(Vec2(880.0, 460.0), "The kerf frame on a first proximal phalanx");
  Camera camera = camera_from(Vec3(-0.5, 0.55, -0.66), Vec3(0.0, 1.0, 0.0));
  camera.target_mm = Vec3(12.0, 0.0, -3.0);
  camera.middle_px = Vec2(430.0, 236.0);
  camera.px_per_mm = 11.0;
  const auto glass = [&](double side) {
    page.polygon(pane(camera, plane, 0.5 * side * kerf_mm), "pane");
  };
  // The eye is above the slab.
  draw(undivided_scene(parts.below), camera, page, Lines::Triangles);
  glass(-1.0);
  Scene between = undivided_scene(parts.between);
  const IndexedMesh blade = blade_mesh(plane, bone.scenario.saw.blade);
  between.add(blade, std::vector<Paint>(blade.triangles.size(), Paint::Blade));
  draw(between, camera, page);
  glass(1.0);
  draw(undivided_scene(parts.above), camera, page, Lines::Triangles);
  draw_axes(page, camera, plane);
  const Vec2 low = camera.page(point_in_bone_mm(plane, Vec2(24.0, 12.0), -0.5 * kerf_mm));
  const Vec2 high = camera.page(point_in_bone_mm(plane, Vec2(24.0, 12.0), 0.5 * kerf_mm));
  page.measure(low, high);
  page.text(0.5 * (low + high) + Vec2(0.0, -10.0), "w", "head", "middle");
  page.label(Vec2(648.0, 60.0), camera.page(point_in_bone_mm(plane, Vec2(19.0, 9.0))),
             "slab |z| \xE2\x89\xA4 w/2");
  page.label(Vec2(210.0, 380.0), camera.page(point_in_bone_mm(plane, Vec2(-14.0, 0.0))), "blade");
  page.label(Vec2(190.0, 120.0), camera.page(Vec3(28.0, 3.0, -4.0)), "bone");
  return page.take();
}

}  // namespace hallux::tests

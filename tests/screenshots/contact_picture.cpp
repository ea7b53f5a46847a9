// The contact slice of a plane that stands obliquely across the shaft: in space, drawn apart, and
// in the kerf's plane.
#include "simulator/base/check.h"
#include "tests/screenshots/kernel_pictures.h"
#include "tests/screenshots/plane_view.h"
#include "tests/screenshots/sawn_bones.h"
#include "tests/simulator/cutting/worlds/cut_through.h"

namespace hallux::tests {

using namespace simulator;

namespace {

constexpr double kerf_mm = 1.5;  // three times a real one, so that the strip is seen
constexpr double apart_mm = 7.0;

/// Skin that no plane touches, by the side of the kerf on which it lies.
void add_untouched(Scene& scene, const CutSolid& solid, const SlabSlice& contact) {
  IndexedMesh above, below;
  above.points_mm = below.points_mm = solid.mesh.points_mm;
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    if (next < contact.touched.size() && contact.touched[next].base_triangle == i) {
      ++next;
      continue;
    }
    const bool is_above = level_of(contact.plane, solid.mesh, solid.mesh.triangles[i]) > 0;
    (is_above ? above : below).triangles.push_back(solid.mesh.triangles[i]);
  }
  const Vec3 z = contact.axes.z;
  scene.add(above, std::vector<Paint>(above.triangles.size(), Paint::Skin), apart_mm * z);
  scene.add(below, std::vector<Paint>(below.triangles.size(), Paint::Skin), -apart_mm * z);
}

/// Outer parts as PatchBuilder fans them where no region crosses their edge.
void add_outer_parts(Scene& scene, const CutSolid& solid, const SlabSlice& contact) {
  for (const OuterPart& part : contact.outer_parts) {
    const StripEdge& edge = contact.edges[part.edge];
    const Vec3 shift_mm = edge.level * apart_mm * contact.axes.z;
    const Vec3 a = contact.points[edge.a].point_in_bone_mm + shift_mm;
    const Vec3 b = contact.points[edge.b].point_in_bone_mm + shift_mm;
    const Vec3 first = solid.mesh.points_mm[part.corners[0]] + shift_mm;
    scene.add({first, b, a}, Paint::OuterPart);
    if (part.corner_count == 1) continue;
    scene.add({first, solid.mesh.points_mm[part.corners[1]] + shift_mm, b}, Paint::OuterPart);
  }
}

void add_strip(Scene& scene, const SlabSlice& contact) {
  IndexedMesh strip;
  for (const StripPoint& point : contact.points) strip.points_mm.push_back(point.point_in_bone_mm);
  for (const StripTriangle& triangle : contact.triangles)
    strip.triangles.push_back(triangle.points);
  scene.add(strip, std::vector<Paint>(strip.triangles.size(), Paint::Strip));
}

void draw_in_space(SvgPage& page, const CutSolid& solid, const SlabSlice& contact) {
  Scene scene;
  add_untouched(scene, solid, contact);
  add_outer_parts(scene, solid, contact);
  add_strip(scene, contact);
  Camera camera = camera_from(Vec3(-0.42, 0.5, -0.76), Vec3(0.0, 1.0, 0.0));
  camera.target_mm = Vec3(16.0, 0.0, 0.0);
  camera.middle_px = Vec2(235.0, 215.0);
  camera.px_per_mm = 9.6;
  draw(scene, camera, page, Lines::Triangles, Shows::OpenSurfaces);
}

void draw_in_plane(SvgPage& page, const SlabSlice& contact) {
  const PlaneView view{Vec2(0.0, 0.0), Vec2(655.0, 225.0), 18.0};
  page.path(section_path(view, contact, -1), "bonefill");
  std::string d;
  for (const StripTriangle& triangle : contact.triangles) {
    std::vector<Vec2> places_mm;
    for (const std::uint32_t point : triangle.points) {
      places_mm.push_back(place_mm(contact.axes, contact.points[point].point_in_bone_mm));
    }
    d += path_through(view.pages(places_mm), true);
  }
  page.path(d, "strip");
  page.path(contour_path(view, contact, -1, -1), "bone");
  page.path(contour_path(view, contact, 1, -1), "wall");
}

}  // namespace

std::string draw_contact() {
  const PlannedBone bone = akin_phalanx(1.2);
  const KerfPlane plane =
      plane_through(Vec3(15.0, 0.5, 0.5), Vec3(-0.84, 0.38, 0.4), kerf_mm, Vec3(0.0, 0.0, 1.0));
  const SlabSlice contact = slice_slab(bone.solid, Bvh(bone.solid.mesh), plane, 0, wide_grid());
  CHECK(contact.skin_count == 2);
  SvgPage page(Vec2(880.0, 450.0), "The contact slice of an oblique plane");
  draw_in_space(page, bone.solid, contact);
  draw_in_plane(page, contact);
  page.text(Vec2(100.0, 345.0), "below -w/2", "words", "middle");
  page.text(Vec2(245.0, 345.0), "strip", "words", "middle");
  page.text(Vec2(390.0, 345.0), "above +w/2", "words", "middle");
  page.label(Vec2(560.0, 60.0), Vec2(590.0, 133.0), "contour at -w/2, around bone");
  page.label(Vec2(560.0, 395.0), Vec2(514.0, 300.0), "contour at +w/2");
  page.label(Vec2(780.0, 395.0), Vec2(700.0, 330.0), "strip triangle");
  page.text(Vec2(672.0, 205.0), "canal", "words", "middle");
  page.text(Vec2(235.0, 432.0), "strip, outer parts and untouched skin, drawn apart", "small",
            "middle");
  page.text(Vec2(655.0, 432.0), "the same strip in the kerf's plane", "small", "middle");
  return page.take();
}

}  // namespace hallux::tests

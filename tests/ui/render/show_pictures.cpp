// Draws every kind of picture into a folder, for eyes: `show_render_pictures DIR [EDGE_MM]`. No
// test compares these files.
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "simulator/base/units.h"
#include "tests/ui/render/drilled_bone.h"
#include "tests/ui/render/operating_world.h"
#include "ui/render/gl/headless_context.h"
#include "ui/render/picture.h"
#include "ui/render/scene/driver_model.h"
#include "ui/render/scene/swarf.h"
#include "ui/render/stereo.h"

namespace hallux::tests {

namespace {

using namespace ui;

constexpr PixelSize size{1280, 720};

class Album {
 public:
  explicit Album(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::filesystem::create_directories(folder_);
  }

  void add(const std::string& name, const Scene& scene, const Camera& camera) {
    write_png(folder_ / (name + ".png"), render_picture(renderer_, scene, camera, size));
  }
  void add_live(const std::string& name, const Scene& scene, const Camera& camera,
                StereoMode mode) {
    const RenderTarget window(size);
    stage_.draw(renderer_, scene, camera, {.mode = mode}, window.target());
    write_png(folder_ / (name + ".png"), window.read());
  }

 private:
  HeadlessContext context_;
  std::filesystem::path folder_;
  Renderer renderer_;
  StereoStage stage_;
};

Scene on_light(Scene scene) {
  scene.ground = Ground::Light;
  return scene;
}

/// What is drawn around a cut: zones, what holds, where the teeth meet the bone.
void add_site(Album& album, OperatingWorld& world) {
  Scene scene = world.scene();
  scene.zones = world.zones();
  if (!scene.zones.empty()) scene.zones.front().is_near = true;
  album.add("site_zones", scene, world.camera());
  album.add("site_zones_light", on_light(scene), world.camera());
  album.add("site_zones_plantar", scene, standard_view(world.camera(), StandardView::Plantar));
  scene.zones.clear();
  scene.held = {world.held()};
  scene.marks = {{world.world_from_tool().translation_mm, 7.0, Ink::Warn, MarkShape::Diamond}};
  album.add("site_held", scene, world.camera());
  scene.held.clear();
  scene.marks.clear();
  scene.halo = ContactHalo{HaloKind::Behind, world.world_from_tool(), 6.0, 0.0};
  album.add("site_behind", scene, world.camera());
  for (const double away_mm : {9.0, 4.0, 0.0}) {
    RigidTransform tool = world.world_from_tool();
    tool.translation_mm -= tool.rotation * Vec3(away_mm + 4.4, 0.0, 0.0);
    scene.saw->world_from_tool = tool;
    scene.planes.clear();
    scene.halo = ContactHalo{away_mm > 0.0 ? HaloKind::Before : HaloKind::On, tool, 6.0, away_mm};
    album.add("site_before_" + std::to_string(static_cast<int>(away_mm)), scene, world.camera());
  }
}

/// A plane that turns to its edge.
void add_planes(Album& album, const OperatingWorld& world) {
  Scene scene = world.scene();
  scene.saw.reset();
  scene.lines.clear();
  const RigidTransform plane = world.world_from_face("proximal_face");
  for (const double angle_deg : {30.0, 10.0, 2.0}) {
    const Vec3 along = plane.rotation * Vec3(0.0, 1.0, 0.0);
    const Vec3 from = rotation_about(along, radian_from_degree(angle_deg)) *
                      (plane.rotation * Vec3(-1.0, 0.0, 0.0));
    Camera camera = world.camera();
    camera.target_mm = plane.translation_mm;
    camera.world_from_view = rotation_from_axes(glm::normalize(glm::cross(along, from)), along);
    album.add("plane_" + std::to_string(static_cast<int>(angle_deg)), scene, camera);
  }
}

/// Where things are drilled and driven in, seen from medial.
struct DrillPlace {
  Scene scene;
  DrillLine line, beside;
  Camera camera;

  explicit DrillPlace(const OperatingWorld& world)
      : scene(world.scene()),
        line(drill_line(world, Vec3(15.0, 0.0, 0.0), Vec3(0.55, -0.75, 0.25))),
        beside(drill_line(world, Vec3(24.0, 0.0, 0.0), Vec3(0.2, -0.8, 0.4))),
        camera(orbited(standard_view(world.camera(), StandardView::Medial), 0.5, 0.35)) {
    scene.saw.reset();
    scene.planes.clear();
    scene.lines.clear();
  }
  Camera seen(const Vec3& target_mm, double magnification) const {
    Camera seen = camera;
    seen.target_mm = target_mm;
    seen.magnification = magnification;
    return seen;
  }
};

void add_driver(Album& album, const DrillPlace& place, const std::string& name,
                const simulator::Tool& tool) {
  Scene scene = place.scene;
  const auto add = [&](const std::string& what, const Camera& camera) {
    album.add("tool_" + name + what, scene, camera);
    album.add("tool_" + name + what + "_light", on_light(scene), camera);
  };
  const RigidTransform before = place.line.world_from_tool(-4.0);
  const auto on_axis = [&](double x_mm) { return transform_point(before, Vec3(x_mm, 0.0, 0.0)); };
  scene.driver = DriverInScene{before, tool};
  add("", place.seen(place.camera.target_mm, 3.2));
  add("_near", place.seen(on_axis(0.0), 18.0));
  add("_whole", place.seen(on_axis(-90.0), 1.25));
  add("_chuck", place.seen(on_axis(chuck_x_mm(tool) - 14.0), 5.0));
  Camera along = place.seen(on_axis(0.0), place.camera.magnification);
  along.world_from_view =
      rotation_from_axes(axis_z(before), glm::cross(-axis_x(before), axis_z(before)));
  add("_along", along);
  scene.driver->handpiece_presence = 0.3;
  add("_through", place.seen(on_axis(-60.0), 1.9));
  scene.driver = DriverInScene{place.line.world_from_tool(7.0), tool, true, 0.8};
  add("_in", place.camera);
}

/// What else is held, and what is left, on both grounds.
void add_metal(Album& album, const OperatingWorld& world, const DrillPlace& place) {
  Scene scene = place.scene;
  const auto add = [&](const std::string& name, const Camera& camera) {
    album.add("tool_" + name, scene, camera);
    album.add("tool_" + name + "_light", on_light(scene), camera);
  };
  const Camera near = place.seen(place.line.world_from_line.translation_mm, 18.0);
  scene.forceps = ForcepsInScene{place.line.world_from_tool(2.0), 13.0};
  add("forceps", place.camera);
  add("forceps_whole", place.seen(place.line.world_from_tool(-70.0).translation_mm, 1.9));
  scene.forceps.reset();
  scene.holes = {hole_at(world, place.line, 1.35), hole_at(world, place.beside, 1.0)};
  add("holes", near);
  simulator::Screw screw;
  screw.length_mm = 12.0;
  simulator::WireDriver wire;
  wire.wire.length_mm = 30.0;
  scene.implants = {{place.line.world_from_tool(11.6), simulator::Screwdriver{screw}},
                    {place.beside.world_from_tool(12.0), wire}};
  add("implants", place.camera);
  add("implants_near", near);
  for (ImplantInScene& implant : scene.implants) implant.is_planned = true;
  scene.holes.clear();
  add("planned", place.camera);
  add("planned_near", near);
}

void add_tools(Album& album, const OperatingWorld& world) {
  const DrillPlace place(world);
  add_driver(album, place, "wire", simulator::WireDriver{});
  add_driver(album, place, "drill", simulator::Drill{});
  add_driver(album, place, "screw", simulator::Screwdriver{});
  add_metal(album, world, place);
}

void add_wedge(Album& album, OperatingWorld& world) {
  world.take_wedge_out();
  Scene scene = world.scene();
  Camera camera = world.camera();
  album.add("wedge", scene, camera);
  album.add("wedge_light", on_light(scene), camera);
  camera.magnification = 20.0;
  album.add("wedge_near", scene,
            along_blade(camera, world.world_from_tool(), BladeSight::AcrossFromMinus));
  // As if the plan had been a little oblique to what was cut.
  const Vec3 normal = glm::normalize(world.cut().face.normal + Vec3(0.0, 0.10, 0.14));
  const Vec3 middle_mm =
      0.5 * (world.cut().entry_point_in_bone_mm + world.cut().exit_point_in_bone_mm);
  scene.bones.front().map = SignedMap{.kerf = 0,
                                      .side = 0,
                                      .normal_in_bone = normal,
                                      .offset_mm = glm::dot(normal, middle_mm) - 0.2,
                                      .range_mm = 2.0};
  scene.bones.front().cut_away =
      CutAway{world.cut().face.normal, world.cut().face.offset_mm + 0.25};
  camera.magnification = 14.0;
  camera = standard_view(camera, StandardView::Distal);
  camera = orbited(camera, -0.45, 0.30);
  scene.planes = {
      {world.world_from_face("proximal_face"), Vec2(16.0, 13.0), Ink::Reference, false, false}};
  album.add("map", scene, camera);
}

void show(const std::filesystem::path& folder, double edge_mm) {
  OperatingWorld world(edge_mm);
  Album album(folder);
  world.saw_to(-4.0);
  Scene scene = world.scene();
  const Camera camera = world.camera();
  album.add("operating_dark", scene, camera);
  album.add("operating_light", on_light(scene), camera);
  album.add_live("live", scene, camera, StereoMode::Mono);
  album.add_live("side_by_side", scene, camera, StereoMode::SideBySide);
  album.add_live("anaglyph", scene, camera, StereoMode::Anaglyph);
  scene.saw->is_running = true;
  scene.saw->swing = 0.3;
  scene.planes.clear();
  Swarf swarf(1);
  const SwarfSource source{scene.saw->world_from_tool, 12.0, 8.0, false};
  for (int frame = 0; frame < 40; ++frame) swarf.advance(1.0 / 30.0, source);
  scene.chips = swarf.chips();
  album.add("running", scene, camera);
  Camera near = camera;
  near.magnification = 22.0;
  near.target_mm = transform_point(world.world_from_tool(), Vec3(0.0));
  album.add("near", scene, near);
  for (int view = 0; view + 1 < standard_view_count; ++view) {
    album.add("view_" + std::to_string(view + 1), scene,
              standard_view(camera, static_cast<StandardView>(view)));
  }
  for (std::size_t sight = 0; sight < blade_sight_count; ++sight) {
    Scene along = scene;
    if (static_cast<BladeSight>(sight) == BladeSight::OverHandle) {
      along.saw->handpiece_presence = 0.1;
    }
    album.add("along_blade_" + std::to_string(sight), along,
              along_blade(camera, scene.saw->world_from_tool, static_cast<BladeSight>(sight)));
  }
  add_site(album, world);
  add_planes(album, world);
  add_tools(album, world);
  add_wedge(album, world);
}

}  // namespace

}  // namespace hallux::tests

int main(int count, char** words) {
  if (count < 2) {
    std::cerr << "usage: show_render_pictures DIR [EDGE_MM]\n";
    return 2;
  }
  try {
    hallux::tests::show(words[1], count > 2 ? std::atof(words[2]) : 0.3);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "show_render_pictures: " << error.what() << '\n';
    return 1;
  }
}

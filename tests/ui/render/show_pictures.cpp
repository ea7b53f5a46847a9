// Draws every kind of picture into a folder, for eyes: `show_render_pictures DIR [EDGE_MM]`. No
// test compares these files.
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "tests/ui/render/operating_world.h"
#include "ui/render/gl/headless_context.h"
#include "ui/render/picture.h"
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

void add_wedge(Album& album, OperatingWorld& world) {
  world.take_wedge_out();
  Scene scene = world.scene();
  Camera camera = world.camera();
  album.add("wedge", scene, camera);
  album.add("wedge_light", on_light(scene), camera);
  camera.magnification = 20.0;
  album.add("wedge_near", scene, standard_view(camera, StandardView::AlongBlade));
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
  scene.planes = {{world.world_from_face("proximal_face"), Vec2(16.0, 13.0), Ink::Accent, false}};
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
  for (int view = 0; view < standard_view_count; ++view) {
    album.add("view_" + std::to_string(view + 1), scene,
              standard_view(camera, static_cast<StandardView>(view)));
  }
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

// A bone in four frames of one cut: what stands, without the hidden triangles, and the patch
// painted by kind.
#include "tests/screenshots/kernel_pictures.h"
#include "tests/screenshots/sawn_bones.h"

namespace hallux::tests {

using namespace simulator;

namespace {

constexpr double kerf_mm = 2.0;  // four times a real one, so that its inside is seen

struct Shot {
  std::vector<PlanarPose> poses;  ///< since the shot before
  std::string words;
};

std::vector<Shot> shots() {
  const Vec2 straight(1.0, 0.0);
  return {{{{{-30.0, 4.0}, straight}, {{-15.0, 4.0}, straight}}, "a notch"},
          {{{{-11.0, 4.0}, straight}}, "into the canal"},
          {{{{-5.0, 4.0}, straight}}, "past the canal"},
          {{{{-5.0, -4.0}, straight}, {{-0.5, -4.0}, straight}, {{-0.5, 4.0}, straight}},
           "to the hinge"}};
}

}  // namespace

std::string draw_frames() {
  const PlannedBone bone = akin_phalanx(1.2);
  const KerfPlane plane = planned_kerf(bone, 0, kerf_mm);
  KerfField field(wide_grid());
  SvgPage page(Vec2(880.0, 660.0), "Four frames of one cut");
  Camera camera = camera_from(Vec3(0.3, 0.62, -0.72), Vec3(0.0, 1.0, 0.0));
  camera.target_mm = Vec3(8.5, 0.0, 0.0);
  camera.px_per_mm = 12.4;
  const Vec2 size(420.0, 265.0);
  std::size_t shown = 0;
  for (const Shot& shot : shots()) {
    saw(field, bone.scenario.saw.blade, shot.poses);
    const SawnFrame frame = frame_of(bone.solid, plane, field);
    const Vec2 low(shown % 2 == 0 ? 15.0 : 445.0, shown < 2 ? 15.0 : 321.0);
    camera.middle_px = low + Vec2(225.0, 140.0);
    camera.low_px = low;
    camera.high_px = low + size;
    page.begin_window(low, size);
    draw(shown_scene(bone.solid, frame), camera, page, Lines::Triangles);
    page.end_window();
    page.polygon(
        std::vector<Vec2>{low, low + Vec2(size.x, 0.0), low + size, low + Vec2(0.0, size.y)},
        "frame");
    page.text(low + Vec2(12.0, size.y + 20.0), shot.words, "head");
    page.text(low + Vec2(size.x - 12.0, size.y + 20.0),
              std::to_string(frame.patch.hidden.size()) + " triangles hidden, " +
                  std::to_string(frame.patch.triangles.size()) + " in the patch",
              "small", "end");
    ++shown;
  }
  draw_keys(page, Vec2(60.0, 630.0),
            {{Paint::Skin, "mesh that stands"},
             {Paint::OuterPart, "outer part"},
             {Paint::Strip, "strip"},
             {Paint::UpperWall, "wall"},
             {Paint::Front, "front"}},
            Vec2(165.0, 0.0));
  return page.take();
}

}  // namespace hallux::tests

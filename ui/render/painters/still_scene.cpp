#include "ui/render/painters/still_scene.h"

#include "simulator/base/check.h"

namespace hallux::ui {

StillScene still_scene(const Scene& scene, const EyeView& view, double pixel_scale) {
  StillScene still{view, pixel_scale, {}, scene.ground, scene.light_place};
  for (const BoneInScene& bone : scene.bones) {
    still.bones.push_back({bone.mesh->id, bone.look->id, bone.world_from_bone, bone.presence,
                           bone.map, bone.cut_away});
  }
  return still;
}

PixelBox changed_pixels(const StillScene& scene, std::span<const Box> changed, PixelSize size) {
  CHECK(changed.size() == scene.bones.size());
  PixelBox pixels;
  for (std::size_t i = 0; i < changed.size(); ++i) {
    pixels =
        around(pixels, pixels_of(changed[i], scene.bones[i].world_from_bone, scene.view, size));
  }
  return pixels;
}

}  // namespace hallux::ui

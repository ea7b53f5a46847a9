#include "ui/screens/pictures/shown_camera.h"

#include <algorithm>

namespace hallux::ui {

simulator::ShownView shown_view(const Camera& camera, double width_over_height) noexcept {
  simulator::ShownView view;
  view.target_in_world_mm = camera.target_mm;
  view.world_from_view = camera.world_from_view;
  view.magnification = camera.magnification;
  view.target_depth_mm = camera.target_depth_mm;
  view.width_over_height = width_over_height;
  return view;
}

Camera camera_of(const simulator::ShownView& view, double width_over_height) noexcept {
  Camera camera;
  camera.target_mm = view.target_in_world_mm;
  camera.world_from_view = view.world_from_view;
  // The picture's width is that of the screen, whatever its shape.
  camera.magnification =
      view.magnification * std::min(1.0, view.width_over_height / width_over_height);
  camera.target_depth_mm = view.target_depth_mm;
  return camera;
}

}  // namespace hallux::ui

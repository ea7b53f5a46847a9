/// Motion of the saw and of the camera by pointer, wheel and keys; plain functions of what was
/// done. Inside this corner only.
#pragma once

#include <optional>

#include "simulator/device/mouse.h"
#include "ui/jobs/live_attempt.h"
#include "ui/render/scene/camera.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Where the saw is held when an attempt begins: off the bone on the side of the approach, its
/// blade square to the bone's own axes. What the plan asks beyond that is the trainee's to find.
RigidTransform start_pose(const PreparedCase& prepared_case);
/// The site as one stands before it.
Camera start_camera(const PreparedCase& prepared_case);

/// How the window is seen through.
struct Sight {
  Camera camera;
  Viewer viewer;
  Rect display;

  EyeView eye() const noexcept {
    return view_of(camera, viewer, Eye::Middle, static_cast<double>(display.w / display.h));
  }
};
/// Place of a point on the window, logical pixels; nothing where it lies behind the eye.
std::optional<Point> place_on(const Sight& sight, const Vec3& point_in_world_mm);

/// The target's motion in this frame. While the right or the middle button is held, the pointer
/// does not lead the saw.
class Steering {
 public:
  /// `tip_in_world_mm` is what the pointer's way is measured at.
  simulator::PointerMotion motion(const AreaResponse& area, const Modifiers& modifiers,
                                  const Sight& sight, const Vec3& tip_in_world_mm);
  /// The pointer does not lead now; where it goes on later, it begins there.
  void release_pointer() noexcept { pointer_.reset(); }
  bool is_led_by_pointer() const noexcept { return pointer_.has_value(); }
  /// The same by keys: arrows across, Page Up and Page Down in depth; with Ctrl they turn.
  simulator::PointerMotion motion_by_keys(Ui& ui) const;
  /// Middle drag orbits, with Shift it pans; the wheel with Ctrl zooms.
  Camera looked(const AreaResponse& area, const Modifiers& modifiers, const Sight& sight) const;

 private:
  /// Of the last frame, while it led.
  std::optional<Point> pointer_;
};

}  // namespace hallux::ui

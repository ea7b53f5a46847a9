/// Motion of the saw and of the camera by mouse and keys; plain functions of what was done.
#pragma once

#include <optional>

#include "simulator/device/mouse.h"
#include "ui/render/scene/camera.h"
#include "ui/screens/operating/hand/gestures.h"

namespace hallux::ui {

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

/// What a key press moves the saw by: across and along the blade, and turned.
inline constexpr double key_step_mm = 1.0, key_turn_rad = 0.0175;

/// What mouse and keys ask for in a frame.
struct Steered {
  simulator::PointerMotion by_mouse, by_keys;
  Camera camera;
  bool switches_saw = false;
};

class Steering {
 public:
  const HandLift& lift() const noexcept { return lift_; }
  /// The pointer does not lead now; where it goes on later, it begins there.
  void release_pointer() noexcept { pointer_.reset(); }
  /// The hand is on the saw again.
  void set_down() noexcept { lift_.set_down(); }
  bool is_led_by_pointer() const noexcept { return pointer_.has_value(); }

  /// Hears the gestures of the table, and the keys.
  /// may_lead         somebody leads the saw; else only the camera is moved
  /// tip_in_world_mm  what the pointer's way is measured at
  Steered hear(Ui& ui, const AreaResponse& area, const Sight& sight, bool may_lead,
               const Vec3& tip_in_world_mm);

 private:
  Point pointer_way(const AreaResponse& area);
  void hear_lift(Ui& ui, const AreaResponse& area);

  HandLift lift_;
  /// Of the last frame, while it led without being caught.
  std::optional<Point> pointer_;
};

}  // namespace hallux::ui

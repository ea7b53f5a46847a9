/// The gestures of the mouse while somebody operates: one table, by which the saw and the camera
/// are moved, and which is what people are told.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

enum class MouseInput : std::uint8_t {
  Move,
  Wheel,
  WheelWithAlt,
  WheelWithControl,
  WheelWithLeft,
  LeftClick,
  LeftDrag,
  /// While it is held.
  Right,
  RightClick,
  MiddleDrag,
  MiddleDragWithShift
};

enum class Gesture : std::uint8_t {
  Lead,
  Push,
  Deepen,
  Zoom,
  Roll,
  SwitchSaw,
  Tilt,
  Lift,
  StayLifted,
  Orbit,
  Pan
};

struct BoundGesture {
  MouseInput input;
  Gesture gesture;
  /// Of what the mouse does and of what that does, as ids of texts.
  std::string_view input_text, gesture_text;
  /// Told at the foot of the picture, too.
  bool is_usual = false;
};

inline constexpr std::array<BoundGesture, 11> bound_gestures{{
    {MouseInput::Move, Gesture::Lead, "mouse.move", "operate.key.move", true},
    {MouseInput::Wheel, Gesture::Push, "mouse.wheel", "operate.key.push", true},
    {MouseInput::LeftClick, Gesture::SwitchSaw, "mouse.left_click", "operate.key.saw", true},
    {MouseInput::LeftDrag, Gesture::Tilt, "mouse.left_drag", "operate.key.turn", true},
    {MouseInput::WheelWithLeft, Gesture::Roll, "mouse.left_wheel", "operate.key.roll"},
    {MouseInput::Right, Gesture::Lift, "mouse.right", "operate.key.lift", true},
    {MouseInput::RightClick, Gesture::StayLifted, "mouse.right_click", "operate.key.lift_stays"},
    {MouseInput::MiddleDrag, Gesture::Orbit, "mouse.middle_drag", "operate.key.orbit", true},
    {MouseInput::MiddleDragWithShift, Gesture::Pan, "mouse.middle_drag_shift", "operate.key.pan"},
    {MouseInput::WheelWithControl, Gesture::Zoom, "mouse.wheel_control", "operate.key.zoom"},
    {MouseInput::WheelWithAlt, Gesture::Deepen, "mouse.wheel_alt", "operate.key.deepen"},
}};

/// How far a gesture went in this frame.
struct GestureAmount {
  /// Of the pointer, logical pixels.
  Point way;
  /// Notches, away from the person.
  double notches = 0.0;
  bool is_done = false;
};

/// What of this input happened in the area, while it has the pointer or the pointer is over it.
/// pointer_way  of the pointer since the last frame, where it led already
GestureAmount amount_of(MouseInput input, const AreaResponse& area, const Modifiers& modifiers,
                        const Point& pointer_way) noexcept;

/// The hand on the saw, or lifted off it: held up for as long as a button is held, or left up until
/// it is set down.
class HandLift {
 public:
  bool is_lifted() const noexcept { return is_held_ || stays_; }
  /// Until it is set down: meanwhile the pointer is free to press what it likes.
  bool stays_lifted() const noexcept { return stays_; }
  /// Once a frame.
  void hear(bool is_held, bool is_toggled) noexcept {
    is_held_ = is_held;
    if (is_toggled) stays_ = !stays_;
  }
  void set_down() noexcept { is_held_ = stays_ = false; }

 private:
  bool is_held_ = false, stays_ = false;
};

}  // namespace hallux::ui

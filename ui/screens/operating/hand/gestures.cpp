#include "ui/screens/operating/hand/gestures.h"

namespace hallux::ui {

namespace {

constexpr std::size_t left = static_cast<std::size_t>(MouseButton::Left),
                      right = static_cast<std::size_t>(MouseButton::Right),
                      middle = static_cast<std::size_t>(MouseButton::Middle);

bool is_any_down(const AreaResponse& area) noexcept {
  return area.is_down[left] || area.is_down[right] || area.is_down[middle];
}

GestureAmount wheel(const AreaResponse& area, bool is_meant) noexcept {
  return {{}, is_meant ? static_cast<double>(area.wheel) : 0.0, is_meant && area.wheel != 0.0F};
}

GestureAmount drag(const AreaResponse& area, std::size_t button, bool is_meant) noexcept {
  const bool is_done = is_meant && area.is_down[button];
  return {is_done ? area.dragged[button] : Point{}, 0.0, is_done};
}

}  // namespace

GestureAmount amount_of(MouseInput input, const AreaResponse& area, const Modifiers& modifiers,
                        const Point& pointer_way) noexcept {
  const bool is_plain = !modifiers.control && !modifiers.alt;
  switch (input) {
    case MouseInput::Move:
      return {is_any_down(area) ? Point{} : pointer_way, 0.0, !is_any_down(area)};
    case MouseInput::Wheel:
      return wheel(area, is_plain && !area.is_down[left]);
    case MouseInput::WheelWithLeft:
      return wheel(area, area.is_down[left]);
    case MouseInput::WheelWithAlt:
      return wheel(area, modifiers.alt && !modifiers.control);
    case MouseInput::WheelWithControl:
      return wheel(area, modifiers.control);
    case MouseInput::LeftClick:
      return {{}, 0.0, area.clicked[left]};
    case MouseInput::LeftDrag:
      return drag(area, left, true);
    case MouseInput::Right:
      return {{}, 0.0, area.is_down[right]};
    case MouseInput::RightClick:
      return {{}, 0.0, area.clicked[right]};
    case MouseInput::MiddleDrag:
      return drag(area, middle, !modifiers.shift);
    case MouseInput::MiddleDragWithShift:
      return drag(area, middle, modifiers.shift);
  }
  return {};
}

}  // namespace hallux::ui

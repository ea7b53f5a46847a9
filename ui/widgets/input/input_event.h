/// What a person did: plain events, as a window, a test or a random walker hands them to the frame.
#pragma once

#include <cstdint>
#include <string>

#include "ui/widgets/look/geometry.h"

namespace hallux::ui {

enum class Key : std::uint8_t {
  None,
  A,
  B,
  C,
  D,
  E,
  F,
  G,
  H,
  I,
  J,
  K,
  L,
  M,
  N,
  O,
  P,
  Q,
  R,
  S,
  T,
  U,
  V,
  W,
  X,
  Y,
  Z,
  Digit0,
  Digit1,
  Digit2,
  Digit3,
  Digit4,
  Digit5,
  Digit6,
  Digit7,
  Digit8,
  Digit9,
  F1,
  F2,
  F3,
  F4,
  F5,
  F6,
  F7,
  F8,
  F9,
  F10,
  F11,
  F12,
  Tab,
  Enter,
  Escape,
  Space,
  Left,
  Right,
  Up,
  Down,
  Home,
  End,
  PageUp,
  PageDown,
  Backspace,
  Delete,
  Plus,
  Minus,
  Comma,
  Period,
  LeftBracket,
  RightBracket,
  Slash,
};

struct Modifiers {
  bool shift = false, control = false, alt = false;

  friend bool operator==(const Modifiers&, const Modifiers&) = default;
};

/// A key with what is held beside it.
struct Chord {
  Key key = Key::None;
  Modifiers modifiers = {};

  friend bool operator==(const Chord&, const Chord&) = default;
};
constexpr Chord with_control(Key key) noexcept { return {key, {.control = true}}; }
constexpr Chord with_shift(Key key) noexcept { return {key, {.shift = true}}; }

enum class MouseButton : std::uint8_t { Left, Right, Middle };
inline constexpr int mouse_button_count = 3;

enum class EventKind : std::uint8_t {
  PointerMoved,
  /// A captured pointer's way: `position` says how far, not where.
  CapturedMoved,
  /// The pointer is no longer over the window.
  PointerLeft,
  ButtonPressed,
  ButtonReleased,
  Wheel,
  /// Also each repeat of a held key.
  KeyPressed,
  KeyReleased,
  /// Text, already with layout and dead keys applied.
  Character,
  /// The window no longer gets keys: every held key counts as released.
  FocusLost,
  /// Files or folders of the desktop, let go over the window.
  FilesDropped,
};

struct InputEvent {
  EventKind kind = EventKind::PointerMoved;
  /// Of the pointer, for all its events; of a captured one it means nothing but its way.
  Point position = {};
  MouseButton button = MouseButton::Left;
  Key key = Key::None;
  /// Held while it happened.
  Modifiers modifiers = {};
  char32_t character = 0;
  /// Notches, positive away from the person.
  float wheel = 0.0F;
  /// The path of the first one that was dropped.
  std::string text = {};
};

}  // namespace hallux::ui

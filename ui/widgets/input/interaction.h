/// What the events of a frame do: presses, focus, edits, wheel and keys, resolved against the
/// content of the frame that the person saw.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/input/event_queue.h"
#include "ui/widgets/input/widget.h"

namespace hallux::ui {

/// How a control was pressed.
enum class PressedBy : std::uint8_t { Nothing, Mouse, Enter, Space };

/// An event for the field that has the focus, in order.
struct FieldEvent {
  /// 0: a key.
  char32_t character = 0;
  Chord chord;
};

struct Interaction {
  struct HeldButton {
    /// Pressed there; empty: not held, or pressed on nothing.
    std::string id;
    bool is_down = false, has_moved = false;
    Point pressed_at;
    /// Of a captured pointer, since it was pressed.
    Point way;
  };
  struct Edit {
    std::string id;
    FieldEvent event;
  };

  /// What happened in the last frame is over; what is held and has the focus stays.
  void forget_frame();
  /// Takes events up to the one that may change the screen.
  /// scale  device pixels of a logical one
  void take_events(EventQueue& queue, const FrameContent& shown, double time_s, float scale);

  /// The next frame shows what this one changed; or events wait for another one.
  bool is_settling = false, has_waiting_events = false;
  /// When anybody last moved, pressed or typed anything.
  double touched_s = 0.0;

  Point pointer;
  bool is_pointer_inside = false;
  /// Since when it lies where it is.
  double pointer_still_since_s = 0.0;
  /// In this frame.
  bool has_pointer_left = false, has_lost_keys = false;
  Modifiers modifiers;
  std::array<HeldButton, mouse_button_count> held;
  /// Since the last frame.
  std::array<Point, mouse_button_count> dragged{};
  /// The area that has captured the pointer: buttons and wheel are its own, wherever the pointer
  /// was. Empty: none.
  std::string capture;
  /// Of the captured pointer, since the last frame.
  Point captured_way;
  /// Ids of controls.
  std::string hovered, pressed, wheel_target;
  /// Areas that a button pressed and let go without being dragged away.
  std::array<std::string, mouse_button_count> clicked_areas;
  double hovered_since_s = 0.0;
  PressedBy pressed_by = PressedBy::Nothing;
  bool is_double = false;
  /// Notches over `wheel_target`.
  float wheel = 0.0F;

  /// What no control took: a shortcut may.
  std::optional<Chord> key;
  /// Of key, in this frame.
  int key_repeats = 0;
  /// key came without a release before it.
  bool is_key_held_on = false;
  /// By a shortcut: the character that the key writes is no text.
  bool is_letter_taken = false;
  std::vector<Edit> edits;
  /// A file or folder dropped on the window that no field took yet.
  std::optional<std::string> dropped;

  std::string focus;
  bool is_ring_shown = false, is_focus_extended = false, has_focus_moved = false;

 private:
  void take_repeats(EventQueue& queue);
  bool apply(const InputEvent& event);
  void move_pointer(Point position);
  void move_captured(Point way);
  bool press_captured(const InputEvent& event);
  bool release_captured(const InputEvent& event);
  bool press_button(const InputEvent& event);
  bool release_button(const InputEvent& event);
  bool press_key(Chord chord);
  bool edit_key(const Widget& field, Chord chord);
  bool press_by_key(const Widget* focused, Chord chord);
  bool move_focus(const Widget* focused, Chord chord);
  /// The second of two quick ones is a double click.
  void note_click(const std::string& id);
  void turn_wheel(const InputEvent& event);

  // While events are taken.
  const FrameContent* shown_ = nullptr;
  double time_s_ = 0.0;
  float scale_ = 1.0F;

  double last_press_s_ = -1.0;
  std::string last_pressed_;
  /// Pressed and not released yet.
  Key held_key_ = Key::None;
};

}  // namespace hallux::ui

// Events against the frame that the person saw.
//
// A frame shows what the last one left, so a press is looked up in the widgets of that frame, and
// the next event waits until the screen has answered. Where a machine is slow, several events meet
// one frame: movements and letters do, a press that may change the screen ends it.
#include "ui/widgets/input/interaction.h"

#include <cmath>
#include <utility>

#include "ui/widgets/input/focus.h"

namespace hallux::ui {
namespace {

constexpr double double_click_s = 0.4;
constexpr float drag_threshold = 4.0F;

bool is_pressable(const Widget& widget) noexcept {
  return widget.role != Role::Field && widget.role != Role::Area && widget.role != Role::Scroll;
}

bool is_arrow(Key key) noexcept {
  return key == Key::Left || key == Key::Right || key == Key::Up || key == Key::Down ||
         key == Key::Home || key == Key::End;
}

// True where the key writes a letter, which belongs to the field and not to a shortcut.
bool writes_letter(Chord chord) noexcept {
  if (chord.modifiers.control || chord.modifiers.alt) return false;
  return (chord.key >= Key::A && chord.key <= Key::Digit9) || chord.key == Key::Space ||
         chord.key >= Key::Plus;
}

bool is_edit_key(Chord chord) noexcept {
  if (chord.modifiers.alt) return false;
  if (chord.modifiers.control &&
      (chord.key == Key::A || chord.key == Key::C || chord.key == Key::X || chord.key == Key::V ||
       chord.key == Key::Z || chord.key == Key::Y))
    return true;
  return is_arrow(chord.key) || chord.key == Key::Backspace || chord.key == Key::Delete;
}

// The window loses keys and pointer by itself, too.
bool is_of_a_hand(EventKind kind) noexcept {
  return kind != EventKind::PointerLeft && kind != EventKind::FocusLost;
}

// What a press meets may depend on what was typed before it: a form's button waits for its fields.
bool meets_what_was_typed(const InputEvent& event) noexcept {
  if (event.kind == EventKind::ButtonPressed || event.kind == EventKind::ButtonReleased)
    return true;
  const Chord chord{event.key, event.modifiers};
  return event.kind == EventKind::KeyPressed && !is_edit_key(chord) && !writes_letter(chord);
}

const Widget* primary_of(const FrameContent& content) {
  for (const Widget& widget : content.widgets)
    if (widget.is_primary && can_be_pressed(content, widget)) return &widget;
  return nullptr;
}

}  // namespace

void Interaction::forget_frame() {
  pressed.clear();
  clicked_areas = {};
  captured_way = {};
  wheel_target.clear();
  pressed_by = PressedBy::Nothing;
  is_double = is_focus_extended = has_focus_moved = false;
  wheel = 0.0F;
  key.reset();
  edits.clear();
  dragged = {};
  has_pointer_left = has_lost_keys = false;
  dropped.reset();
}

// Stops behind the event that may change the screen, and leaves the next frame without events: it
// shows the new screen, which the events after that meet. Stops before an event that meets what is
// typed but not drawn yet.
void Interaction::take_events(EventQueue& queue, const FrameContent& shown, double time_s,
                              float scale) {
  shown_ = &shown;
  time_s_ = time_s;
  scale_ = scale;
  const bool was_settling = std::exchange(is_settling, false);
  while (!was_settling && !is_settling) {
    if (!edits.empty() && !queue.is_empty() && meets_what_was_typed(*queue.oldest())) break;
    const std::optional<InputEvent> event = queue.take();
    if (!event) break;
    if (is_of_a_hand(event->kind)) touched_s = time_s_;
    is_settling = apply(*event);
    if (key) take_repeats(queue);
  }
  has_waiting_events = !queue.is_empty();
  const bool is_somewhere = is_pointer_inside && capture.empty();
  const Widget* under = is_somewhere ? widget_at(*shown_, pointer) : nullptr;
  const std::string id = under == nullptr ? std::string() : under->id;
  if (id != hovered) {
    hovered = id;
    hovered_since_s = time_s_;
  }
}

// A held key repeats faster than a slow machine makes frames: all that came meet this frame, else
// they would go on long after the key was let go.
void Interaction::take_repeats(EventQueue& queue) {
  key_repeats = 1;
  for (const InputEvent* next = queue.oldest(); next != nullptr; next = queue.oldest()) {
    if (next->kind != EventKind::KeyPressed || Chord{next->key, next->modifiers} != *key) return;
    queue.take();
    ++key_repeats;
  }
}

// Returns true where the event may change the screen.
bool Interaction::apply(const InputEvent& event) {
  modifiers = event.modifiers;
  switch (event.kind) {
    case EventKind::PointerMoved:
      move_pointer(event.position);
      return false;
    case EventKind::CapturedMoved:
      move_captured(event.position);
      return false;
    case EventKind::PointerLeft:
      is_pointer_inside = false;
      has_pointer_left = true;
      return false;
    case EventKind::ButtonPressed:
      return press_button(event);
    case EventKind::ButtonReleased:
      return release_button(event);
    case EventKind::Wheel:
      turn_wheel(event);
      return false;
    case EventKind::KeyPressed:
      is_letter_taken = false;
      is_key_held_on = event.key != Key::None && event.key == std::exchange(held_key_, event.key);
      return press_key({event.key, event.modifiers});
    case EventKind::KeyReleased:
      is_letter_taken = false;
      if (event.key == held_key_) held_key_ = Key::None;
      return false;
    case EventKind::Character: {
      if (std::exchange(is_letter_taken, false)) return false;
      const Widget* field = find_widget(*shown_, focus);
      if (field != nullptr && field->role == Role::Field && field->is_enabled)
        edits.push_back({focus, {event.character, {}}});
      return false;
    }
    case EventKind::FilesDropped:
      dropped = event.text;
      return true;
    case EventKind::FocusLost:
      capture.clear();
      held = {};
      modifiers = {};
      has_lost_keys = true;
      held_key_ = Key::None;
      return false;
  }
  return false;
}

void Interaction::move_pointer(Point position) {
  const Point device{position.x / scale_, position.y / scale_};
  if (device != pointer) pointer_still_since_s = time_s_;
  for (std::size_t button = 0; button < held.size(); ++button) {
    HeldButton& own = held[button];
    if (!own.is_down) continue;
    dragged[button].x += device.x - pointer.x;
    dragged[button].y += device.y - pointer.y;
    own.has_moved = own.has_moved || std::hypot(device.x - own.pressed_at.x,
                                                device.y - own.pressed_at.y) > drag_threshold;
  }
  pointer = device;
  is_pointer_inside = true;
}

// The pointer itself stays where it was caught: there it is again once it is free.
void Interaction::move_captured(Point way) {
  const Point device{way.x / scale_, way.y / scale_};
  captured_way.x += device.x;
  captured_way.y += device.y;
  for (std::size_t button = 0; button < held.size(); ++button) {
    HeldButton& own = held[button];
    if (!own.is_down) continue;
    dragged[button].x += device.x;
    dragged[button].y += device.y;
    own.way.x += device.x;
    own.way.y += device.y;
    own.has_moved = own.has_moved || std::hypot(own.way.x, own.way.y) > drag_threshold;
  }
}

bool Interaction::press_captured(const InputEvent& event) {
  held[static_cast<std::size_t>(event.button)] = {capture, true, false, pointer, {}};
  is_ring_shown = false;
  return false;
}

bool Interaction::release_captured(const InputEvent& event) {
  const auto button = static_cast<std::size_t>(event.button);
  const HeldButton was = std::exchange(held[button], {});
  if (was.is_down && was.id == capture && !was.has_moved) clicked_areas[button] = capture;
  return false;
}

bool Interaction::press_button(const InputEvent& event) {
  if (!capture.empty()) return press_captured(event);
  move_pointer(event.position);
  is_ring_shown = false;
  HeldButton& own = held[static_cast<std::size_t>(event.button)];
  const Widget* under = widget_at(*shown_, pointer);
  own = {under == nullptr ? std::string() : under->id, true, false, pointer, {}};
  if (under == nullptr || event.button != MouseButton::Left) return false;
  if (under->role == Role::Area) focus.clear();
  if (can_be_pressed(*shown_, *under)) focus = under->id;
  if (under->role != Role::Field || !under->is_enabled) return false;
  pressed = under->id;
  pressed_by = PressedBy::Mouse;
  is_double = last_pressed_ == under->id && time_s_ - last_press_s_ < double_click_s;
  last_pressed_ = under->id;
  last_press_s_ = time_s_;
  return false;
}

bool Interaction::release_button(const InputEvent& event) {
  if (!capture.empty()) return release_captured(event);
  move_pointer(event.position);
  const auto button = static_cast<std::size_t>(event.button);
  const HeldButton was = std::exchange(held[button], {});
  if (!was.is_down || was.id.empty()) return false;
  const Widget* under = widget_at(*shown_, pointer);
  if (under == nullptr || under->id != was.id || !under->is_enabled) return false;
  if (under->role == Role::Area) {
    if (!was.has_moved) {
      clicked_areas[button] = was.id;
      if (event.button == MouseButton::Left) note_click(was.id);
    }
    return !was.has_moved && event.button == MouseButton::Left;
  }
  if (event.button != MouseButton::Left) return false;
  if (!is_pressable(*under)) return false;
  pressed = was.id;
  pressed_by = PressedBy::Mouse;
  note_click(was.id);
  return true;
}

void Interaction::note_click(const std::string& id) {
  is_double = last_pressed_ == id && time_s_ - last_press_s_ < double_click_s;
  last_pressed_ = is_double ? std::string() : id;
  last_press_s_ = time_s_;
}

void Interaction::turn_wheel(const InputEvent& event) {
  if (capture.empty()) move_pointer(event.position);
  // A button under which the wheel is turned holds for it: letting it go is no click.
  for (HeldButton& own : held) own.has_moved = own.has_moved || own.is_down;
  const Widget* target =
      capture.empty() ? turned_at(*shown_, pointer, event.wheel) : find_widget(*shown_, capture);
  if (target == nullptr) return;
  if (wheel_target != target->id) wheel = 0.0F;
  wheel_target = target->id;
  wheel += event.wheel;
}

bool Interaction::press_key(Chord chord) {
  const Widget* focused = find_widget(*shown_, focus);
  if (focused != nullptr && !can_have_focus(*shown_, *focused)) focused = nullptr;
  if (move_focus(focused, chord)) return false;
  if (focused != nullptr && focused->role == Role::Field && focused->is_enabled) {
    if (edit_key(*focused, chord)) return false;
    if (writes_letter(chord)) return false;
  }
  if (press_by_key(focused, chord)) return true;
  key = chord;
  return true;
}

bool Interaction::edit_key(const Widget& field, Chord chord) {
  const bool is_new_line =
      chord.key == Key::Enter && field.takes_new_line && !chord.modifiers.control;
  if (!is_edit_key(chord) && !is_new_line) return false;
  edits.push_back({field.id, {0, chord}});
  return true;
}

bool Interaction::move_focus(const Widget* focused, Chord chord) {
  std::string next = focus;
  const bool is_tab = chord.key == Key::Tab && !chord.modifiers.control && !chord.modifiers.alt;
  if (is_tab && !chord.modifiers.shift && focused != nullptr && focused->takes_tab &&
      focused->is_enabled) {
    edits.push_back({focus, {0, chord}});
    return true;
  }
  if (is_tab) {
    next = next_in_tab_order(*shown_, focus, chord.modifiers.shift);
  } else if (is_arrow(chord.key) && focused != nullptr && !focused->group.empty() &&
             !chord.modifiers.control) {
    next = next_by_arrow(*shown_, focus, chord.key);
    is_focus_extended = chord.modifiers.shift;
  } else {
    return false;
  }
  is_ring_shown = true;
  has_focus_moved = true;
  focus = next;
  return true;
}

// Space and Enter press what has the ring; in a menu or question also without it. Enter else means
// the primary. What is off has the ring to be read: a press on it is heard by nobody.
bool Interaction::press_by_key(const Widget* focused, Chord chord) {
  if (chord.key != Key::Enter && chord.key != Key::Space) return false;
  const bool steers_focus = is_ring_shown || reachable_layer(*shown_) > Layer::Page;
  const Widget* target =
      focused != nullptr && is_pressable(*focused) && steers_focus ? focused : nullptr;
  if (target == nullptr && chord.key == Key::Enter) target = primary_of(*shown_);
  if (target == nullptr) return false;
  if (!target->is_enabled) return true;
  pressed = target->id;
  pressed_by = chord.key == Key::Enter ? PressedBy::Enter : PressedBy::Space;
  return true;
}

}  // namespace hallux::ui

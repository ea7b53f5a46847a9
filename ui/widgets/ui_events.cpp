// How events become presses, focus and edits: the half of Ui that runs before anything is drawn.
#include <cctype>
#include <cmath>

#include "ui/widgets/input/focus.h"
#include "ui/widgets/ui.h"

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
    if (widget.is_primary && can_have_focus(content, widget)) return &widget;
  return nullptr;
}

}  // namespace

// Stops behind the event that may change the screen, and leaves the next frame without events: it
// shows the new screen, which the events after that meet. Stops before an event that meets what is
// typed but not drawn yet.
void Ui::take_events(EventQueue& queue) {
  const bool was_settling = std::exchange(is_settling_, false);
  while (!was_settling && !is_settling_) {
    if (!edits_.empty() && !queue.is_empty() && meets_what_was_typed(*queue.oldest())) break;
    const std::optional<InputEvent> event = queue.take();
    if (!event) break;
    if (is_of_a_hand(event->kind)) touched_s_ = time_s_;
    is_settling_ = apply(*event);
    if (key_) take_repeats(queue);
  }
  has_waiting_events_ = !queue.is_empty();
  const Widget* under = is_pointer_inside_ ? widget_at(shown_, pointer_) : nullptr;
  const std::string hovered = under == nullptr ? std::string() : under->id;
  if (hovered != hovered_) {
    hovered_ = hovered;
    hovered_since_s_ = time_s_;
  }
}

// A held key repeats faster than a slow machine makes frames: all that came meet this frame, else
// they would go on long after the key was let go.
void Ui::take_repeats(EventQueue& queue) {
  key_repeats_ = 1;
  for (const InputEvent* next = queue.oldest(); next != nullptr; next = queue.oldest()) {
    if (next->kind != EventKind::KeyPressed || Chord{next->key, next->modifiers} != *key_) return;
    queue.take();
    ++key_repeats_;
  }
}

// Returns true where the event may change the screen.
bool Ui::apply(const InputEvent& event) {
  modifiers_ = event.modifiers;
  switch (event.kind) {
    case EventKind::PointerMoved:
      move_pointer(event.position);
      return false;
    case EventKind::PointerLeft:
      is_pointer_inside_ = false;
      has_pointer_left_ = true;
      return false;
    case EventKind::ButtonPressed:
      return press_button(event);
    case EventKind::ButtonReleased:
      return release_button(event);
    case EventKind::Wheel:
      turn_wheel(event);
      return false;
    case EventKind::KeyPressed:
      is_letter_taken_ = false;
      is_key_held_on_ = event.key != Key::None && event.key == std::exchange(held_key_, event.key);
      return press_key({event.key, event.modifiers});
    case EventKind::KeyReleased:
      is_letter_taken_ = false;
      if (event.key == held_key_) held_key_ = Key::None;
      return false;
    case EventKind::Character: {
      if (std::exchange(is_letter_taken_, false)) return false;
      const Widget* field = find_widget(shown_, focus_);
      if (field != nullptr && field->role == Role::Field)
        edits_.push_back({focus_, {event.character, {}}});
      return false;
    }
    case EventKind::FocusLost:
      held_ = {};
      modifiers_ = {};
      has_lost_keys_ = true;
      held_key_ = Key::None;
      return false;
  }
  return false;
}

void Ui::move_pointer(Point position) {
  const Point device{position.x / scale(), position.y / scale()};
  for (std::size_t button = 0; button < held_.size(); ++button) {
    HeldButton& held = held_[button];
    if (!held.is_down) continue;
    dragged_[button].x += device.x - pointer_.x;
    dragged_[button].y += device.y - pointer_.y;
    held.has_moved = held.has_moved || std::hypot(device.x - held.pressed_at.x,
                                                  device.y - held.pressed_at.y) > drag_threshold;
  }
  pointer_ = device;
  is_pointer_inside_ = true;
}

bool Ui::press_button(const InputEvent& event) {
  move_pointer(event.position);
  is_ring_shown_ = false;
  HeldButton& held = held_[static_cast<std::size_t>(event.button)];
  const Widget* under = widget_at(shown_, pointer_);
  held = {under == nullptr ? std::string() : under->id, true, false, pointer_};
  if (under == nullptr || event.button != MouseButton::Left) return false;
  if (under->role == Role::Area) focus_.clear();
  if (can_have_focus(shown_, *under)) focus_ = under->id;
  if (under->role != Role::Field || !under->is_enabled) return false;
  pressed_ = under->id;
  pressed_by_ = PressedBy::Mouse;
  is_double_ = last_pressed_ == under->id && time_s_ - last_press_s_ < double_click_s;
  last_pressed_ = under->id;
  last_press_s_ = time_s_;
  return false;
}

bool Ui::release_button(const InputEvent& event) {
  move_pointer(event.position);
  HeldButton& held = held_[static_cast<std::size_t>(event.button)];
  const HeldButton was = std::exchange(held, {});
  if (!was.is_down || was.id.empty() || event.button != MouseButton::Left) return false;
  const Widget* under = widget_at(shown_, pointer_);
  if (under == nullptr || under->id != was.id || !under->is_enabled) return false;
  if (under->role == Role::Area) {
    if (!was.has_moved) clicked_area_ = was.id;
    return !was.has_moved;
  }
  if (!is_pressable(*under)) return false;
  pressed_ = was.id;
  pressed_by_ = PressedBy::Mouse;
  is_double_ = last_pressed_ == was.id && time_s_ - last_press_s_ < double_click_s;
  last_pressed_ = is_double_ ? std::string() : was.id;
  last_press_s_ = time_s_;
  return true;
}

void Ui::turn_wheel(const InputEvent& event) {
  move_pointer(event.position);
  const Widget* target = scrolled_at(shown_, pointer_);
  if (target == nullptr) return;
  if (wheel_target_ != target->id) wheel_ = 0.0F;
  wheel_target_ = target->id;
  wheel_ += event.wheel;
}

bool Ui::press_key(Chord chord) {
  const Widget* focus = find_widget(shown_, focus_);
  if (focus != nullptr && !can_have_focus(shown_, *focus)) focus = nullptr;
  if (move_focus(focus, chord)) return false;
  if (focus != nullptr && focus->role == Role::Field) {
    if (edit_key(*focus, chord)) return false;
    if (writes_letter(chord)) return false;
  }
  if (press_by_key(focus, chord)) return true;
  key_ = chord;
  return true;
}

bool Ui::edit_key(const Widget& field, Chord chord) {
  const bool is_new_line =
      chord.key == Key::Enter && field.takes_new_line && !chord.modifiers.control;
  if (!is_edit_key(chord) && !is_new_line) return false;
  edits_.push_back({field.id, {0, chord}});
  return true;
}

bool Ui::move_focus(const Widget* focus, Chord chord) {
  std::string next = focus_;
  if (chord.key == Key::Tab && !chord.modifiers.control && !chord.modifiers.alt) {
    next = next_in_tab_order(shown_, focus_, chord.modifiers.shift);
  } else if (is_arrow(chord.key) && focus != nullptr && !focus->group.empty() &&
             !chord.modifiers.control) {
    next = next_by_arrow(shown_, focus_, chord.key);
    is_focus_extended_ = chord.modifiers.shift;
  } else {
    return false;
  }
  is_ring_shown_ = true;
  has_focus_moved_ = true;
  focus_ = next;
  return true;
}

// Space and Enter press what has the ring; in a menu or question also without it. Enter else means
// the primary.
bool Ui::press_by_key(const Widget* focus, Chord chord) {
  if (chord.key != Key::Enter && chord.key != Key::Space) return false;
  const bool steers_focus = is_ring_shown_ || reachable_layer(shown_) > Layer::Page;
  const Widget* target = focus != nullptr && is_pressable(*focus) && steers_focus ? focus : nullptr;
  if (target == nullptr && chord.key == Key::Enter) target = primary_of(shown_);
  if (target == nullptr) return false;
  pressed_ = target->id;
  pressed_by_ = chord.key == Key::Enter ? PressedBy::Enter : PressedBy::Space;
  return true;
}

}  // namespace hallux::ui

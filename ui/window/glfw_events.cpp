// What GLFW calls back, as plain events in the order in which it happened. Nothing is decided here
// but what a key is: letters by what the person's layout prints on them, all else by its place. A
// modifier that is pressed alone becomes a release of no key, so that the frame learns what is held
// without a press that nobody made.
#include "ui/window/glfw_events.h"

#include <GLFW/glfw3.h>

#include <cstring>
#include <utility>

#include "ui/window/pointer_grab.h"

namespace hallux::ui {
namespace {

WindowEvents& events_of(GLFWwindow* window) {
  return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

Modifiers modifiers_of(int bits) {
  return {(bits & GLFW_MOD_SHIFT) != 0, (bits & GLFW_MOD_CONTROL) != 0, (bits & GLFW_MOD_ALT) != 0};
}

Modifiers held_modifiers(GLFWwindow* window) {
  const auto is_down = [&](int left, int right) {
    return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
  };
  return {is_down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
          is_down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
          is_down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
}

Key offset_key(Key first, int by) { return static_cast<Key>(static_cast<int>(first) + by); }

Key key_of_letter(char letter) {
  if (letter >= 'a' && letter <= 'z') return offset_key(Key::A, letter - 'a');
  if (letter >= '0' && letter <= '9') return offset_key(Key::Digit0, letter - '0');
  constexpr char signs[] = "+-,.[]/=";
  constexpr Key keys[] = {Key::Plus,        Key::Minus,        Key::Comma, Key::Period,
                          Key::LeftBracket, Key::RightBracket, Key::Slash, Key::Plus};
  const char* found = std::strchr(signs, letter);
  return letter == '\0' || found == nullptr ? Key::None : keys[found - signs];
}

constexpr std::pair<int, Key> keys_of_codes[] = {
    {GLFW_KEY_TAB, Key::Tab},
    {GLFW_KEY_ENTER, Key::Enter},
    {GLFW_KEY_KP_ENTER, Key::Enter},
    {GLFW_KEY_ESCAPE, Key::Escape},
    {GLFW_KEY_SPACE, Key::Space},
    {GLFW_KEY_LEFT, Key::Left},
    {GLFW_KEY_RIGHT, Key::Right},
    {GLFW_KEY_UP, Key::Up},
    {GLFW_KEY_DOWN, Key::Down},
    {GLFW_KEY_HOME, Key::Home},
    {GLFW_KEY_END, Key::End},
    {GLFW_KEY_PAGE_UP, Key::PageUp},
    {GLFW_KEY_PAGE_DOWN, Key::PageDown},
    {GLFW_KEY_BACKSPACE, Key::Backspace},
    {GLFW_KEY_DELETE, Key::Delete},
    {GLFW_KEY_KP_ADD, Key::Plus},
    {GLFW_KEY_KP_SUBTRACT, Key::Minus},
};

Key key_of_code(int code) {
  if (code >= GLFW_KEY_F1 && code <= GLFW_KEY_F12) return offset_key(Key::F1, code - GLFW_KEY_F1);
  if (code >= GLFW_KEY_KP_0 && code <= GLFW_KEY_KP_9)
    return offset_key(Key::Digit0, code - GLFW_KEY_KP_0);
  for (const auto& [known, key] : keys_of_codes)
    if (known == code) return key;
  return Key::None;
}

// A letter key counts as what is printed on it in the person's layout, not as where it lies.
Key key_of(int code, int scan_code) {
  if (const Key key = key_of_code(code); key != Key::None) return key;
  const char* printed = glfwGetKeyName(code, scan_code);
  if (printed != nullptr && printed[0] != '\0' && printed[1] == '\0')
    if (const Key key = key_of_letter(printed[0]); key != Key::None) return key;
  if (code >= GLFW_KEY_A && code <= GLFW_KEY_Z) return offset_key(Key::A, code - GLFW_KEY_A);
  if (code >= GLFW_KEY_0 && code <= GLFW_KEY_9) return offset_key(Key::Digit0, code - GLFW_KEY_0);
  return Key::None;
}

void hear_key(GLFWwindow* window, int code, int scan_code, int action, int bits) {
  InputEvent event{.kind = action == GLFW_RELEASE ? EventKind::KeyReleased : EventKind::KeyPressed,
                   .key = key_of(code, scan_code),
                   .modifiers = modifiers_of(bits)};
  if (event.key == Key::Plus) event.modifiers.shift = false;  // many keyboards write it with Shift
  // A modifier alone says nothing but that it is held from now on: as a release it moves nothing
  // and tells it.
  if (event.key == Key::None) {
    event.kind = EventKind::KeyReleased;
    event.modifiers = held_modifiers(window);
  }
  events_of(window).queue.push(event);
}

void hear_character(GLFWwindow* window, unsigned character) {
  InputEvent event{
      .kind = EventKind::Character, .modifiers = held_modifiers(window), .character = character};
  events_of(window).queue.push(event);
}

InputEvent pointer_event(GLFWwindow* window, EventKind kind) {
  const WindowEvents& events = events_of(window);
  InputEvent event{.kind = kind,
                   .position = {static_cast<float>(events.pointer_x) * events.pixels_per_unit,
                                static_cast<float>(events.pointer_y) * events.pixels_per_unit},
                   .modifiers = held_modifiers(window)};
  return event;
}

void hear_captured(WindowEvents& events, double x, double y, const Modifiers& held) {
  const float scale = events.pixels_per_unit;
  events.queue.push({.kind = EventKind::CapturedMoved,
                     .position = {static_cast<float>(x - events.pointer_x) * scale,
                                  static_cast<float>(y - events.pointer_y) * scale},
                     .modifiers = held});
  events.pointer_x = x, events.pointer_y = y;
}

void hear_pointer(GLFWwindow* window, double x, double y) {
  WindowEvents& events = events_of(window);
  if (events.is_captured) return hear_captured(events, x, y, held_modifiers(window));
  events.pointer_x = x, events.pointer_y = y;
  events.queue.push(pointer_event(window, EventKind::PointerMoved));
}

/// Sees the pointer that went, untold, to where it once was let go.
void look_where_freed(GLFWwindow* window) {
  WindowEvents& events = events_of(window);
  double x = 0.0, y = 0.0;
  glfwGetCursorPos(window, &x, &y);
  if (!events.is_captured && x == events.freed_x && y == events.freed_y) hear_pointer(window, x, y);
}

void hear_button(GLFWwindow* window, int button, int action, int bits) {
  if (button < 0 || button >= mouse_button_count) return;
  look_where_freed(window);
  InputEvent event = pointer_event(
      window, action == GLFW_PRESS ? EventKind::ButtonPressed : EventKind::ButtonReleased);
  event.button = static_cast<MouseButton>(button);
  event.modifiers = modifiers_of(bits);
  events_of(window).queue.push(event);
}

void hear_wheel(GLFWwindow* window, double, double notches) {
  look_where_freed(window);
  InputEvent event = pointer_event(window, EventKind::Wheel);
  event.wheel = static_cast<float>(notches);
  events_of(window).queue.push(event);
}

void hear_pointer_at_edge(GLFWwindow* window, int is_inside) {
  // Catching it makes some displays say that it left.
  if (events_of(window).is_captured) return;
  events_of(window).queue.push(
      pointer_event(window, is_inside != 0 ? EventKind::PointerMoved : EventKind::PointerLeft));
}

void hear_drop(GLFWwindow* window, int count, const char** paths) {
  if (count < 1) return;
  InputEvent event{.kind = EventKind::FilesDropped, .text = paths[0]};
  events_of(window).queue.push(event);
}

void hear_focus(GLFWwindow* window, int has_focus) {
  if (has_focus != 0) return;
  InputEvent event{.kind = EventKind::FocusLost};
  events_of(window).queue.push(event);
}

}  // namespace

bool set_captured(GLFWwindow* window, WindowEvents& events, bool is_captured) {
  if (is_captured && !grab_pointer(window)) return false;
  glfwGetError(nullptr);
  glfwSetInputMode(window, GLFW_CURSOR, is_captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
  const bool is_done = glfwGetError(nullptr) == GLFW_NO_ERROR;
  events.is_captured = is_captured && is_done;
  glfwGetCursorPos(window, &events.pointer_x, &events.pointer_y);
  if (events.is_captured) return is_done;
  events.freed_x = events.pointer_x, events.freed_y = events.pointer_y;
  events.queue.push(pointer_event(window, EventKind::PointerMoved));
  return is_done;
}

void listen(GLFWwindow* window, WindowEvents& events) {
  glfwSetWindowUserPointer(window, &events);
  glfwGetCursorPos(window, &events.pointer_x, &events.pointer_y);
  glfwSetKeyCallback(window, hear_key);
  glfwSetCharCallback(window, hear_character);
  glfwSetCursorPosCallback(window, hear_pointer);
  glfwSetMouseButtonCallback(window, hear_button);
  glfwSetScrollCallback(window, hear_wheel);
  glfwSetCursorEnterCallback(window, hear_pointer_at_edge);
  glfwSetWindowFocusCallback(window, hear_focus);
  glfwSetDropCallback(window, hear_drop);
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* on) { events_of(on).wants_frame = true; });
  glfwSetFramebufferSizeCallback(
      window, [](GLFWwindow* on, int, int) { events_of(on).wants_frame = true; });
  glfwSetWindowContentScaleCallback(window, [](GLFWwindow* on, float scale, float) {
    events_of(on).content_scale = scale;
    events_of(on).wants_frame = true;
  });
  float down = 1.0F;
  glfwGetWindowContentScale(window, &events.content_scale, &down);
}

}  // namespace hallux::ui
